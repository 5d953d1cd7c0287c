#include "bench/embree.h"

#include "base/error.h"
#include "base/parallel.h"
#include "bench/contender.h"
#include "bench/pixelorder.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cassert>
#include <cstring>
#include <limits>

namespace dsphere::bench {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr int kGridCells = 64;              // a side of one RTCGrid; even, for Embree cuts grids into 2x2 cells
constexpr std::size_t kPacketsAtOnce = 64;  // a task's

bool countBytes(std::atomic<std::int64_t>& bytes, std::atomic<std::int64_t>& peak, std::int64_t change) {
    const std::int64_t now = bytes += change;
    std::int64_t before = peak;
    while (now > before && !peak.compare_exchange_weak(before, now)) {
    }
    return true;
}

std::vector<RTCGrid> gridsOf(const MeshLattice& lattice) {
    std::vector<RTCGrid> grids;
    for (int j = 0; j + 1 < lattice.rows(); j += kGridCells)
        for (int i = 0; i + 1 < lattice.columns(); i += kGridCells)
            grids.push_back({unsigned(j * lattice.columns() + i), unsigned(lattice.columns()),
                             static_cast<unsigned short>(std::min(kGridCells + 1, lattice.columns() - i)),
                             static_cast<unsigned short>(std::min(kGridCells + 1, lattice.rows() - j))});
    return grids;
}

void loadPacket(RTCRay16& packet, const RaySet& rays, std::size_t first) {
    constexpr std::size_t kBytes = kPacketSize * sizeof(float);
    std::memcpy(packet.org_x, &rays.x[first], kBytes);
    std::memcpy(packet.org_y, &rays.y[first], kBytes);
    std::memcpy(packet.org_z, &rays.z[first], kBytes);
    std::memcpy(packet.dir_x, &rays.dx[first], kBytes);
    std::memcpy(packet.dir_y, &rays.dy[first], kBytes);
    std::memcpy(packet.dir_z, &rays.dz[first], kBytes);
    for (int lane = 0; lane < kPacketSize; ++lane) {
        packet.tnear[lane] = packet.time[lane] = 0.0f;
        packet.tfar[lane] = kInfinity;
        packet.mask[lane] = ~0u;
        packet.flags[lane] = 0;
    }
}

alignas(64) const int kAllLanes[kPacketSize] = {-1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1};

/// Calls trace(first ray) for every packet, on all cores.
template <typename Trace>
void forPackets(const RaySet& rays, Trace trace) {
    assert(rays.size() % kPacketSize == 0);
    const std::size_t packets = rays.size() / kPacketSize;
    parallelFor((packets + kPacketsAtOnce - 1) / kPacketsAtOnce, [&](std::size_t task) {
        const std::size_t end = std::min((task + 1) * kPacketsAtOnce, packets);
        for (std::size_t packet = task * kPacketsAtOnce; packet < end; ++packet) trace(packet * kPacketSize);
    });
}

}  // namespace

void RaySet::add(const dvec3& origin, const dvec3& direction) {
    x.push_back(float(origin.x));
    y.push_back(float(origin.y));
    z.push_back(float(origin.z));
    dx.push_back(float(direction.x));
    dy.push_back(float(direction.y));
    dz.push_back(float(direction.z));
}

void RaySet::fillPackets() {
    if (x.empty()) return;
    const std::size_t full = (size() + kPacketSize - 1) / kPacketSize * kPacketSize;
    for (std::vector<float>* values : {&x, &y, &z, &dx, &dy, &dz}) values->resize(full, values->back());
}

void EmbreeScene::Release::operator()(RTCDeviceTy* device) const {
    rtcReleaseDevice(device);
}
void EmbreeScene::Release::operator()(RTCSceneTy* scene) const {
    rtcReleaseScene(scene);
}

void EmbreeScene::checkDevice(const char* call) const {
    const RTCError error = rtcGetDeviceError(device_.get());
    if (error == RTC_ERROR_OUT_OF_MEMORY) throwFailure("Embree: {}: out of memory", call);
    if (error != RTC_ERROR_NONE) throwFailure("Embree: {}: error {}", call, int(error));
}

EmbreeScene::EmbreeScene(const NodeGrid& nodes, double base, double scale, double spacing, MeshKind kind)
    : device_(rtcNewDevice(nullptr)) {
    if (!device_) throwFailure("Embree: no device: error {}", int(rtcGetDeviceError(nullptr)));
    rtcSetDeviceMemoryMonitorFunction(
        device_.get(),
        [](void* self, ssize_t change, bool) {
            auto& scene = *static_cast<EmbreeScene*>(self);
            return countBytes(scene.bytes_, scene.peak_bytes_, change);
        },
        this);
    scene_.reset(rtcNewScene(device_.get()));
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);

    const MeshLattice lattice = meshLattice(nodes, spacing);
    const bool grid = kind == MeshKind::Grid;
    RTCGeometry geometry = rtcNewGeometry(device_.get(), grid ? RTC_GEOMETRY_TYPE_GRID : RTC_GEOMETRY_TYPE_TRIANGLE);
    void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3),
                                             lattice.vertexCount());
    checkDevice("rtcSetNewGeometryBuffer");
    placeVertices(nodes, lattice, base, scale, static_cast<glm::vec3*>(vertices));
    const std::size_t item = grid ? sizeof(RTCGrid) : 3 * sizeof(std::uint32_t);
    auto fill = [&](const auto& items, RTCBufferType type, RTCFormat format) {
        const std::size_t bytes = items.size() * sizeof(items[0]);
        void* target = rtcSetNewGeometryBuffer(geometry, type, 0, format, item, bytes / item);
        checkDevice("rtcSetNewGeometryBuffer");
        std::memcpy(target, items.data(), bytes);
    };
    if (grid)
        fill(gridsOf(lattice), RTC_BUFFER_TYPE_GRID, RTC_FORMAT_GRID);
    else
        fill(meshTriangles(lattice), RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_.get());
    checkDevice("rtcCommitScene");
}

void EmbreeScene::intersect(const RaySet& rays, std::span<float> t, glm::vec3* normals) const {
    forPackets(rays, [&](std::size_t first) {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        RTCRayHit16 packet;
        loadPacket(packet.ray, rays, first);
        for (int lane = 0; lane < kPacketSize; ++lane)
            packet.hit.geomID[lane] = packet.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect16(kAllLanes, scene_.get(), &context, &packet);
        std::memcpy(&t[first], packet.ray.tfar, sizeof(packet.ray.tfar));
        for (std::size_t lane = 0; normals && lane < std::size_t(kPacketSize); ++lane)
            normals[first + lane] = {packet.hit.Ng_x[lane], packet.hit.Ng_y[lane], packet.hit.Ng_z[lane]};
    });
}

void EmbreeScene::occluded(const RaySet& rays, std::span<float> t) const {
    forPackets(rays, [&](std::size_t first) {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        RTCRay16 packet;
        loadPacket(packet, rays, first);
        rtcOccluded16(kAllLanes, scene_.get(), &context, &packet);
        std::memcpy(&t[first], packet.tfar, sizeof(packet.tfar));
    });
}

bool haveEmbree() {
    return true;
}

std::string embreeVersion() {
    return RTC_VERSION_STRING;
}

}  // namespace dsphere::bench
