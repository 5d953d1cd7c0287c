// In place of the mesh peers where the build has no Embree.

#include "bench/contender.h"

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

}  // namespace dsphere::bench
