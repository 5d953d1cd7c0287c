#include "image/exrlayers.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>

#include "base/error.h"

namespace dsphere {
namespace {

using Names = std::vector<std::string>;

constexpr const char* kExpected = "expected Y, or R, G and B, or a single channel, in one layer of any name";

std::string lowerCase(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return text;
}

/// The channels of a layer by their own names in lower case, long ones of colours shortened: "r" for "Layer.red".
struct Layer {
    std::map<std::string, ExrChannel> channels;

    bool has(const std::string& name) const { return channels.contains(name); }
    const std::string& full(const std::string& name) const { return channels.at(name).name; }
    /// Displacement or normals: X with Y or Z.
    bool isVectors() const { return has("x") && (has("y") || has("z")); }
};

std::string shortName(const std::string& name) {
    static const std::map<std::string, std::string> kShort{{"red", "r"}, {"green", "g"}, {"blue", "b"}, {"alpha", "a"}};
    const auto found = kShort.find(name);
    return found == kShort.end() ? name : found->second;
}

std::map<std::string, Layer> layersOf(const std::vector<ExrChannel>& channels) {
    std::map<std::string, Layer> layers;
    for (const ExrChannel& channel : channels) {
        const std::size_t dot = channel.name.rfind('.');
        const bool plain = dot == std::string::npos;
        const std::string layer = plain ? "" : channel.name.substr(0, dot);
        const std::string own = lowerCase(plain ? channel.name : channel.name.substr(dot + 1));
        layers[layer].channels.emplace(shortName(own), channel);
    }
    return layers;
}

bool isId(const std::string& name, const ExrChannel& channel) {
    static constexpr std::array kHeights{"r", "g", "b", "y", "z", "height", "elevation", "displacement", "depth"};
    return channel.uint && std::ranges::find(kHeights, name) == kHeights.end();
}

ExrChoice choiceOf(const std::string& layer, const Layer& channels, const Names& names) {
    ExrChoice choice{layer, {}, {}, {}};
    for (const std::string& name : names) choice.values.push_back(channels.full(name));
    if (channels.has("a")) choice.alpha = channels.full("a");
    return choice;
}

/// What could be heights in a layer.
std::vector<ExrChoice> candidatesOf(const std::string& name, const Layer& layer) {
    if (lowerCase(name).find("crypto") != std::string::npos) return {};
    if (layer.has("r") && layer.has("g") && layer.has("b")) return {choiceOf(name, layer, {"r", "g", "b"})};
    if (layer.isVectors()) return {};
    if (layer.has("y")) return {choiceOf(name, layer, {"y"})};
    std::vector<ExrChoice> candidates;
    for (const auto& [own, channel] : layer.channels)
        if (own != "a" && !isId(own, channel)) candidates.push_back(choiceOf(name, layer, {own}));
    return candidates;
}

std::string listOf(const std::vector<ExrChannel>& channels) {
    Names names;
    for (const ExrChannel& channel : channels) names.push_back(channel.name);
    return fmt::format("{}", fmt::join(names, ", "));
}

[[noreturn]] void refuseAll(const std::vector<ExrChannel>& channels, const std::map<std::string, Layer>& layers) {
    if (std::ranges::any_of(layers, [](const auto& layer) { return layer.second.isVectors(); }))
        throwInvalid("X, Y and Z are vectors (displacement or normals), not heights: it has the channels {}; {}",
                     listOf(channels), kExpected);
    if (std::ranges::any_of(channels, &ExrChannel::uint))
        throwInvalid("channels of type UINT are ids, not heights: it has the channels {}; {}", listOf(channels),
                     kExpected);
    throwInvalid("it has the channels {}; {}", listOf(channels), kExpected);
}

ExrChoice onlyOne(std::vector<ExrChoice> candidates, const std::vector<ExrChannel>& channels, const char* what) {
    if (candidates.size() > 1) {
        Names names;
        for (const ExrChoice& candidate : candidates)
            names.push_back(fmt::format("{}", fmt::join(candidate.values, " ")));
        throwInvalid("several of its channels could be {}: {}; {}", what, fmt::join(names, ", "), kExpected);
    }
    ExrChoice choice = std::move(candidates.at(0));
    for (const ExrChannel& channel : channels)
        if (channel.name != choice.alpha && std::ranges::find(choice.values, channel.name) == choice.values.end())
            choice.others.push_back(channel.name);
    return choice;
}

}  // namespace

ExrChoice chooseHeights(const std::vector<ExrChannel>& channels) {
    const auto layers = layersOf(channels);
    std::vector<ExrChoice> candidates;
    for (const auto& [name, layer] : layers)
        std::ranges::copy(candidatesOf(name, layer), std::back_inserter(candidates));
    if (candidates.empty()) refuseAll(channels, layers);
    return onlyOne(std::move(candidates), channels, "heights");
}

ExrChoice chooseColours(const std::vector<ExrChannel>& channels) {
    std::vector<ExrChoice> candidates;
    for (const auto& [name, layer] : layersOf(channels)) {
        // The layer without a name comes first.
        if (!candidates.empty() && candidates[0].layer.empty()) break;
        for (ExrChoice& candidate : candidatesOf(name, layer))
            if (candidate.values.size() == 3) candidates.push_back(std::move(candidate));
    }
    if (candidates.empty()) return chooseHeights(channels);
    return onlyOne(std::move(candidates), channels, "colours");
}

}  // namespace dsphere
