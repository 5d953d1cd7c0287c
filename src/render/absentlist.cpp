#include "render/absentlist.h"

#include "base/error.h"

#include <cstring>

namespace dsphere {

AbsentList::AbsentList(gpu::Device& device, TilePool& pool, std::uint64_t capacity)
    : pool_(pool),
      capacity_(pool.empty() ? 1u : std::uint32_t(capacity)),
      buffer_(device, gpu::Buffer::Usage::Storage, gpu::Buffer::Place::Host,
              sizeof(layout::AbsentHead) + 2 * std::uint64_t(capacity_) * sizeof(layout::AbsentPixel), "absent tiles") {
}

void AbsentList::reset(gpu::Batch& batch) const {
    const layout::AbsentHead head = {.count = 0, .capacity = capacity_, .listed = 0, .pad0 = 0};
    if (active()) batch.write(buffer_, &head, sizeof(head));
}

std::vector<layout::AbsentPixel> AbsentList::take() {
    buffer_.invalidate();
    layout::AbsentHead head;
    std::memcpy(&head, buffer_.mapped().data(), sizeof(head));
    std::vector<layout::AbsentPixel> pixels(head.count);
    if (!pixels.empty())
        std::memcpy(pixels.data(), buffer_.mapped().data() + sizeof(head), pixels.size() * sizeof(pixels[0]));
    return pixels;
}

void AbsentList::list(const std::vector<layout::AbsentPixel>& pixels) {
    const layout::AbsentHead head = {
        .count = 0, .capacity = capacity_, .listed = std::uint32_t(pixels.size()), .pad0 = 0};
    std::byte* const to = buffer_.mapped().data();
    std::memcpy(to, &head, sizeof(head));
    std::memcpy(to + sizeof(head) + capacity_ * sizeof(pixels[0]), pixels.data(), pixels.size() * sizeof(pixels[0]));
    buffer_.flush();
}

// Tiles that were read for some pixels stay until these are done: else two of them could take turns in driving out each
// other's tiles for ever. Where there is no room for all of them half of the pixels wait.
void AbsentList::settle(const std::function<void(std::uint32_t count)>& redo) {
    using Pixels = std::vector<layout::AbsentPixel>;
    if (!active()) return;
    std::vector<Pixels> waiting;
    Pixels pixels = take();
    bool alone = pixels.size() == 1;  // no tile stays for a pixel that is done
    pool_.unpin();
    while (!pixels.empty() || !waiting.empty()) {
        if (pixels.empty()) {
            pixels = std::move(waiting.back());
            waiting.pop_back();
            alone = pixels.size() == 1;
            pool_.unpin();
        }
        std::vector<std::uint32_t> tiles;
        for (const layout::AbsentPixel& pixel : pixels) tiles.push_back(pixel.tile);
        if (!pool_.load(std::move(tiles))) {
            if (alone)
                throw Error(ExitCode::Failure,
                            fmt::format("one ray needs more than the {} tiles of heights that the device has room "
                                        "for; --mem-limit sets the room",
                                        pool_.slots()));
            if (pixels.size() > 1) {
                const auto half = pixels.begin() + std::ptrdiff_t(pixels.size() / 2);
                waiting.emplace_back(half, pixels.end());
                pixels.erase(half, pixels.end());
            }
            alone = pixels.size() == 1;
            pool_.unpin();
            continue;
        }
        list(pixels);
        redo(std::uint32_t(pixels.size()));
        pixels = take();
    }
}

}  // namespace dsphere
