#pragma once

// EXR files of tiles, halves and other windows, as other programs write them, for tests.

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfTiledOutputFile.h>
#include <half.h>

#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/image.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {

template <typename Sample>
constexpr Imf::PixelType kExrType = std::is_same_v<Sample, half>    ? Imf::HALF
                                    : std::is_same_v<Sample, float> ? Imf::FLOAT
                                                                    : Imf::UINT;

/// Channels of one type and their row-major values.
template <typename Sample>
using ExrPlanes = std::vector<std::pair<std::string, std::vector<Sample>>>;

/// `tile` 0: scanlines.
template <typename Sample>
std::string exrFile(const Box& window, const ExrPlanes<Sample>& planes, int tile = 0,
                    Imf::Compression compression = Imf::ZIP_COMPRESSION) {
    const Imath::Box2i data({window.x0, window.y0}, {window.x1 - 1, window.y1 - 1});
    Imf::Header header(Imath::Box2i({0, 0}, {9, 9}), data);
    header.compression() = compression;
    Imf::FrameBuffer buffer;
    for (const auto& [name, samples] : planes) {
        header.channels().insert(name, Imf::Channel(kExrType<Sample>));
        buffer.insert(name, Imf::Slice::Make(kExrType<Sample>, samples.data(), data));
    }
    const TempFolder folder;
    const std::string path = (folder.path() / "made.exr").string();
    if (tile) {
        header.setTileDescription(Imf::TileDescription(unsigned(tile), unsigned(tile)));
        Imf::TiledOutputFile file(path.c_str(), header);
        file.setFrameBuffer(buffer);
        file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
    } else {
        Imf::OutputFile file(path.c_str(), header);
        file.setFrameBuffer(buffer);
        file.writePixels(window.height());
    }
    return readBytes(path);
}

}  // namespace dsphere::test
