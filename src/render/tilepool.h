#pragma once

#include "gpu/image.h"
#include "render/pack.h"

#include <cstdint>
#include <list>
#include <span>
#include <vector>

namespace dsphere {

namespace gpu {
class Device;
}

/// The heights of maps that stay in their files: tiles of them on the device, read when rays need them, as many as
/// there is room for. See MapData and BINDING_TILES.
class TilePool {
  public:
    /// Room for all tiles of the scene's such maps, or for as many as half of packed.memory_limit holds (0: half of the
    /// device's memory), but for kLeastSlots; without such a map an image of one texel, of two layers where the scene's
    /// traits expect one. The maps must outlive it.
    TilePool(gpu::Device& device, const PackedScene& packed);

    const gpu::StorageImage& image() const { return image_; }
    bool empty() const { return layout_.maps.empty(); }
    /// What is said of tiles of the map at an index of PackedScene::nodes, if it is such a map.
    void place(layout::MapData& data, int map) const;

    /// From here on tiles that load() reads stay until the next unpin().
    void unpin();
    /// Reads those of these tiles that are absent, in place of the ones read longest ago. False: there is no room for
    /// all, since others must stay; some of them may have been read. Throws Error (InvalidInput) where a file cannot be
    /// read.
    bool load(std::vector<std::uint32_t> tiles);

    std::uint32_t slots() const { return std::uint32_t(slots_.size()); }
    std::uint64_t loads() const { return loads_; }  ///< tiles read so far
    std::uint64_t tileBytes() const { return layout_.tileBytes(); }

    static constexpr std::uint32_t kLeastSlots = 32;

  private:
    static constexpr std::uint32_t kFree = 0xffffffffu;

    struct Map {
        const Heightmap* map;
        const NodeGrid* nodes;
        int index;                 ///< in PackedScene::nodes
        int across = 0, down = 0;  ///< tiles
        int table_y = 0;           ///< its table's row
        std::uint32_t first_tile = 0;
        std::vector<std::uint32_t> table;
    };
    struct Slot {
        std::uint32_t tile = kFree;
        std::uint64_t pinned = 0;  ///< the turn in which it was read
    };
    struct Layout {
        std::vector<Map> maps;
        int shift = 0, margin = 0, words = 1, table_rows = 0, table_columns = 1;
        int slots_x = 1, slots_y = 1, layers = 1;

        int side() const { return 1 << shift; }                ///< cells
        int nodes() const { return side() + 1 + 2 * margin; }  ///< along an edge of a tile
        std::uint32_t width() const;
        std::uint32_t height() const;
        std::uint64_t tileBytes() const { return std::uint64_t(words) * std::uint64_t(nodes()) * 4; }
    };

    TilePool(gpu::Device& device, Layout layout);
    static Layout layoutOf(const gpu::Device& device, const PackedScene& packed);

    Map& mapOf(std::uint32_t tile);
    std::uint32_t& entryOf(std::uint32_t tile);
    void readTile(std::uint32_t tile, std::vector<std::uint32_t>& words);
    void uploadTile(std::uint32_t slot, const std::vector<std::uint32_t>& words);
    void uploadTables();

    Layout layout_;
    gpu::StorageImage image_;
    std::vector<Slot> slots_;
    std::list<std::uint32_t> order_;  ///< of slots: the one read longest ago first
    std::uint64_t turn_ = 1, loads_ = 0;
};

}  // namespace dsphere
