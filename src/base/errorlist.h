#pragma once

#include "base/error.h"

#include <string>
#include <vector>

namespace dsphere {

/// Errors that are gathered so that one run tells all of them: at most limits::kReportedErrors.
class ErrorList {
  public:
    /// Beyond the greatest number the message is dropped, and the list says at its end that more were left out.
    void add(std::string message);

    bool empty() const { return messages_.empty(); }
    bool overflows() const { return more_; }
    std::size_t size() const { return messages_.size(); }

    /// Throws Error (InvalidInput) whose message has one line for each, in the order of add().
    void throwIfAny() const;

  private:
    std::vector<std::string> messages_;
    bool more_ = false;
};

}  // namespace dsphere
