#include "cli/parts.h"

#include "base/error.h"
#include "base/limits.h"
#include "bench/environment.h"
#include "render/shards.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <set>

namespace dsphere::cli {

namespace {

constexpr const char *kPicture = "partOfPicture", *kSamples = "partOfSamples", *kFirst = "partFirstSample",
                     *kTurns = "partTurns", *kCommit = "partCommit";
constexpr std::size_t kMostFaults = 8;  // that one message lists

template <typename T>
const T* find(const Metadata& metadata, const char* name) {
    const auto found = metadata.find(name);
    return found == metadata.end() ? nullptr : std::get_if<T>(&found->second);
}

template <typename T>
T need(const Metadata& metadata, const char* name, const std::filesystem::path& path) {
    const T* value = find<T>(metadata, name);
    if (!value)
        throwInvalid("{}: is no part of a picture: its header lacks {}; render --tile and --samples write parts",
                     path.string(), name);
    return *value;
}

std::string pixelsText(const Box& box) {
    return fmt::format("the pixels {}-{} x {}-{}", box.x0, box.x1 - 1, box.y0, box.y1 - 1);
}

std::string samplesText(int first, int last) {
    return last - first == 1 ? fmt::format("sample {}", first) : fmt::format("samples {}-{}", first, last - 1);
}

std::string missingText(int first, int last, const Box& box) {
    return fmt::format("{} of {} {} in no part", samplesText(first, last), pixelsText(box),
                       last - first == 1 ? "is" : "are");
}

/// Names of channels besides those of sums, which differ from range to range.
std::vector<std::string> outputsOf(const Part& part) {
    std::vector<std::string> names;
    for (const ChannelKind& channel : part.channels)
        if (!channel.name.starts_with("sum.")) names.push_back(channel.name);
    return names;
}

void requireSame(const Part& a, const Part& b) {
    const auto fail = [&](const std::string& what) {
        throwInvalid("{} and {} are no parts of one picture: {}", a.path.string(), b.path.string(), what);
    };
    const auto compare = [&](const char* name, const char* what) {
        const auto* in_a = find<std::string>(a.metadata, name);
        const auto* in_b = find<std::string>(b.metadata, name);
        if (in_a && in_b && *in_a != *in_b) fail(fmt::format("{}: {} and {}", what, *in_a, *in_b));
        if (!in_a != !in_b) fail(fmt::format("one header lacks {}", name));
    };
    compare("software", "other versions of the program");
    compare(kCommit, "other commits of the program");
    compare("fingerprint", "another scene, other maps or images, or other options");
    if (need<int>(a.metadata, "seed", a.path) != need<int>(b.metadata, "seed", b.path)) fail("other seeds");
    if (a.display != b.display || a.of.picture != b.of.picture) fail("other sizes or crops of the whole picture");
    if (a.of.samples != b.of.samples)
        fail(fmt::format("pictures of {} and of {} samples a pixel", a.of.samples, b.of.samples));
    if (outputsOf(a) != outputsOf(b))
        fail(fmt::format("other outputs: {} and {}", fmt::join(outputsOf(a), ","), fmt::join(outputsOf(b), ",")));
}

/// A list of faults that ends as one message.
class Faults {
  public:
    void add(std::string text) {
        if (texts_.size() < kMostFaults) texts_.push_back(std::move(text));
        ++count_;
    }
    void throwIfAny() const {
        if (count_ == 0) return;
        const std::string more = count_ > texts_.size() ? fmt::format("; and {} more", count_ - texts_.size()) : "";
        throwInvalid("the parts make no picture: {}{}", fmt::join(texts_, "; "), more);
    }

  private:
    std::vector<std::string> texts_;
    std::size_t count_ = 0;
};

Box common(const Box& a, const Box& b) {
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

bool isEmpty(const Box& box) {
    return box.width() <= 0 || box.height() <= 0;
}

bool sameTile(const Part& a, const Part& b) {
    return a.data == b.data;
}

/// Samples of one tile; [begin, end) are its parts in the order of their samples.
void checkSamples(const Part* begin, const Part* end, Faults& faults) {
    int next = 0;
    const Part* before = nullptr;
    for (const Part* part = begin; part != end; before = part++) {
        if (part->first < next)
            faults.add(fmt::format("{} and {} overlap: both hold {} of {}", before->path.string(), part->path.string(),
                                   samplesText(part->first, std::min(next, part->last)), pixelsText(part->data)));
        if (before && part->of.samples == 0)
            faults.add(fmt::format("{} and {} overlap: both hold {}", before->path.string(), part->path.string(),
                                   pixelsText(part->data)));
        if (part->first > next) faults.add(missingText(next, part->first, part->data));
        next = std::max(next, part->last);
    }
    if (next < begin->of.samples) faults.add(missingText(next, begin->of.samples, begin->data));
}

void checkOverlaps(const std::vector<const Part*>& tiles, Faults& faults) {
    for (std::size_t i = 0; i < tiles.size(); ++i)
        for (std::size_t k = i + 1; k < tiles.size() && tiles[k]->data.y0 < tiles[i]->data.y1; ++k)
            if (const Box both = common(tiles[i]->data, tiles[k]->data); !isEmpty(both))
                faults.add(fmt::format("{} and {} overlap: both hold {}", tiles[i]->path.string(),
                                       tiles[k]->path.string(), pixelsText(both)));
}

// Between two rows at which a tile begins or ends all rows have the same gaps.
void checkGaps(const std::vector<const Part*>& tiles, const Box& picture, Faults& faults) {
    std::set<int> edges = {picture.y0, picture.y1};
    for (const Part* tile : tiles) edges.insert({tile->data.y0, tile->data.y1});
    for (auto y = edges.begin(); std::next(y) != edges.end(); ++y) {
        std::vector<const Part*> row;
        for (const Part* tile : tiles)
            if (tile->data.y0 <= *y && *y < tile->data.y1) row.push_back(tile);
        std::ranges::sort(row, {}, [](const Part* tile) { return tile->data.x0; });
        int next = picture.x0;
        const auto gapTo = [&](int x) {
            if (x > next) faults.add(pixelsText({next, *y, x, *std::next(y)}) + " are in no part");
        };
        for (const Part* tile : row) {
            gapTo(tile->data.x0);
            next = std::max(next, tile->data.x1);
        }
        gapTo(picture.x1);
    }
}

}  // namespace

void tellPart(Metadata& metadata, const PartOf& part) {
    const Box& box = part.picture;
    metadata[kPicture] = fmt::format("{} {} {} {}", box.x0, box.y0, box.x1, box.y1);
    metadata[kSamples] = part.samples;
    metadata[kFirst] = part.first;
    metadata[kTurns] = part.turns;
    metadata[kCommit] = bench::buildCommit();
}

void forgetPart(Metadata& metadata) {
    for (const char* name : {kPicture, kSamples, kFirst, kTurns, kCommit}) metadata.erase(name);
}

int firstSampleOf(const Metadata& metadata) {
    const int* first = find<int>(metadata, kFirst);
    return first ? *first : 0;
}

Part readPart(const std::filesystem::path& path) {
    const ExrReader file(path);
    Part part;
    part.path = path;
    part.data = file.data();
    part.display = file.display();
    part.channels = file.channels();
    part.metadata = file.metadata();
    const std::string picture = need<std::string>(part.metadata, kPicture, path);
    Box& box = part.of.picture;
    if (std::sscanf(picture.c_str(), "%d %d %d %d", &box.x0, &box.y0, &box.x1, &box.y1) != 4 || box.x0 < 0 ||
        box.y0 < 0 || box.x1 > limits::kResolution || box.y1 > limits::kResolution || isEmpty(box))
        throwInvalid("{}: {} is {:?}, expected the corners of a picture", path.string(), kPicture, picture);
    part.of.samples = need<int>(part.metadata, kSamples, path);
    part.of.first = part.first = need<int>(part.metadata, kFirst, path);
    part.of.turns = need<int>(part.metadata, kTurns, path);
    const int count = need<int>(part.metadata, "samplesPerPixel", path);
    for (const int number : {part.of.samples, part.first, count})
        if (number < 0 || number > limits::kPixelSamples)
            throwInvalid("{}: its header counts {} samples, expected 0 to {}", path.string(), number,
                         limits::kPixelSamples);
    part.last = part.first + count;
    if (part.last > part.of.samples || (count == 0 && part.of.samples > 0) || common(part.data, box) != part.data)
        throwInvalid("{}: its header says {} of {} samples, {} of {}: no part is like that", path.string(),
                     samplesText(part.first, part.last), part.of.samples, pixelsText(part.data), pixelsText(box));
    return part;
}

std::vector<Part> orderedParts(std::vector<Part> parts) {
    for (std::size_t i = 1; i < parts.size(); ++i) requireSame(parts[0], parts[i]);
    std::ranges::sort(parts, {}, [](const Part& part) {
        return std::tuple(part.data.y0, part.data.x0, part.data.y1, part.data.x1, part.first, part.last);
    });
    Faults faults;
    std::vector<const Part*> tiles;  // a part of each
    for (auto part = parts.begin(); part != parts.end();) {
        const auto end = std::find_if_not(part, parts.end(), [&](const Part& other) { return sameTile(*part, other); });
        checkSamples(&*part, &*part + (end - part), faults);
        tiles.push_back(&*part);
        part = end;
    }
    checkOverlaps(tiles, faults);
    checkGaps(tiles, parts.front().of.picture, faults);
    faults.throwIfAny();
    return parts;
}

Notices noticesOf(const std::vector<Part>& ordered) {
    Notices notices;
    const auto warn = [&notices](std::string text) { notices.push_back({Notice::Kind::Warning, std::move(text)}); };
    for (const char* name : {"device", "driver"}) {
        std::set<std::string> kinds;
        for (const Part& part : ordered)
            if (const auto* text = find<std::string>(part.metadata, name)) kinds.insert(*text);
        if (kinds.size() > 1)
            warn(fmt::format("the parts were rendered by more than one {}: {}; their last bits may be those of none",
                             name, fmt::join(kinds, ", ")));
    }
    // What an invocation leaves to the second pass depends on the pixels that it has: see NEXT_PIXEL_STEPS.
    const auto depends = std::ranges::find_if(ordered, [&](const Part& part) {
        return part.of.turns != ordered.front().of.turns ||
               (part.of.turns > 1 && !isAligned(part.data, part.of.picture));
    });
    if (depends != ordered.end())
        warn(
            fmt::format("{}: its invocations took other pixels together than those of the whole picture do; where "
                        "searches are long, last bits may differ",
                        depends->path.string()));
    return notices;
}

}  // namespace dsphere::cli
