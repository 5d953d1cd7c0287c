#pragma once

// EXR files of tiles, halves and other windows, as other programs write them, for tests.

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfTiledOutputFile.h>
#include <half.h>

#include <cstdint>
#include <filesystem>
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

/// `tile` 0: scanlines. The display window is the data window unless it is given.
template <typename Sample>
std::string exrFile(const Box& window, const ExrPlanes<Sample>& planes, int tile = 0,
                    Imf::Compression compression = Imf::ZIP_COMPRESSION, const Box& display = {}) {
    const Imath::Box2i data({window.x0, window.y0}, {window.x1 - 1, window.y1 - 1});
    const Box& whole = display.width() > 0 ? display : window;
    Imf::Header header(Imath::Box2i({whole.x0, whole.y0}, {whole.x1 - 1, whole.y1 - 1}), data);
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

/// Parts of those names and types of 2x1 pixels in a channel Y; all are scanlines of 1, deep ones stay empty.
inline void writeExrParts(const std::filesystem::path& path, const std::vector<std::string>& names,
                          const std::vector<std::string>& types) {
    std::vector<Imf::Header> headers(names.size(), Imf::Header(2, 1));
    for (std::size_t k = 0; k < names.size(); ++k) {
        headers[k].setName(names[k]);
        headers[k].setType(types[k]);
        headers[k].compression() = Imf::ZIPS_COMPRESSION;
        headers[k].channels().insert("Y", Imf::Channel(Imf::FLOAT));
    }
    Imf::MultiPartOutputFile file(path.c_str(), headers.data(), int(headers.size()));
    const std::vector<float> pixels{1, 1};
    Imf::FrameBuffer buffer;
    buffer.insert("Y", Imf::Slice::Make(Imf::FLOAT, pixels.data(), headers[0].dataWindow()));
    for (std::size_t k = 0; k < names.size(); ++k) {
        if (types[k] != Imf::SCANLINEIMAGE) continue;
        Imf::OutputPart part(file, int(k));
        part.setFrameBuffer(buffer);
        part.writePixels(1);
    }
}

}  // namespace dsphere::test
