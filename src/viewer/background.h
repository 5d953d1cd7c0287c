#pragma once

#include "base/error.h"

#include <chrono>
#include <future>
#include <optional>
#include <string>
#include <utility>

namespace dsphere::viewer {

/// One piece of work on a thread of its own, whose result the window's thread takes when it is there.
template <typename Result>
class Background {
  public:
    template <typename Work>
    void start(Work work) {
        future_ = std::async(std::launch::async, std::move(work));
    }
    bool busy() const { return future_.valid(); }
    bool ready() const { return busy() && future_.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }
    /// Once ready(): the result, or throws what the work threw.
    Result take() { return std::exchange(future_, {}).get(); }

  private:
    std::future<Result> future_;
};

}  // namespace dsphere::viewer
