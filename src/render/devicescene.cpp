#include "render/devicescene.h"

#include "base/error.h"
#include "base/parallel.h"
#include "gpu/device.h"
#include "surface/spline.h"

#include <algorithm>

namespace dsphere {

namespace {

/// Stacks rectangles of one width into layers of one height.
struct Stack {
    int width = 1, height = 1, layers = 1;
    int limit = 1;  ///< greatest height
    int next_y = 0;

    struct Place {
        int y, layer;
    };

    Place add(int w, int h) {
        if (next_y + h > limit) {
            ++layers;
            next_y = 0;
        }
        Place place{next_y, layers - 1};
        next_y += h;
        width = std::max(width, w);
        height = std::max(height, next_y);
        return place;
    }
};

/// A buffer of `capacity` items, which the shader declares, the first of them given.
template <typename T>
gpu::Buffer makeBuffer(gpu::Device& device, gpu::Buffer::Usage usage, const std::vector<T>& items, std::size_t capacity,
                       const char* name) {
    gpu::Buffer buffer(device, usage, gpu::Buffer::Place::Device, capacity * sizeof(T), name);
    if (!items.empty()) buffer.upload(0, items.size() * sizeof(T), items.data());
    return buffer;
}

gpu::StorageImage makeImage(gpu::Device& device, gpu::Format format, const Stack& stack, const char* name) {
    return gpu::StorageImage(device, format, std::uint32_t(stack.width), std::uint32_t(stack.height),
                             std::uint32_t(stack.layers), name);
}

// A row at a time would be one submission a row; a few megabytes at a time keeps both count and memory low.
void uploadNodes(gpu::StorageImage& image, const NodeGrid& nodes, Stack::Place place) {
    std::size_t width = std::size_t(nodes.width());
    int rows_at_once = std::max(1, int((4u << 20) / (width * sizeof(float))));
    std::vector<float> chunk;
    for (int first = 0; first <= nodes.rows(); first += rows_at_once) {
        int count = std::min(rows_at_once, nodes.rows() + 1 - first);
        chunk.resize(width * std::size_t(count));
        for (int j = 0; j < count; ++j)
            std::copy_n(nodes.row(first + j), width, chunk.begin() + std::ptrdiff_t(width) * j);
        image.upload(std::uint32_t(place.layer), 0, std::uint32_t(place.y + first), std::uint32_t(width),
                     std::uint32_t(count), chunk.data());
    }
}

// The same of what a spline has at the nodes.
void uploadSpline(gpu::StorageImage& image, const NodeGrid& nodes, Stack::Place place) {
    const SplineNodes spline(nodes);
    int width = nodes.width(), rows_at_once = std::max(1, (1 << 20) / width);
    for (int first = 0; first <= nodes.rows(); first += rows_at_once) {
        int count = std::min(rows_at_once, nodes.rows() + 1 - first);
        std::vector<SplineNodes::Node> chunk(std::size_t(width) * std::size_t(count));
        parallelFor(std::size_t(count), [&](std::size_t j) {
            std::ranges::copy(spline.row(first + int(j)), chunk.begin() + std::ptrdiff_t(width) * std::ptrdiff_t(j));
        });
        image.upload(std::uint32_t(place.layer), 0, std::uint32_t(place.y + first), std::uint32_t(width),
                     std::uint32_t(count), chunk.data());
    }
}

/// What the reliefs of a map read of it.
struct MapUse {
    bool heights = false, spline = false;
};

MapUse useOf(const PackedScene& packed, std::size_t map) {
    MapUse use;
    for (const PackedRelief& relief : packed.reliefs) {
        if (std::size_t(relief.map) != map || packed.nodes[map]->map().ripples) continue;
        use.heights = use.heights || relief.filter == Filter::Bilinear;
        use.spline = use.spline || relief.filter == Filter::BSpline || relief.smooth_normals;
    }
    return use;
}

// A few megabytes at a time, as nodes.
void uploadImage(gpu::StorageImage& image, const ImageWords& source, Stack::Place place) {
    int rows_at_once = std::max(1, (1 << 20) / source.width());
    std::vector<std::uint32_t> words;
    for (int first = 0; first < source.height(); first += rows_at_once) {
        int count = std::min(rows_at_once, source.height() - first);
        words.clear();
        for (int j = first; j < first + count; ++j) source.appendRow(j, words);
        image.upload(std::uint32_t(place.layer), 0, std::uint32_t(place.y + first), std::uint32_t(source.width()),
                     std::uint32_t(count), words.data());
    }
}

}  // namespace

struct DeviceScene::Layout {
    Stack heights, bounds, edges, images, nodes;
    std::vector<MapUse> uses;  ///< one a map, as the places of its heights and of its spline
    std::vector<Stack::Place> height_places, node_places, bound_places, image_places;
    std::vector<int> centre_rows;       ///< in the edges, one an object
    std::vector<layout::MapData> maps;  ///< one a relief

    std::vector<layout::MapData> ofObjects(const PackedScene& packed) const {
        std::vector<layout::MapData> result;
        for (int relief : packed.relief_of_object)
            result.push_back(relief < 0 ? layout::MapData{} : maps[std::size_t(relief)]);
        return result;
    }

    std::vector<layout::ObjectData> placedObjects(const PackedScene& packed) const {
        std::vector<layout::ObjectData> result = packed.objects;
        for (std::size_t i = 0; i < result.size(); ++i) {
            if (packed.image_of_object[i] < 0) continue;
            Stack::Place place = image_places[std::size_t(packed.image_of_object[i])];
            result[i].image_y = place.y;
            result[i].image_layer = place.layer;
            result[i].image_centres_y = centre_rows[i];
        }
        return result;
    }

    void placeImages(const gpu::Device& device, const PackedScene& packed) {
        if (!packed.images.empty()) images.add(256, 1);  // the codes' light
        for (const ImageWords& image : packed.images) {
            if (image.width() > images.limit || image.height() > images.limit)
                throwInvalid("{}: takes an image of {}x{}, but those of {} end at {}x{}", image.path(), image.width(),
                             image.height(), device.info().name, images.limit, images.limit);
            image_places.push_back(images.add(image.width(), image.height()));
        }
        for (const PackedCentres& centres : packed.centres) {
            int width = int(std::max(centres.columns.size(), centres.rows.size()));
            centre_rows.push_back(width > 0 ? edges.add(width, 2).y : 0);
        }
    }

    Layout(const gpu::Device& device, const PackedScene& packed) {
        int limit = int(device.limits().max_image_dimension_2d);
        heights.limit = bounds.limit = edges.limit = images.limit = limit;
        nodes.limit = limit;
        for (std::size_t i = 0; i < packed.nodes.size(); ++i) {
            const NodeGrid& grid = *packed.nodes[i];
            if (grid.width() > limit || grid.rows() + 1 > limit)
                throwInvalid("{}: a map of {}x{} texels takes an image of {}x{}, but those of {} end at {}x{}",
                             grid.map().path, grid.map().width, grid.map().height, grid.width(), grid.rows() + 1,
                             device.info().name, limit, limit);
            uses.push_back(useOf(packed, i));
            height_places.push_back(uses[i].heights ? heights.add(grid.width(), grid.rows() + 1) : Stack::Place{0, 0});
            node_places.push_back(uses[i].spline ? nodes.add(grid.width(), grid.rows() + 1) : Stack::Place{0, 0});
        }
        for (const PackedRelief& relief : packed.reliefs) {
            layout::MapData data = relief.shader.data;
            Stack::Place height_place = height_places[std::size_t(relief.map)];
            data.heights_y = height_place.y;
            data.layer = height_place.layer;
            data.nodes_y = node_places[std::size_t(relief.map)].y;
            data.nodes_layer = node_places[std::size_t(relief.map)].layer;
            bound_places.push_back(bounds.add(relief.bounds.side, relief.bounds.imageHeight()));
            data.bounds_y = bound_places.back().y;
            data.bounds_layer = bound_places.back().layer;
            data.edges_y = edges.add(std::max(data.width, data.rows), relief.shader.longitude_phases.empty() ? 2 : 4).y;
            maps.push_back(data);
        }
        placeImages(device, packed);
    }
};

DeviceScene::DeviceScene(gpu::Device& device, const PackedScene& packed)
    : DeviceScene(device, packed, Layout(device, packed)) {}

DeviceScene::DeviceScene(gpu::Device& device, const PackedScene& packed, const Layout& layout)
    : objects_(makeBuffer(device, gpu::Buffer::Usage::Uniform, layout.placedObjects(packed), MAX_OBJECTS, "objects")),
      maps_(makeBuffer(device, gpu::Buffer::Usage::Uniform, layout.ofObjects(packed), MAX_OBJECTS, "maps")),
      lights_(makeBuffer(device, gpu::Buffer::Usage::Uniform, packed.lights, MAX_LIGHTS, "lights")),
      ramps_(makeBuffer(device, gpu::Buffer::Usage::Storage, packed.ramp_points, packed.ramp_points.size(), "ramps")),
      heights_(makeImage(device, gpu::Format::R32Float, layout.heights, "heights")),
      bounds_(makeImage(device, gpu::Format::R32Float, layout.bounds, "bounds")),
      edges_(makeImage(device, gpu::Format::Rgba32Float, layout.edges, "edges")),
      images_(makeImage(device, gpu::Format::R32Uint, layout.images, "images")),
      nodes_(makeImage(device, gpu::Format::Rgba32Float, layout.nodes, "nodes")) {
    for (std::size_t i = 0; i < packed.nodes.size(); ++i) {
        if (layout.uses[i].heights) uploadNodes(heights_, *packed.nodes[i], layout.height_places[i]);
        if (layout.uses[i].spline) uploadSpline(nodes_, *packed.nodes[i], layout.node_places[i]);
    }
    auto uploadEdges = [&](int y, const std::vector<layout::vec4>& edges) {
        edges_.upload(0, 0, std::uint32_t(y), std::uint32_t(edges.size()), 1, edges.data());
    };
    for (std::size_t i = 0; i < packed.reliefs.size(); ++i) {
        const PackedRelief& relief = packed.reliefs[i];
        Stack::Place place = layout.bound_places[i];
        bounds_.upload(std::uint32_t(place.layer), 0, std::uint32_t(place.y), std::uint32_t(relief.bounds.side),
                       std::uint32_t(relief.bounds.imageHeight()), relief.bounds.squared.data());
        uploadEdges(layout.maps[i].edges_y, relief.shader.longitude_edges);
        uploadEdges(layout.maps[i].edges_y + 1, relief.shader.colatitude_edges);
        if (relief.shader.longitude_phases.empty()) continue;
        uploadEdges(layout.maps[i].edges_y + 2, relief.shader.longitude_phases);
        uploadEdges(layout.maps[i].edges_y + 3, relief.shader.colatitude_phases);
    }
    for (std::size_t i = 0; i < packed.centres.size(); ++i) {
        if (packed.image_of_object[i] < 0) continue;
        uploadEdges(layout.centre_rows[i], packed.centres[i].columns);
        uploadEdges(layout.centre_rows[i] + 1, packed.centres[i].rows);
    }
    if (!packed.images.empty()) images_.upload(0, 0, 0, 256, 1, codeWords().data());
    for (std::size_t i = 0; i < packed.images.size(); ++i)
        uploadImage(images_, packed.images[i], layout.image_places[i]);
    if (!packed.images.empty())
        image_bytes_ =
            std::uint64_t(images_.width()) * images_.height() * images_.layers() * texelBytes(images_.format());
    for (const gpu::StorageImage* image : {&heights_, &bounds_, &edges_, &nodes_})
        map_bytes_ += std::uint64_t(image->width()) * image->height() * image->layers() * texelBytes(image->format());
}

void DeviceScene::updateObjects(const PackedScene& packed) {
    objects_.upload(0, packed.objects.size() * sizeof(packed.objects[0]), packed.objects.data());
}

std::vector<gpu::Resource> DeviceScene::resources() const {
    return {&objects_, &maps_, &lights_, &ramps_, &heights_, &bounds_, &edges_, &images_, &nodes_};
}

}  // namespace dsphere
