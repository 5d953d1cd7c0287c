// In place of the mesh peers where the build has no Embree.

#include "base/error.h"
#include "bench/contender.h"
#include "bench/sidebyside.h"

namespace dsphere::bench {

bool haveEmbree() {
    return false;
}

std::string embreeVersion() {
    return "";
}

std::unique_ptr<MeshScene> makeMeshScene(const Workload&, const Method&) {
    return nullptr;
}

SideBySide drawSideBySide(gpu::Device&, const Workload&) {
    throw Error(ExitCode::Failure, "a mesh to set beside needs a build with Embree");
}

}  // namespace dsphere::bench
