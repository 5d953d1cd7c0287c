#include "surface/heldmap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/hash.h"

namespace dsphere {

namespace {

template <typename T>
bool allAre(const std::vector<float>& samples) {
    constexpr float least = std::numeric_limits<T>::min(), greatest = std::numeric_limits<T>::max();
    return std::ranges::all_of(samples, [](float x) { return x >= least && x <= greatest && x == std::floor(x); });
}

template <typename T>
class HeldMap : public geo::LargeMap {
  public:
    HeldMap(RawMap map, geo::SampleKind kind) : samples_(map.samples.begin(), map.samples.end()), kind_(kind) {
        map.samples = {};
        head_ = std::move(map);
    }

    const RawMap& head() const override { return head_; }
    geo::SampleKind kind() const override { return kind_; }
    std::optional<int> unknownCode() const override { return {}; }
    void read(int x, int y, int width, int height, void* to) const override {
        T* next = static_cast<T*>(to);
        for (int j = y; j < y + height; ++j) next = std::copy_n(&samples_[indexOf(x, j)], width, next);
    }
    std::vector<float> overview(int columns, int rows) const override {
        std::vector<float> result;
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i)
                result.push_back(
                    float(samples_[indexOf(middle(i, columns, head_.width), middle(j, rows, head_.height))]));
        return result;
    }
    std::string identity() const override {
        Hash hash;
        hash.bytes(samples_.data(), samples_.size() * sizeof(T));
        return "samples " + std::to_string(hash.value());
    }

  private:
    static int middle(int i, int count, int whole) { return int((2 * std::int64_t(i) + 1) * whole / (2 * count)); }
    std::size_t indexOf(int x, int y) const { return std::size_t(y) * std::size_t(head_.width) + std::size_t(x); }

    std::vector<T> samples_;
    geo::SampleKind kind_;
    RawMap head_;
};

}  // namespace

std::shared_ptr<const geo::LargeMap> holdMap(RawMap map) {
    if (allAre<std::uint16_t>(map.samples))
        return std::make_shared<HeldMap<std::uint16_t>>(std::move(map), geo::SampleKind::UInt16);
    if (allAre<std::int16_t>(map.samples))
        return std::make_shared<HeldMap<std::int16_t>>(std::move(map), geo::SampleKind::Int16);
    return std::make_shared<HeldMap<float>>(std::move(map), geo::SampleKind::Float32);
}

}  // namespace dsphere
