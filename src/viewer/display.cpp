#include "viewer/display.h"

#include "render/planes.h"
#include "shaders/display.spv.h"
#include "shaders/displaylayout.h"

#include <array>
#include <bit>
#include <cmath>

namespace dsphere::viewer {

const char* const kShowNames[kShowCount] = {"Colour", "Steps (heat map)", "Distance t", "Normal",
                                            "u, v",   "Albedo",           "Residual"};

namespace {

constexpr int kFirstPlane[kShowCount] = {PLANE_R, PLANE_STEPS,    PLANE_T,       PLANE_NX,
                                         PLANE_U, PLANE_ALBEDO_R, PLANE_RESIDUAL};
constexpr int kPlaneCount[kShowCount] = {3, 1, 1, 3, 2, 3, 1};
constexpr float kLeastResidual = 1e-9f, kGreatestResidual = 1e-5f;

std::uint32_t layerOf(std::uint32_t mask, int plane) {
    return std::uint32_t(std::popcount(mask & (planeBit(plane) - 1u)));
}

layout::DisplayParams paramsOf(const LiveFilm& film, Show show, const ToneSettings& tone) {
    const std::uint32_t mask = film.film().mask();
    layout::DisplayParams params = {};
    params.width = film.width();
    params.height = film.height();
    params.layer = layerOf(mask, kFirstPlane[int(show)]);
    params.id_layer = layerOf(mask, PLANE_ID);
    params.gain = std::exp2(tone.exposure) / float(film.samples());
    params.high = tone.most_steps;
    if (show == Show::Residual) {
        params.low = std::log2(kLeastResidual);
        params.high = std::log2(kGreatestResidual);
    }
    return params;
}

}  // namespace

std::uint32_t planesOf(Show show) {
    std::uint32_t first = planeBit(kFirstPlane[int(show)]), mask = 0;
    for (int i = 0; i < kPlaneCount[int(show)]; ++i) mask |= first << i;
    return show == Show::Colour ? mask : mask | planeBit(PLANE_ID);
}

Display::Display(gpu::Device& device) : device_(device), batch_(device, "display") {
    choose(Show::Colour);
}

void Display::choose(Show show) {
    if (pipeline_ && show == show_) return;
    const std::array specialization = {std::uint32_t(show)};
    pipeline_.emplace(device_, kSpirv_display, std::array{gpu::Binding::StorageImage, gpu::Binding::StorageBuffer},
                      specialization, sizeof(layout::DisplayParams), "display");
    show_ = show;
}

void Display::convert(const LiveFilm& film, Show show, const ToneSettings& tone, double near, double far) {
    const gpu::StorageImage& image = film.film().image();
    const std::uint64_t bytes = 4 * std::uint64_t(image.width()) * image.height();
    if (!pixels_ || pixels_->size() < bytes) {
        set_.reset();
        pixels_.emplace(device_, gpu::Buffer::Usage::Storage, gpu::Buffer::Place::Device, bytes, "displayed pixels");
        film_ = nullptr;
    }
    choose(show);
    if (film_ != &film) {
        std::vector<gpu::Resource> resources = {&image, &*pixels_};
        set_.emplace(device_, *pipeline_, resources, "display");
        film_ = &film;
    }
    layout::DisplayParams params = paramsOf(film, show, tone);
    if (show == Show::Distance) {
        params.low = float(near);
        params.high = float(far);
    }
    auto groups = [](int size) { return std::uint32_t((size + DISPLAY_GROUP - 1) / DISPLAY_GROUP); };
    batch_.bind(*pipeline_, *set_);
    batch_.push(params);
    batch_.dispatch(groups(params.width), groups(params.height), 1);
    batch_.submit();
}

}  // namespace dsphere::viewer
