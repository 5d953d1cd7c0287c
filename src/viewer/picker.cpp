#include "viewer/picker.h"

#include "render/planes.h"

namespace dsphere::viewer {

namespace {

constexpr std::uint32_t kPlanes =
    planeBit(PLANE_T) | planeBit(PLANE_PX) | planeBit(PLANE_PY) | planeBit(PLANE_PZ) | planeBit(PLANE_ID);

}  // namespace

Picker::Picker(gpu::Device& device, Renderer& renderer)
    : renderer_(renderer),
      film_(device, 1, 1, kPlanes),
      tracer_(device, renderer.pipelines(Marcher::Exact, kPlanes), renderer.deviceScene(), film_.image()) {}

std::optional<Pick> Picker::at(int x, int y) {
    const Box& crop = renderer_.crop();
    if (x < 0 || y < 0 || x >= crop.width() || y >= crop.height()) return {};
    const layout::RenderParams pixel = {0, 0, 1, 1, crop.x0 + x, crop.y0 + y, -1, 0};
    tracer_.run({&pixel, 1});
    Image image = film_.read({0, 0, 1, 1}, {0, 0, 1, 1});
    std::uint32_t id = image.at("id").uints()[0];
    if (id == 0) return {};
    auto value = [&](const char* name) { return double(image.at(name).floats()[0]); };
    return Pick{dvec3(value("P.X"), value("P.Y"), value("P.Z")), value("t"), int(id) - 1};
}

}  // namespace dsphere::viewer
