#include "tests/shaders/cpp_shaders.h"

namespace dsphere::test {

thread_local const Resources* current_resources = nullptr;

}  // namespace dsphere::test
