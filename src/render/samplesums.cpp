#include "render/samplesums.h"

#include "base/error.h"
#include "render/devicefilm.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>

namespace dsphere {

namespace {

/// Told without a branch: most pictures have no other values, and are told in a hundredth of a second less.
bool allFinite(const Channel& channel) {
    bool all = true;
    for (const float value : channel.floats()) all &= std::abs(value) <= std::numeric_limits<float>::max();
    return all;
}

/// Whether a part holds the first samples of a block, and not all of them.
bool opensBlock(const SumPart& part) {
    return part.first % kSumBlock == 0 && part.count() < kSumBlock;
}

/// Whether two parts, one after the other, are to be added.
bool join(const SumPart& left, const SumPart& right) {
    if (opensBlock(left)) return right.count() == 1;
    const int size = left.count();
    return size % kSumBlock == 0 && right.count() == size && left.first % (2 * size) == 0;
}

bool meansTellSums(const SampleSums& sums) {
    return sums.parts().size() == 1 && std::has_single_bit(unsigned(sums.samples()));
}

std::string sumName(int first, int last, const std::string& channel) {
    return fmt::format("sum.{}-{}.{}", first, last, channel);
}

/// A part of which a picture has sums.
struct Range {
    int first, last;
    auto operator<=>(const Range&) const = default;
};

/// Of "sum.0-16.R"; an empty range for other names.
Range rangeOf(const std::string& name) {
    Range range{0, 0};
    constexpr std::string_view kStart = "sum.";
    if (!name.starts_with(kStart)) return range;
    const char* const end = name.data() + name.size();
    const auto first = std::from_chars(name.data() + kStart.size(), end, range.first);
    if (first.ec != std::errc() || first.ptr == end || *first.ptr != '-') return {0, 0};
    const auto last = std::from_chars(first.ptr + 1, end, range.last);
    if (last.ec != std::errc() || last.ptr == end || *last.ptr != '.') return {0, 0};
    return range;
}

/// The sums of one part; `factor` turns what the channels hold into them.
SumPart readPart(const Image& picture, const Range& range, bool means) {
    SumPart part{range.first, range.last, {picture.data, picture.display, {}}};
    for (const std::string colour : {"R", "G", "B", "A"}) {
        const std::string name = means ? colour : sumName(range.first, range.last, colour);
        const Channel* channel = picture.find(name);
        if (!channel && colour == "A" && !picture.find("A")) continue;
        if (!channel || !channel->isFloat())
            throwInvalid("it has no channel {}, which samples {} to {} take to go on", name, range.first,
                         range.last - 1);
        std::vector<float>& sums = part.sums.addFloat(colour).floats();
        sums = channel->floats();
        if (means)
            for (float& value : sums) value *= float(part.count());
    }
    return part;
}

}  // namespace

void addSums(Image& sums, const Image& more) {
    assert(sums.data == more.data && sums.channels.size() == more.channels.size());
    for (Channel& channel : sums.channels) {
        const std::vector<float>& from = more.at(channel.name).floats();
        for (std::size_t i = 0; i < from.size(); ++i) channel.floats()[i] += from[i];
    }
}

bool SampleSums::isOpen() const {
    return !parts_.empty() && opensBlock(parts_.back());
}

void SampleSums::append(SumPart part) {
    assert(part.count() > 0 && (parts_.empty() || part.first == last()));
    parts_.push_back(std::move(part));
    while (parts_.size() > 1 && join(parts_[parts_.size() - 2], parts_.back())) {
        const SumPart right = takeLast();
        addSums(parts_.back().sums, right.sums);
        parts_.back().last = right.last;
    }
}

void SampleSums::append(SampleSums sums) {
    for (SumPart& part : sums.parts_) append(std::move(part));
}

SumPart SampleSums::takeLast() {
    SumPart part = std::move(parts_.back());
    parts_.pop_back();
    return part;
}

Image SampleSums::total() const {
    Image sums = parts_.front().sums;
    for (std::size_t i = 1; i < parts_.size(); ++i) addSums(sums, parts_[i].sums);
    return sums;
}

// What the film adds up goes on from an open part, starts a block, or is a sample alone whose block began elsewhere.
SampleSums addSamples(const SampleFilm& film, SampleSums start, int from, int to,
                      const std::function<bool(double)>& progress) {
    SampleSums sums = std::move(start);
    int next = sums.samples() > 0 ? sums.last() : from;
    const int begun = next, count = to - begun;
    assert(next >= 0 && count >= 1);
    bool going = true;
    while (going && next < to) {
        const bool open = sums.isOpen();
        const int first = open ? sums.parts().back().first : next;
        const int end = first % kSumBlock == 0 ? std::min(to, first + kSumBlock) : next + 1;
        if (open) {
            const SumPart part = sums.takeLast();
            film.begin(&part.sums);
        } else {
            film.begin(nullptr);
        }
        for (; going && next < end; ++next)
            film.add(next, [&](double share) {
                going = going && (!progress || progress((next - begun + share) / count));
                return true;
            });
        sums.append({first, next, film.read()});
    }
    return sums;
}

Image pictureOf(SampleSums sums) {
    const int samples = sums.samples();
    const bool told = meansTellSums(sums);
    Image picture = told ? sums.takeLast().sums : sums.total();
    takeMean(picture, samples);
    if (told) return picture;
    for (const SumPart& part : sums.parts())
        for (Channel channel : part.sums.channels) {
            channel.name = sumName(part.first, part.last, channel.name);
            picture.channels.push_back(std::move(channel));
        }
    return picture;
}

std::size_t nonFinitePixels(const SampleSums& sums) {
    std::vector<const Channel*> channels;
    for (const SumPart& part : sums.parts())
        for (const Channel& channel : part.sums.channels) channels.push_back(&channel);
    if (std::ranges::all_of(channels, [](const Channel* channel) { return allFinite(*channel); })) return 0;
    std::size_t count = 0;
    const std::size_t pixels = channels.empty() ? 0 : channels[0]->floats().size();
    for (std::size_t i = 0; i < pixels; ++i) {
        const auto isFinite = [i](const Channel* channel) { return std::isfinite(channel->floats()[i]); };
        count += !std::ranges::all_of(channels, isFinite);
    }
    return count;
}

SampleSums sumsOf(const Image& picture, int first, int last) {
    std::set<Range> ranges;
    for (const Channel& channel : picture.channels)
        if (const Range range = rangeOf(channel.name); range.last > range.first) ranges.insert(range);
    SampleSums sums;
    if (ranges.empty()) {
        SumPart part = readPart(picture, {first, last}, true);
        if (!std::has_single_bit(unsigned(part.count())))
            throwInvalid("it has no channel {}, which samples {} to {} take to go on", sumName(first, last, "R"), first,
                         last - 1);
        sums.append(std::move(part));
        return sums;
    }
    int next = first;
    for (const Range& range : ranges) {
        if (range.first != next) throwInvalid("it lacks the sums of samples {} to {}", next, range.first - 1);
        sums.append(readPart(picture, range, false));
        next = range.last;
    }
    if (next != last) throwInvalid("it lacks the sums of samples {} to {}", next, last - 1);
    return sums;
}

}  // namespace dsphere
