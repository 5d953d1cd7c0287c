#include "render/tilepool.h"

#include "base/parallel.h"
#include "gpu/device.h"
#include "surface/tiledheights.h"

#include <algorithm>
#include <cassert>
#include <future>

namespace dsphere {

namespace {

constexpr int kSlotsAcross = 8, kSlotsDown = 4;  // of a layer
constexpr std::uint64_t kLeastLayers = 2;        // drivers compile apart for images of one (see warmAhead)
constexpr std::size_t kReadAtOnce = 16;          // tiles

int shiftOf(int width) {
    return width > 8192 ? 9 : 8;
}

int samplesOf(geo::SampleKind kind) {
    switch (kind) {
        case geo::SampleKind::UInt16:
            return SAMPLES_UINT16;
        case geo::SampleKind::Int16:
            return SAMPLES_INT16;
        case geo::SampleKind::Float32:
            return SAMPLES_FLOAT;
    }
    return SAMPLES_FLOAT;
}

/// Words of that many samples.
int wordsOf(geo::SampleKind kind, int samples) {
    return kind == geo::SampleKind::Float32 ? samples : (samples + 1) / 2;
}

}  // namespace

std::uint32_t TilePool::Layout::width() const {
    return std::uint32_t(std::max(slots_x * words, table_columns));
}

std::uint32_t TilePool::Layout::height() const {
    return std::uint32_t(table_rows + slots_y * nodes());
}

TilePool::Layout TilePool::layoutOf(const gpu::Device& device, const PackedScene& packed) {
    Layout layout;
    for (std::size_t i = 0; i < packed.nodes.size(); ++i) {
        const Heightmap& map = packed.nodes[i]->map();
        if (!map.tiled) continue;
        layout.maps.push_back({.map = &map, .nodes = packed.nodes[i].get(), .index = int(i), .table = {}});
        layout.shift = std::max(layout.shift, shiftOf(map.width));
    }
    if (layout.maps.empty()) {
        if (packed.traits.tiles) layout.layers = int(kLeastLayers);
        return layout;
    }
    layout.margin = packed.traits.curved() ? TILE_MARGIN : 0;
    std::uint32_t tiles = 0;
    for (Map& map : layout.maps) {
        layout.words = std::max(layout.words, wordsOf(map.map->tiled->kind(), layout.nodes()));
        map.across = (map.nodes->width() + layout.side() - 1) >> layout.shift;
        map.down = (map.nodes->rows() + layout.side() - 1) >> layout.shift;
        map.first_tile = tiles;
        map.table_y = layout.table_rows;
        map.table.assign(std::size_t(map.across) * std::size_t(map.down), NO_TILE);
        layout.table_columns = std::max(layout.table_columns, map.across);
        layout.table_rows += map.down;
        tiles += std::uint32_t(map.table.size());
    }
    const std::uint64_t whole = packed.memory_limit > 0 ? packed.memory_limit : device.limits().memory_heap_size;
    const std::uint64_t room = std::min(whole / 2, device.limits().max_allocation_size / 8 * 7);
    const std::uint64_t slots =
        std::min<std::uint64_t>(tiles, std::max<std::uint64_t>(room / layout.tileBytes(), kLeastSlots));
    layout.slots_x = int(std::min<std::uint64_t>(slots, kSlotsAcross));
    layout.slots_y = int(std::clamp<std::uint64_t>(slots / (kLeastLayers * kSlotsAcross), 1, kSlotsDown));
    const std::uint64_t of_layer = std::uint64_t(layout.slots_x) * std::uint64_t(layout.slots_y);
    // Where all have room, the last layer may be part full.
    const std::uint64_t last = slots == tiles ? of_layer - 1 : 0;
    layout.layers =
        int(std::clamp<std::uint64_t>((slots + last) / of_layer, kLeastLayers, device.limits().max_image_array_layers));
    return layout;
}

TilePool::TilePool(gpu::Device& device, const PackedScene& packed) : TilePool(device, layoutOf(device, packed)) {}

TilePool::TilePool(gpu::Device& device, Layout layout)
    : layout_(std::move(layout)),
      image_(device, gpu::Format::R32Uint, layout_.width(), layout_.height(), std::uint32_t(layout_.layers), "tiles") {
    if (empty()) return;
    slots_.resize(std::size_t(layout_.slots_x) * std::size_t(layout_.slots_y) * std::size_t(layout_.layers));
    for (std::uint32_t slot = 0; slot < slots(); ++slot) order_.push_back(slot);
    uploadTables();
}

void TilePool::place(layout::MapData& data, int index) const {
    const auto found = std::ranges::find(layout_.maps, index, &Map::index);
    if (found == layout_.maps.end()) return;
    data.tile_shift = layout_.shift;
    data.table_y = found->table_y;
    data.tiles_y = layout_.table_rows;
    data.first_tile = int(found->first_tile);
    data.tile_words = layout_.words;
    data.samples = samplesOf(found->map->tiled->kind());
}

TilePool::Map& TilePool::mapOf(std::uint32_t tile) {
    const auto after = std::ranges::upper_bound(layout_.maps, tile, {}, &Map::first_tile);
    return *(after - 1);
}

std::uint32_t& TilePool::entryOf(std::uint32_t tile) {
    Map& map = mapOf(tile);
    return map.table[tile - map.first_tile];
}

void TilePool::readTile(std::uint32_t tile, std::vector<std::uint32_t>& words) {
    const Map& map = mapOf(tile);
    const TiledHeights& heights = *map.map->tiled;
    const int number = int(tile - map.first_tile), side = layout_.side(), edge = layout_.nodes();
    // Row 0 of the grid's nodes is the north pole of a map of texels.
    const int row = number / map.across * side - (map.nodes->halfCaps() ? 1 : 0) - layout_.margin;
    const int column = number % map.across * side + map.nodes->width() - layout_.margin;
    // As many samples as a row of words holds, so that they need not be moved; what is beyond the tile's is never read.
    words.resize(std::size_t(layout_.words) * std::size_t(edge));
    heights.read(column, row, layout_.words * 4 / geo::bytesOf(heights.kind()), edge, words.data());
}

void TilePool::uploadTile(std::uint32_t slot, const std::vector<std::uint32_t>& words) {
    const std::uint32_t across = std::uint32_t(layout_.slots_x), down = std::uint32_t(layout_.slots_y);
    const std::uint32_t x = slot % across, y = slot / across % down, layer = slot / (across * down);
    const std::uint32_t edge = std::uint32_t(layout_.nodes());
    image_.upload(layer, x * std::uint32_t(layout_.words), std::uint32_t(layout_.table_rows) + y * edge,
                  std::uint32_t(layout_.words), edge, words.data());
    entryOf(slots_[slot].tile) = x | y << 8 | layer << 16;
}

void TilePool::uploadTables() {
    for (const Map& map : layout_.maps)
        image_.upload(0, 0, std::uint32_t(map.table_y), std::uint32_t(map.across), std::uint32_t(map.down),
                      map.table.data());
}

void TilePool::unpin() {
    ++turn_;
}

bool TilePool::load(std::vector<std::uint32_t> tiles) {
    std::ranges::sort(tiles);
    tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
    std::erase_if(tiles, [&](std::uint32_t tile) { return entryOf(tile) != NO_TILE; });
    std::vector<std::uint32_t> chosen;  // a slot for each
    for (std::uint32_t tile : tiles) {
        const std::uint32_t slot = order_.front();
        if (slots_[slot].pinned == turn_) break;
        order_.splice(order_.end(), order_, order_.begin());
        if (slots_[slot].tile != kFree) entryOf(slots_[slot].tile) = NO_TILE;
        slots_[slot] = {tile, turn_};
        chosen.push_back(slot);
    }
    // The next ones are read while these are uploaded.
    std::vector<std::vector<std::uint32_t>> words(2 * kReadAtOnce);
    const auto wordsAt = [&](std::size_t n) -> std::vector<std::uint32_t>& { return words[n % words.size()]; };
    const auto read = [&](std::size_t first) {
        parallelFor(std::min(kReadAtOnce, chosen.size() - first),
                    [&](std::size_t i) { readTile(slots_[chosen[first + i]].tile, wordsAt(first + i)); });
    };
    std::future<void> reading;
    for (std::size_t first = 0; first < chosen.size(); first += kReadAtOnce) {
        const std::size_t end = std::min(first + kReadAtOnce, chosen.size());
        first == 0 ? read(0) : reading.get();
        if (end < chosen.size()) reading = std::async(std::launch::async, read, end);
        for (std::size_t n = first; n < end; ++n) uploadTile(chosen[n], wordsAt(n));
    }
    loads_ += chosen.size();
    uploadTables();
    return chosen.size() == tiles.size();
}

}  // namespace dsphere
