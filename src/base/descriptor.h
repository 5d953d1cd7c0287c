#pragma once

#include <unistd.h>

namespace dsphere {

/// A file descriptor, closed at the end of its life. A negative one, of an open() that failed, is nothing to close.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0) close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int number() const { return number_; }

  private:
    int number_;
};

}  // namespace dsphere
