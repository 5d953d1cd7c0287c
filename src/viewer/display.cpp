#include "viewer/display.h"

#include "render/planes.h"
#include "shaders/display.spv.h"

#include <array>
#include <bit>
#include <cmath>

namespace dsphere::viewer {

const char* const kShowNames[kShowCount] = {"Picture", "Height contours", "Slope",  "Graticule",    "Distance",
                                            "Normals", "Map u and v",     "Albedo", "Search steps", "Residual"};

namespace {

/// The planes that a value is made of.
struct ShownPlanes {
    int first, count;
    bool places = false;
};

constexpr ShownPlanes kShown[kShowCount] = {
    {PLANE_R, 3},  {PLANE_NX, 3, true}, {PLANE_NX, 3, true}, {PLANE_R, 3, true}, {PLANE_T, 1},
    {PLANE_NX, 3}, {PLANE_U, 2},        {PLANE_ALBEDO_R, 3}, {PLANE_STEPS, 1},   {PLANE_RESIDUAL, 1}};
constexpr float kLeastResidual = 1e-9f, kGreatestResidual = 1e-5f;

std::uint32_t planesFrom(int first, int count) {
    return (planeBit(first + count) - 1u) & ~(planeBit(first) - 1u);
}

std::uint32_t layerOf(std::uint32_t mask, int plane) {
    return std::uint32_t(std::popcount(mask & (planeBit(plane) - 1u)));
}

layout::DisplayParams paramsOf(const ProgressiveFilm& film, const DisplaySettings& settings) {
    const std::uint32_t mask = film.mask();
    layout::DisplayParams params = {};
    params.width = film.width();
    params.height = film.height();
    params.layer = layerOf(mask, kShown[int(settings.show)].first);
    params.id_layer = layerOf(mask, PLANE_ID);
    params.place_layer = layerOf(mask, PLANE_PX);
    const int samples = film.sumSamples();
    const RowByRow ahead = film.ahead();
    params.gain = std::exp2(settings.tone.exposure) / float(samples);
    params.gain_ahead = std::exp2(settings.tone.exposure) / float(samples + 1);
    params.ahead_x0 = ahead.x0, params.ahead_x1 = ahead.x1;
    params.ahead_y0 = ahead.y0, params.ahead_y1 = ahead.y1;
    params.ahead_x = ahead.x;
    const auto setRange = [&](double low, double high) { params.low = float(low), params.high = float(high); };
    const ShownRange& range = settings.range;
    if (settings.show == Show::Steps) setRange(0.0, double(settings.tone.most_steps));
    if (settings.show == Show::Slope) setRange(0.0, double(settings.tone.most_slope));
    if (settings.show == Show::Distance) setRange(range.near, range.far);
    if (settings.show == Show::Heights) setRange(range.least_height, range.greatest_height);
    if (settings.show == Show::Residual) setRange(std::log2(kLeastResidual), std::log2(kGreatestResidual));
    params.spacing = float(settings.show == Show::Heights ? range.contour_spacing : range.graticule_spacing);
    return params;
}

}  // namespace

std::uint32_t planesOf(Show show) {
    const ShownPlanes& shown = kShown[int(show)];
    std::uint32_t mask = planesFrom(shown.first, shown.count);
    if (show != Show::Colour) mask |= planeBit(PLANE_ID);
    if (shown.places) mask |= planesFrom(PLANE_PX, 3);
    return mask;
}

Display::Display(gpu::Device& device)
    : device_(device),
      batch_(device, "display"),
      world_(device, gpu::Buffer::Usage::Storage, gpu::Buffer::Place::Device, sizeof(layout::DisplayWorld),
             "displayed world") {
    choose(SHOW_COLOUR);
}

void Display::choose(std::uint32_t shown) {
    if (pipeline_ && shown == shown_) return;
    const std::array specialization = {shown};
    using gpu::Binding;
    pipeline_.emplace(device_, kSpirv_display,
                      std::array{Binding::StorageImage, Binding::StorageBuffer, Binding::StorageBuffer}, specialization,
                      sizeof(layout::DisplayParams), "display");
    shown_ = shown;
}

void Display::bind(ProgressiveFilm& film) {
    const gpu::StorageImage& image = film.film().image();
    const std::uint64_t bytes = 4 * std::uint64_t(image.width()) * image.height();
    if (!pixels_ || pixels_->size() < bytes) {
        set_.reset();
        pixels_.emplace(device_, gpu::Buffer::Usage::Storage, gpu::Buffer::Place::Device, bytes, "displayed pixels");
        film_ = nullptr;
    }
    if (film_ == &film) return;
    const std::vector<gpu::Resource> resources = {&image, &*pixels_, &world_};
    set_.emplace(device_, *pipeline_, resources, "display");
    film_ = &film;
}

void Display::convert(ProgressiveFilm& film, const DisplaySettings& settings, const layout::DisplayWorld& world) {
    // film() first: it makes the sums be of as many samples as it can.
    film.film();
    choose(std::uint32_t(settings.show));
    bind(film);
    const layout::DisplayParams params = paramsOf(film, settings);
    auto groups = [](int size) { return std::uint32_t((size + DISPLAY_GROUP - 1) / DISPLAY_GROUP); };
    batch_.write(world_, &world, sizeof(world));
    batch_.bind(*pipeline_, *set_);
    batch_.push(params);
    batch_.dispatch(groups(params.width), groups(params.height), 1);
    batch_.submit();
}

}  // namespace dsphere::viewer
