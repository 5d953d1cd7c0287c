#include "render/devicescene.h"

#include "base/error.h"
#include "base/parallel.h"
#include "gpu/device.h"
#include "gpu/result.h"
#include "surface/spline.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace dsphere {

namespace {

/// Stacks rectangles of one width into layers of one height; narrow ones may stand side by side.
struct Stack {
    int width = 1, height = 1, layers = 1;
    int limit = 1;  ///< greatest height
    int next_y = 0;
    int shelf_x = 0, shelf_y = 0;  ///< where the last rectangle has room beside it

    struct Place {
        int y, layer, x = 0;
    };

    Place add(int w, int h) {
        if (next_y + h > limit) {
            ++layers;
            next_y = 0;
        }
        Place place{next_y, layers - 1};
        shelf_x = w;
        shelf_y = next_y;
        next_y += h;
        width = std::max(width, w);
        height = std::max(height, next_y);
        return place;
    }

    /// Beside the last rectangle where it fits, else as add().
    Place addBeside(int w, int h) {
        if (shelf_x == 0 || shelf_x + w > width || shelf_y + h > next_y) return add(w, h);
        Place place{shelf_y, layers - 1, shelf_x};
        shelf_x += w;
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

void uploadNodes(gpu::StorageImage& image, const NodeGrid& nodes, Stack::Place place) {
    std::size_t row_bytes = std::size_t(nodes.width()) * sizeof(float);
    image.uploadRows(std::uint32_t(place.layer), std::uint32_t(place.x), std::uint32_t(place.y),
                     std::uint32_t(nodes.width()), std::uint32_t(nodes.rows() + 1),
                     [&](std::uint32_t first, std::uint32_t count, std::byte* target) {
                         for (std::uint32_t j = 0; j < count; ++j)
                             std::memcpy(target + j * row_bytes, nodes.row(int(first + j)), row_bytes);
                     });
}

// Uploads what a spline has at the nodes: value, slopes and twist.
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
        const Heightmap& of = packed.nodes[map]->map();
        if (std::size_t(relief.map) != map || of.ripples || of.tiled) continue;
        use.heights = use.heights || relief.filter == Filter::Bilinear;
        use.spline = use.spline || relief.filter == Filter::BSpline || relief.smooth_normals;
    }
    return use;
}

// appendRow() makes each row anew, so they are not made before there is room for them.
void uploadImage(gpu::StorageImage& image, const ImageWords& source, Stack::Place place) {
    std::vector<std::uint32_t> words;
    image.uploadRows(std::uint32_t(place.layer), 0, std::uint32_t(place.y), std::uint32_t(source.width()),
                     std::uint32_t(source.height()), [&](std::uint32_t first, std::uint32_t count, std::byte* target) {
                         words.clear();
                         for (std::uint32_t j = 0; j < count; ++j) source.appendRow(int(first + j), words);
                         std::memcpy(target, words.data(), words.size() * sizeof(words[0]));
                     });
}

}  // namespace

struct DeviceScene::Layout {
    Stack heights, bounds, edges, images, nodes;
    std::vector<MapUse> uses;  ///< one a map, as the places of its heights and of its spline
    std::vector<Stack::Place> height_places, node_places, bound_places, image_places;
    std::vector<int> centre_rows;       ///< in the edges, one an object
    int light_image = -1;               ///< PackedScene's
    std::vector<layout::MapData> maps;  ///< one a relief
    bool long_edges;                    ///< see addEdges

    /// All levels of detail; one that is not there serves no pixel.
    std::vector<layout::MapData> ofObjects(const PackedScene& packed) const {
        layout::MapData none = {};
        none.least_pixel = std::numeric_limits<float>::infinity();
        std::vector<layout::MapData> result(std::size_t(MAX_OBJECTS * MAX_LEVELS), none);
        for (std::size_t k = 0; k < packed.state.objects.size(); ++k) {
            int relief = packed.state.objects[k].relief;
            for (std::size_t level = 0; relief >= 0 && level < MAX_LEVELS; ++level) {
                const PackedRelief& from = packed.reliefs[std::size_t(relief)];
                layout::MapData& data = result[level * MAX_OBJECTS + k] = maps[std::size_t(relief)];
                data.least_pixel = from.shader.data.least_pixel;  // changes with the scale
                relief = from.coarser;
            }
        }
        return result;
    }

    std::vector<layout::ObjectData> placedObjects(const PackedState& state) const {
        std::vector<layout::ObjectData> result;
        for (std::size_t i = 0; i < state.objects.size(); ++i) {
            const PackedObject& object = state.objects[i];
            result.push_back(object.data);
            if (object.image < 0) continue;
            Stack::Place place = image_places[std::size_t(object.image)];
            result[i].image_y = place.y;
            result[i].image_layer = place.layer;
            result[i].image_centres_y = centre_rows[i];
        }
        return result;
    }

    std::vector<layout::LightData> placedLights(const PackedState& state) const {
        std::vector<layout::LightData> result = state.lights;
        for (layout::LightData& light : result) {
            if (light.kind != LIGHT_IMAGE) continue;
            const Stack::Place place = image_places[std::size_t(light_image)];
            light.image_y = place.y;
            light.image_layer = place.layer;
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
        light_image = packed.light_image;
        for (const PackedObject& object : packed.state.objects) {
            int width = int(std::max(object.centres.columns.size(), object.centres.rows.size()));
            centre_rows.push_back(width > 0 ? addEdges(width, 2) : 0);
        }
    }

    /// Of `count` tables as long as `width`. With maps in tiles they may be longer than an image is wide: see
    /// EDGE_ROWS.
    int addEdges(int width, int count) {
        if (!long_edges) return edges.add(width, count).y;
        return edges.add(std::min(width, EDGE_COLUMNS), EDGE_ROWS * ((width + EDGE_COLUMNS - 1) / EDGE_COLUMNS)).y;
    }

    Layout(const gpu::Device& device, const PackedScene& packed, const TilePool& tiles) : long_edges(!tiles.empty()) {
        int limit = int(device.limits().max_image_dimension_2d);
        heights.limit = bounds.limit = edges.limit = images.limit = limit;
        nodes.limit = limit;
        for (std::size_t i = 0; i < packed.nodes.size(); ++i) {
            const NodeGrid& grid = *packed.nodes[i];
            if (!grid.map().tiled && (grid.width() > limit || grid.rows() + 1 > limit))
                throwInvalid("{}: a map of {}x{} texels takes an image of {}x{}, but those of {} end at {}x{}",
                             grid.map().path, grid.map().width, grid.map().height, grid.width(), grid.rows() + 1,
                             device.info().name, limit, limit);
            uses.push_back(useOf(packed, i));
            // The maps' own heights start at the image's left edge: see heightAt in lookups.glsl.
            const bool is_level = i >= packed.nodes.size() - packed.halves.size();
            Stack::Place place{0, 0};
            if (uses[i].heights)
                place = is_level ? heights.addBeside(grid.width(), grid.rows() + 1)
                                 : heights.add(grid.width(), grid.rows() + 1);
            height_places.push_back(place);
            node_places.push_back(uses[i].spline ? nodes.add(grid.width(), grid.rows() + 1) : Stack::Place{0, 0});
        }
        for (const PackedRelief& relief : packed.reliefs) {
            layout::MapData data = relief.shader.data;
            Stack::Place height_place = height_places[std::size_t(relief.map)];
            data.heights_x = height_place.x;
            data.heights_y = height_place.y;
            data.layer = height_place.layer;
            data.nodes_y = node_places[std::size_t(relief.map)].y;
            data.nodes_layer = node_places[std::size_t(relief.map)].layer;
            bound_places.push_back(bounds.add(relief.bounds.side, relief.bounds.imageHeight()));
            data.bounds_y = bound_places.back().y;
            data.bounds_layer = bound_places.back().layer;
            data.edges_y = addEdges(std::max(data.width, data.rows), relief.shader.longitude_phases.empty() ? 2 : 4);
            tiles.place(data, relief.map);
            maps.push_back(data);
        }
        placeImages(device, packed);
    }
};

DeviceScene::DeviceScene(gpu::Device& device, const PackedScene& packed) try
    : DeviceScene(device, packed, std::make_unique<TilePool>(device, packed)) {
} catch (const gpu::OutOfMemory& error) {
    throwFailure("{}; --mem-limit SIZE, of less than 8 bytes for each of a map's texels, keeps heights in their file",
                 error.what());
}

DeviceScene::DeviceScene(gpu::Device& device, const PackedScene& packed, std::unique_ptr<TilePool> tiles)
    : tiles_(std::move(tiles)),
      layout_(std::make_shared<const Layout>(device, packed, *tiles_)),
      objects_(makeBuffer(device, gpu::Buffer::Usage::Uniform, layout_->placedObjects(packed.state), MAX_OBJECTS,
                          "objects")),
      maps_(device, gpu::Buffer::Usage::Uniform, gpu::Buffer::Place::Device,
            sizeof(layout::MapData) * MAX_OBJECTS * MAX_LEVELS, "maps"),
      lights_(
          makeBuffer(device, gpu::Buffer::Usage::Uniform, layout_->placedLights(packed.state), MAX_LIGHTS, "lights")),
      materials_(makeBuffer(device, gpu::Buffer::Usage::Uniform, packed.state.materials, 2 * MAX_OBJECTS, "materials")),
      triangles_(makeBuffer(device, gpu::Buffer::Usage::Uniform, packed.triangles, MAX_TRIANGLES, "triangles")),
      ramps_(makeBuffer(device, gpu::Buffer::Usage::Storage, packed.ramp_points,
                        std::max<std::size_t>(packed.ramp_points.size(), 1), "ramps")),
      tables_(makeBuffer(device, gpu::Buffer::Usage::Storage, packed.tables.values,
                         std::max<std::size_t>(packed.tables.values.size(), 1), "tables")),
      heights_(makeImage(device, gpu::Format::R32Float, layout_->heights, "heights")),
      bounds_(makeImage(device, gpu::Format::R32Float, layout_->bounds, "bounds")),
      edges_(makeImage(device, gpu::Format::Rgba32Float, layout_->edges, "edges")),
      images_(makeImage(device, gpu::Format::R32Uint, layout_->images, "images")),
      nodes_(makeImage(device, gpu::Format::Rgba32Float, layout_->nodes, "nodes")) {
    for (std::size_t i = 0; i < packed.nodes.size(); ++i) {
        if (layout_->uses[i].heights) uploadNodes(heights_, *packed.nodes[i], layout_->height_places[i]);
        if (layout_->uses[i].spline) uploadSpline(nodes_, *packed.nodes[i], layout_->node_places[i]);
    }
    auto uploadEdges = [&](int y, const std::vector<layout::vec4>& edges) {
        const std::size_t most = layout_->long_edges ? std::size_t(EDGE_COLUMNS) : edges.size();
        for (std::size_t x = 0; x < edges.size(); x += most, y += EDGE_ROWS)
            edges_.upload(0, 0, std::uint32_t(y), std::uint32_t(std::min(most, edges.size() - x)), 1, &edges[x]);
    };
    for (std::size_t i = 0; i < packed.reliefs.size(); ++i) {
        const PackedRelief& relief = packed.reliefs[i];
        uploadEdges(layout_->maps[i].edges_y, relief.shader.longitude_edges);
        uploadEdges(layout_->maps[i].edges_y + 1, relief.shader.colatitude_edges);
        if (relief.shader.longitude_phases.empty()) continue;
        uploadEdges(layout_->maps[i].edges_y + 2, relief.shader.longitude_phases);
        uploadEdges(layout_->maps[i].edges_y + 3, relief.shader.colatitude_phases);
    }
    updateReliefs(packed);
    for (std::size_t i = 0; i < packed.state.objects.size(); ++i) {
        const PackedObject& object = packed.state.objects[i];
        if (object.image < 0) continue;
        uploadEdges(layout_->centre_rows[i], object.centres.columns);
        uploadEdges(layout_->centre_rows[i] + 1, object.centres.rows);
    }
    if (!packed.images.empty()) images_.upload(0, 0, 0, 256, 1, codeWords().data());
    for (std::size_t i = 0; i < packed.images.size(); ++i)
        uploadImage(images_, packed.images[i], layout_->image_places[i]);
    if (!packed.images.empty())
        image_bytes_ =
            std::uint64_t(images_.width()) * images_.height() * images_.layers() * texelBytes(images_.format());
    std::vector<const gpu::StorageImage*> of_maps = {&bounds_, &edges_};
    if (!tiles_->empty()) of_maps.push_back(&tiles_->image());
    if (std::ranges::any_of(layout_->uses, &MapUse::heights)) of_maps.push_back(&heights_);
    if (std::ranges::any_of(layout_->uses, &MapUse::spline)) of_maps.push_back(&nodes_);
    for (const gpu::StorageImage* image : of_maps)
        map_bytes_ += std::uint64_t(image->width()) * image->height() * image->layers() * texelBytes(image->format());
}

void DeviceScene::updateObjects(const PackedState& state) {
    const std::vector<layout::ObjectData> objects = layout_->placedObjects(state);
    objects_.upload(0, objects.size() * sizeof(objects[0]), objects.data());
}

void DeviceScene::updateLook(const PackedState& state) {
    const std::vector<layout::LightData> lights = layout_->placedLights(state);
    if (!lights.empty()) lights_.upload(0, lights.size() * sizeof(lights[0]), lights.data());
    materials_.upload(0, state.materials.size() * sizeof(state.materials[0]), state.materials.data());
}

void DeviceScene::updateReliefs(const PackedScene& packed) {
    const std::vector<layout::MapData> maps = layout_->ofObjects(packed);
    maps_.upload(0, maps.size() * sizeof(maps[0]), maps.data());
    for (std::size_t i = 0; i < packed.reliefs.size(); ++i) {
        const Bounds& bounds = packed.reliefs[i].bounds;
        Stack::Place place = layout_->bound_places[i];
        bounds_.upload(std::uint32_t(place.layer), 0, std::uint32_t(place.y), std::uint32_t(bounds.side),
                       std::uint32_t(bounds.imageHeight()), bounds.squared.data());
    }
}

std::vector<gpu::Resource> DeviceScene::resources() const {
    return {&objects_, &maps_,   &lights_, &materials_, &triangles_, &ramps_,         &tables_,
            &heights_, &bounds_, &edges_,  &images_,    &nodes_,     &tiles_->image()};
}

}  // namespace dsphere
