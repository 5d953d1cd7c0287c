#pragma once

// The parts of a picture, put together strip by strip.

#include "cli/parts.h"
#include "image/exrstream.h"

#include <memory>
#include <string>
#include <vector>

namespace dsphere::cli {

/// Parts as orderedParts() returns them. Strips are read from top to bottom.
class PartRows {
  public:
    explicit PartRows(std::vector<Part> ordered) : parts_(std::move(ordered)), readers_(parts_.size()) {}

    const Part& front() const { return parts_.front(); }
    const std::vector<Part>& parts() const { return parts_; }

    /// Rows y0 to y1 - 1 of the picture, with the channels of an undivided render. Error (InvalidInput).
    Image read(int y0, int y1);
    std::vector<ChannelKind> channels() const;

  private:
    /// Of the parts [begin, end), which are of one tile.
    Image readTile(std::size_t begin, std::size_t end, int y0, int y1);

    std::vector<Part> parts_;
    std::vector<std::unique_ptr<ExrReader>> readers_;  ///< open while their rows are read
};

/// Whether a channel is R, G, B or A.
bool isColour(const std::string& name);

/// An image of those pixels and channels, all 0.
Image emptyImage(const Box& data, const Box& display, const std::vector<ChannelKind>& channels);

/// Puts the pixels of `from` into `to`, which holds them and has its channels; numbers may become floats or integers.
void place(Image& to, const Image& from);

}  // namespace dsphere::cli
