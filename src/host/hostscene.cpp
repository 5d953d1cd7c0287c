#include "host/hostscene.h"

#include "base/parallel.h"

#include <algorithm>
#include <limits>

namespace dsphere::host {

namespace {

constexpr int kEdgeRows = 4;  // a relief's

/// The items, and zeroed ones up to what the shaders declare.
template <typename T>
std::vector<T> padded(const std::vector<T>& items, std::size_t capacity) {
    std::vector<T> result = items;
    result.resize(capacity, T{});
    return result;
}

bool readsSpline(const PackedRelief& relief) {
    return relief.filter == Filter::BSpline || relief.smooth_normals;
}

}  // namespace

HostScene::HostScene(const PackedScene& packed) : packed_(&packed) {
    decodeImages();
    makeSplines();
    setState(packed.state);
}

void HostScene::setPacking(const PackedScene& packed) {
    packed_ = &packed;
    setState(packed.state);
}

void HostScene::setState(const PackedState& state) {
    objects.assign(MAX_OBJECTS, {});
    std::ranges::transform(state.objects, objects.begin(), &PackedObject::data);
    lights = padded(state.lights, MAX_LIGHTS);
    materials = padded(state.materials, 2 * MAX_OBJECTS);
    edges_.clear();
    placeMaps(state);
    placeImages(state);
}

// A level of detail that is not there serves no pixel.
void HostScene::placeMaps(const PackedState& state) {
    layout::MapData none = {};
    none.least_pixel = std::numeric_limits<float>::infinity();
    maps.assign(std::size_t(MAX_OBJECTS * MAX_LEVELS), none);
    for (const PackedRelief& relief : packed_->reliefs)
        for (const auto* row : {&relief.shader.longitude_edges, &relief.shader.colatitude_edges,
                                &relief.shader.longitude_phases, &relief.shader.colatitude_phases})
            edges_.push_back(*row);
    for (std::size_t k = 0; k < state.objects.size(); ++k) {
        int relief = state.objects[k].relief;
        for (std::size_t level = 0; relief >= 0 && level < MAX_LEVELS; ++level) {
            const PackedRelief& from = packed_->reliefs[std::size_t(relief)];
            layout::MapData& data = maps[level * MAX_OBJECTS + k] = from.shader.data;
            data.layer = data.nodes_layer = from.map;
            data.bounds_layer = relief;
            data.edges_y = kEdgeRows * relief;
            relief = from.coarser;
        }
    }
}

void HostScene::decodeImages() {
    images_.push_back({256, codeWords()});
    for (const ImageWords& image : packed_->images) {
        images_.push_back({image.width(), {}});
        for (int j = 0; j < image.height(); ++j) image.appendRow(j, images_.back().values);
    }
}

void HostScene::placeImages(const PackedState& state) {
    for (std::size_t k = 0; k < state.objects.size(); ++k) {
        const PackedObject& object = state.objects[k];
        if (object.image < 0) continue;
        objects[k].image_layer = 1 + object.image;
        objects[k].image_centres_y = int(edges_.size());
        edges_.push_back(object.centres.columns);
        edges_.push_back(object.centres.rows);
    }
    for (layout::LightData& light : lights)
        if (light.kind == LIGHT_IMAGE) light.image_layer = 1 + packed_->light_image;
}

void HostScene::makeSplines() {
    splines_.resize(packed_->nodes.size());
    for (const PackedRelief& relief : packed_->reliefs) {
        const NodeGrid& nodes = *packed_->nodes[std::size_t(relief.map)];
        SplineRows& rows = splines_[std::size_t(relief.map)];
        if (!readsSpline(relief) || nodes.map().ripples || nodes.map().tiled || !rows.empty()) continue;
        const SplineNodes spline(nodes);
        rows.resize(std::size_t(nodes.rows()) + 1);
        parallelFor(rows.size(), [&](std::size_t j) { rows[j] = spline.row(int(j)); });
    }
}

std::uint64_t HostScene::mapBytes() const {
    std::uint64_t bytes = 0;
    for (const auto& nodes : packed_->nodes)
        if (!nodes->map().ripples) bytes += sizeof(float) * std::uint64_t(nodes->width()) * (nodes->rows() + 1u);
    for (const PackedRelief& relief : packed_->reliefs) bytes += sizeof(float) * relief.bounds.squared.size();
    for (const auto& row : edges_) bytes += sizeof(layout::vec4) * row.size();
    for (const SplineRows& rows : splines_)
        for (const auto& row : rows) bytes += sizeof(SplineNodes::Node) * row.size();
    return bytes;
}

std::uint64_t HostScene::imageBytes() const {
    std::uint64_t bytes = 0;
    if (images_.size() == 1) return bytes;
    for (const Words& image : images_) bytes += sizeof(std::uint32_t) * image.values.size();
    return bytes;
}

}  // namespace dsphere::host
