#pragma once

namespace dsphere {

/// One function per kind of a variant, for std::visit: a kind without one does not compile.
template <typename... Functions>
struct Overloads : Functions... {
    using Functions::operator()...;
};
template <typename... Functions>
Overloads(Functions...) -> Overloads<Functions...>;

}  // namespace dsphere
