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

/// `T` is the type of `kind`.
template <typename T>
class HeldMap : public geo::LargeMap {
  public:
    HeldMap(RawMap map, geo::SampleKind kind, std::optional<int> unknown)
        : samples_(map.samples.begin(), map.samples.end()), kind_(kind), unknown_(unknown) {
        map.samples = {};
        head_ = std::move(map);
        if (unknown || kind == geo::SampleKind::Float32) head_.unknown_are_nan = true;
        Hash hash;
        hash.bytes(samples_.data(), samples_.size() * sizeof(T));
        identity_ = "samples " + std::to_string(hash.value());
    }

    const RawMap& head() const override { return head_; }
    geo::SampleKind kind() const override { return kind_; }
    std::optional<int> unknownCode() const override { return unknown_; }
    void read(int x, int y, int width, int height, void* to) const override {
        T* next = static_cast<T*>(to);
        for (int j = y; j < y + height; ++j) next = std::copy_n(&samples_[indexOf(x, j)], width, next);
    }
    std::vector<float> overview(int columns, int rows) const override {
        std::vector<float> result;
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i) {
                const T sample = samples_[indexOf(middle(i, columns, head_.width), middle(j, rows, head_.height))];
                const bool known = !unknown_ || sample != T(*unknown_);
                result.push_back(known ? float(sample) : std::numeric_limits<float>::quiet_NaN());
            }
        return result;
    }
    std::string identity() const override { return identity_; }

  private:
    static int middle(int i, int count, int whole) { return int((2 * std::int64_t(i) + 1) * whole / (2 * count)); }
    std::size_t indexOf(int x, int y) const { return std::size_t(y) * std::size_t(head_.width) + std::size_t(x); }

    std::vector<T> samples_;
    geo::SampleKind kind_;
    std::optional<int> unknown_;
    RawMap head_;
    std::string identity_;
};

geo::SampleKind narrowestKind(const std::vector<float>& samples) {
    if (allAre<std::uint16_t>(samples)) return geo::SampleKind::UInt16;
    if (allAre<std::int16_t>(samples)) return geo::SampleKind::Int16;
    return geo::SampleKind::Float32;
}

}  // namespace

std::shared_ptr<const geo::LargeMap> holdMap(RawMap map, geo::SampleKind kind, std::optional<int> unknown) {
    return geo::withSampleType(kind, [&](auto sample) -> std::shared_ptr<const geo::LargeMap> {
        return std::make_shared<HeldMap<decltype(sample)>>(std::move(map), kind, unknown);
    });
}

std::shared_ptr<const geo::LargeMap> holdMap(RawMap map) {
    const geo::SampleKind kind = narrowestKind(map.samples);
    return holdMap(std::move(map), kind);
}

}  // namespace dsphere
