#include "base/hash.h"

#include <cstring>

namespace dsphere {

void Hash::bytes(const void* data, std::size_t count) {
    const auto* from = static_cast<const char*>(data);
    word(count);
    for (; count >= 8; from += 8, count -= 8) {
        std::uint64_t next;
        std::memcpy(&next, from, 8);
        word(next);
    }
    if (count == 0) return;  // `data` may be null then, which memcpy must not be given
    std::uint64_t rest = 0;
    std::memcpy(&rest, from, count);
    word(rest);
}

}  // namespace dsphere
