#pragma once

// GDAL's handles of a file that is read in windows.

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "geo/gdaldataset.h"

namespace dsphere::geo {

/// A rectangle of the file's texels.
struct Window {
    int x = 0, y = 0, width = 0, height = 0;
};

/// A strip or tile, in which GDAL reads a file.
struct Block {
    int width = 1, height = 1;
};

/// Calls visit(piece) for pieces of a window that end where blocks of the file do, in the file's order. Each is a
/// block, or several with at most `most_texels`.
template <typename Visit>
void forPieces(const Window& window, const Block& block, std::int64_t most_texels, Visit visit) {
    const std::int64_t block_width = block.width, block_height = block.height;
    const std::int64_t blocks_down = (window.height + block_height - 1) / block_height + 1;
    const std::int64_t height =
        block_height * std::clamp<std::int64_t>(most_texels / (block_width * block_height), 1, blocks_down);
    const std::int64_t width = block_width * std::max<std::int64_t>(most_texels / (block_width * height), 1);
    const std::int64_t right = window.x + window.width, bottom = window.y + window.height;
    for (std::int64_t y = window.y, next_y; y < bottom; y = next_y) {
        next_y = std::min((y / height + 1) * height, bottom);
        for (std::int64_t x = window.x, next_x; x < right; x = next_x) {
            next_x = std::min((x / width + 1) * width, right);
            visit(Window{int(x), int(y), int(next_x - x), int(next_y - y)});
        }
    }
}

/// Few enough texels that GDAL's cache keeps all blocks that are read at once: it would read a row of blocks anew for
/// each row of texels otherwise.
inline constexpr std::int64_t kPieceTexels = 1 << 20;

/// One of GDAL's handles of the file, which serves one thread at a time.
struct Handle {
    OpenMap file;
    GDALRasterBandH band = nullptr, mask = nullptr;
    Block block = {};

    void setBand(int number) {
        band = gdal().GDALGetRasterBand(file.dataset.get(), number);
        gdal().GDALGetBlockSize(band, &block.width, &block.height);
    }
    void fetch(GDALRasterBandH from, const Window& w, void* to, GDALDataType type, std::size_t bytes_per_row) const {
        GdalMessages messages;
        if (gdal().GDALRasterIO(from, GF_Read, w.x, w.y, w.width, w.height, to, w.width, w.height, type, 0,
                                int(bytes_per_row)) == CE_None)
            return;
        if (!messages.failed()) findReason(from, w);
        refuse(w, messages);
    }

    /// The window at `columns` x `rows`.
    std::vector<double> fetchReduced(GDALRasterBandH from, const Window& w, int columns, int rows) const {
        std::vector<double> values(std::size_t(columns) * std::size_t(rows));
        GdalMessages messages;
        if (gdal().GDALRasterIO(from, GF_Read, w.x, w.y, w.width, w.height, values.data(), columns, rows, GDT_Float64,
                                0, 0) != CE_None)
            refuse(w, messages);
        return values;
    }

  private:
    [[noreturn]] void refuse(const Window& w, const GdalMessages& messages) const {
        throwInvalid("{}: {}: rows {} to {} of columns {} to {} cannot be read: {}", file.name(),
                     nameOf(file.file.format), w.y, w.y + w.height - 1, w.x, w.x + w.width - 1, messages.reason());
    }
    /// GDAL's threads, which decode several blocks at once, keep their reasons to themselves: throws that of the first
    /// block that cannot be read alone.
    void findReason(GDALRasterBandH from, const Window& window) const {
        forPieces(window, block, 1, [&](const Window& w) {
            GdalMessages messages;
            double texel = 0.0;
            if (gdal().GDALRasterIO(from, GF_Read, w.x, w.y, 1, 1, &texel, 1, 1, GDT_Float64, 0, 0) != CE_None)
                refuse(w, messages);
        });
    }
};

/// As many handles as threads read at once, but at most one more than there are cores.
class Handles {
  public:
    using Open = std::function<std::unique_ptr<Handle>()>;

    Handles(std::unique_ptr<Handle> first, Open open) : open_(std::move(open)) { idle_.push_back(std::move(first)); }

    /// Calls use(handle).
    template <typename Use>
    void with(Use use) {
        std::unique_ptr<Handle> handle = take();
        try {
            use(*handle);
        } catch (...) {
            giveBack(std::move(handle));
            throw;
        }
        giveBack(std::move(handle));
    }

  private:
    std::unique_ptr<Handle> take() {
        std::unique_lock lock(mutex_);
        returned_.wait(lock, [&] { return !idle_.empty() || count_ < most_; });
        if (!idle_.empty()) {
            std::unique_ptr<Handle> handle = std::move(idle_.back());
            idle_.pop_back();
            return handle;
        }
        ++count_;
        lock.unlock();
        try {
            return open_();
        } catch (...) {
            lock.lock();
            --count_;
            returned_.notify_one();
            throw;
        }
    }
    void giveBack(std::unique_ptr<Handle> handle) {
        const std::lock_guard lock(mutex_);
        idle_.push_back(std::move(handle));
        returned_.notify_one();
    }

    Open open_;
    std::mutex mutex_;
    std::condition_variable returned_;
    std::vector<std::unique_ptr<Handle>> idle_;
    unsigned count_ = 1;
    const unsigned most_ = std::max(1u, std::thread::hardware_concurrency()) + 1;
};

}  // namespace dsphere::geo
