#pragma once

#include <cstddef>
#include <cstdint>

namespace dsphere {

/// Tells whether two inputs are the same; against accidents, not against malice.
class Hash {
  public:
    void word(std::uint64_t word) {
        state_ = (state_ ^ word) * 0x9e3779b97f4a7c15u;
        state_ ^= state_ >> 32;
    }
    void bytes(const void* data, std::size_t count);
    std::uint64_t value() const { return state_; }

  private:
    std::uint64_t state_ = 0x6a09e667f3bcc908u;
};

}  // namespace dsphere
