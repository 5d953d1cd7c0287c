#include "surface/tiledheights.h"

#include <algorithm>
#include <atomic>
#include <span>
#include <type_traits>

namespace dsphere {

namespace {

std::uint64_t nextId() {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

}  // namespace

TiledHeights::TiledHeights(std::shared_ptr<const geo::LargeMap> source, Gaps gaps)
    : source_(std::move(source)), gaps_(std::move(gaps)), id_(nextId()) {}

void TiledHeights::countFrom(float zero) {
    zero_ = zero;
    for (float* value :
         {&survey_.north_pole, &survey_.south_pole, &survey_.least, &survey_.greatest, &survey_.second_least})
        *value -= zero;
    for (auto* values : {&survey_.cells.least, &survey_.cells.greatest, &survey_.blocks.least, &survey_.blocks.greatest,
                         &survey_.reduced})
        for (float& value : *values) value -= zero;
}

// Rows that follow one another in the file are read at once, and so are columns up to the seam.
template <typename T>
void TiledHeights::readAs(int column, int row, int width, int height, T* to) const {
    const int columns = this->width(), rows = this->height();
    const auto sourceRow = [&](int j) { return gaps_.source(std::clamp(row + j, 0, rows - 1)); };
    column %= columns;
    std::vector<T> window;
    for (int j = 0; j < height;) {
        const int first = sourceRow(j);
        int count = 1;
        while (j + count < height && sourceRow(j + count) == first + count) ++count;
        for (int done = 0; done < width;) {
            const int x = (column + done) % columns;
            const int part = std::min(width - done, columns - x);
            T* const place = to + std::size_t(j) * std::size_t(width) + std::size_t(done);
            T* lines = place;
            if (part < width) {
                window.resize(std::size_t(part) * std::size_t(count));
                lines = window.data();
            }
            source_->read(x, first, part, count, lines);
            for (int k = 0; k < count; ++k) {
                T* const line = lines + std::size_t(k) * std::size_t(part);
                if (gaps_.any()) gaps_.fill(first + k, x, part, columns, line);
                if (lines != place) std::copy_n(line, part, place + std::size_t(k) * std::size_t(width));
            }
            done += part;
        }
        j += count;
    }
    if (zero_ == 0.0f) return;
    for (T& value : std::span(to, std::size_t(width) * std::size_t(height))) value = T(value - T(zero_));
}

void TiledHeights::read(int column, int row, int width, int height, void* to) const {
    geo::withSampleType(kind(),
                        [&](auto sample) { readAs(column, row, width, height, static_cast<decltype(sample)*>(to)); });
}

std::shared_ptr<const TiledHeights::Tile> TiledHeights::tile(int number) const {
    {
        const std::lock_guard lock(mutex_);
        if (const auto found = places_.find(number); found != places_.end()) {
            tiles_.splice(tiles_.begin(), tiles_, found->second);
            return found->second->second;
        }
    }
    const int across = (width() + kCacheSide - 1) / kCacheSide;
    const std::size_t count = std::size_t(kCacheSide) * kCacheSide;
    auto made = std::make_shared<Tile>();
    made->samples.resize(count);
    const int column = number % across * kCacheSide, row = number / across * kCacheSide;
    geo::withSampleType(kind(), [&](auto sample) {
        std::vector<decltype(sample)> samples(count);
        readAs(column, row, kCacheSide, kCacheSide, samples.data());
        std::ranges::copy(samples, made->samples.begin());
    });
    const std::lock_guard lock(mutex_);
    if (const auto found = places_.find(number); found != places_.end()) return found->second->second;
    tiles_.emplace_front(number, made);
    places_[number] = tiles_.begin();
    if (tiles_.size() > kCacheBytes / (count * sizeof(float))) {
        places_.erase(tiles_.back().first);
        tiles_.pop_back();
    }
    return made;
}

float TiledHeights::at(int column, int row) const {
    struct Last {
        std::uint64_t owner = 0;
        int number = -1;
        std::shared_ptr<const Tile> tile;
    };
    thread_local Last last;
    const int across = (width() + kCacheSide - 1) / kCacheSide;
    const int number = row / kCacheSide * across + column / kCacheSide;
    if (last.owner != id_ || last.number != number) last = {id_, number, tile(number)};
    return last.tile->samples[std::size_t(row % kCacheSide) * kCacheSide + std::size_t(column % kCacheSide)];
}

}  // namespace dsphere
