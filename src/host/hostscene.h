#pragma once

#include "render/pack.h"
#include "surface/spline.h"

#include <array>
#include <cstdint>
#include <vector>

namespace dsphere::host {

/// A packed scene behind the bindings of shaders/layout.h, in the host's memory. Each map, pyramid of bounds and image
/// has a layer of its own, so that the shaders' offsets within a layer are 0; heights and bounds are not copied.
class HostScene {
  public:
    /// The packed scene must outlive it.
    explicit HostScene(const PackedScene& packed);

    /// Takes another state of the packed scene.
    void setState(const PackedState& state);
    /// Takes another packing of the same maps and images, and its state.
    void setPacking(const PackedScene& packed);

    std::vector<layout::ObjectData> objects;      ///< MAX_OBJECTS
    std::vector<layout::MapData> maps;            ///< MAX_LEVELS times MAX_OBJECTS
    std::vector<layout::LightData> lights;        ///< MAX_LIGHTS
    std::vector<layout::MaterialData> materials;  ///< 2 MAX_OBJECTS

    const PackedScene& packed() const { return *packed_; }

    // What the shaders load from images, by column, row and layer.
    float height(int x, int y, int layer) const { return packed_->nodes[std::size_t(layer)]->at(x, y); }
    float bound(int x, int y, int layer) const {
        const Bounds& bounds = packed_->reliefs[std::size_t(layer)].bounds;
        return bounds.squared[std::size_t(y) * std::size_t(bounds.side) + std::size_t(x)];
    }
    const layout::vec4& edge(int x, int y) const { return edges_[std::size_t(y)][std::size_t(x)]; }
    std::uint32_t imageWord(int x, int y, int layer) const {
        const Words& words = images_[std::size_t(layer)];
        return words.values[std::size_t(y) * std::size_t(words.width) + std::size_t(x)];
    }
    SplineNodes::Node node(int x, int y, int layer) const {
        const NodeGrid& nodes = *packed_->nodes[std::size_t(layer)];
        if (nodes.map().tiled) return SplineNodes(nodes).at(x, y);
        return splines_[std::size_t(layer)][std::size_t(y)][std::size_t(x)];
    }

    std::uint64_t mapBytes() const;
    std::uint64_t imageBytes() const;

  private:
    struct Words {
        int width = 0;
        std::vector<std::uint32_t> values;
    };
    using SplineRows = std::vector<std::vector<SplineNodes::Node>>;

    void placeMaps(const PackedState& state);
    void placeImages(const PackedState& state);
    void decodeImages();
    void makeSplines();

    const PackedScene* packed_;
    std::vector<std::vector<layout::vec4>> edges_;  ///< four rows a relief, then two rows an object with an image
    std::vector<Words> images_;                     ///< the codes' light, then the scene's images
    std::vector<SplineRows> splines_;  ///< one a map, empty where no relief reads it or its map is in tiles
};

}  // namespace dsphere::host
