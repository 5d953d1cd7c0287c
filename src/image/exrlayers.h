#pragma once

#include <string>
#include <vector>

namespace dsphere {

/// A channel of an EXR file's first part. A name is "R", or "LAYER.R".
struct ExrChannel {
    std::string name;
    bool uint = false;  ///< stored as UINT
};

/// Which channels of an EXR file are its heights or colours.
struct ExrChoice {
    std::string layer;                ///< "ViewLayer.Combined"; empty for channels without a layer
    std::vector<std::string> values;  ///< red, green and blue, or a single one
    std::string alpha;                ///< of the same layer; empty: none
    std::vector<std::string> others;  ///< all channels that are not chosen
};

/// Chooses the only channels that can be heights: in a layer of any name, R, G and B, or Y, or a single one beside A.
/// Throws Error (InvalidInput), which does not name the file, when there are none (X, Y and Z are vectors, UINT ones
/// are ids unless their name is that of a height, cryptomattes are ids too) or several.
ExrChoice chooseHeights(const std::vector<ExrChannel>& channels);

/// Chooses a colour image's channels: R, G and B without a layer, else those of the only layer that has them, else what
/// chooseHeights does.
ExrChoice chooseColours(const std::vector<ExrChannel>& channels);

}  // namespace dsphere
