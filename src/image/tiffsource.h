#pragma once

// A TIFF file opened with libtiff. Everything hangs on one handle: its input, its messages and its memory limit;
// libtiff's global handlers are left alone, so that any number of maps may be read at once.

#include <tiffio.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>

#include "image/inputfile.h"
#include "image/mappedfile.h"

namespace dsphere {

/// What libtiff calls back with; must outlive the handle.
struct TiffSource {
    InputFile& file;
    std::uint64_t position = 0;            ///< may lie beyond the end
    std::array<char, 256> reason{};        ///< the first error told
    std::unique_ptr<MappedFile> mapped{};  ///< the file in memory, if it is large

    /// Throws, with the reason if libtiff told one.
    [[noreturn]] void fail(std::string_view what) const;
    /// Throws if another program cut the file short while it was read.
    void checkIsWhole() const;
    /// Gives back the memory of what has been read of a large file; it is read again where it is needed again.
    void forget() const;
};

struct CloseTiff {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
    void operator()(TIFFOpenOptions* options) const { TIFFOpenOptionsFree(options); }
};
using TiffHandle = std::unique_ptr<TIFF, CloseTiff>;

/// Opens the first page. `most_memory` is the most that libtiff may allocate at once. Throws when it cannot.
TiffHandle openTiff(TiffSource& source, std::uint64_t most_memory);

}  // namespace dsphere
