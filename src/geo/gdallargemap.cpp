#include "geo/largemap.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <span>
#include <thread>
#include <utility>

#include "base/parallel.h"
#include "geo/blockcache.h"
#include "geo/fileidentity.h"
#include "geo/gdalhead.h"
#include "geo/gdalwindows.h"
#include "image/codecs.h"
#include "image/tiffcheck.h"

namespace dsphere::geo {
namespace {

/// How the samples of a map are handed out.
struct Coding {
    SampleKind kind = SampleKind::Float32;
    std::optional<int> unknown_code = {};
};

/// Integers of at most 16 bits stay such where a code can say "unknown": the nodata value, or one that they never take.
Coding codingOf(const MapHead& head, bool has_rows_beyond) {
    const SampleType& sample = head.sample;
    if (sample.is_float || sample.bits > 16) return {};
    const SampleKind kind = sample.is_signed ? SampleKind::Int16 : SampleKind::UInt16;
    const double greatest = sample.fullScale(), least = sample.is_signed ? -greatest - 1.0 : 0.0;
    const std::optional<double>& nodata = head.unknown.value;
    if (nodata && *nodata >= least && *nodata <= greatest && *nodata == std::floor(*nodata))
        return {kind, int(*nodata)};
    if (!head.unknown.mask && !has_rows_beyond) return {kind};
    if (sample.bits == 16) return {};
    return {kind, sample.is_signed ? -32768 : 65535};
}

template <typename Sample>
void mirrorRows(Sample* samples, int width, int height) {
    for (int j = 0; j < height; ++j, samples += width) std::reverse(samples, samples + width);
}

template <typename Sample>
void flipRows(Sample* samples, int width, int height) {
    for (int j = 0; j < height / 2; ++j)
        std::swap_ranges(samples + std::ptrdiff_t(j) * width, samples + std::ptrdiff_t(j + 1) * width,
                         samples + std::ptrdiff_t(height - 1 - j) * width);
}

class GdalLargeMap : public LargeMap {
  public:
    GdalLargeMap(std::unique_ptr<Handle> first, MapHead head)
        : file_(first->file.file),
          file_width_(first->file.width()),
          file_height_(first->file.height()),
          head_(std::move(head)),
          coding_(codingOf(head_, head_.placed.rows > file_height_)),
          files_(filesOf(first->file)),
          block_(first->block),
          handles_(std::move(first), [this] { return reopen(); }) {
        handles_.with([&](const Handle& handle) {
            float last = 0.0f;  // texel of the file, which is there when the file is whole
            handle.fetch(handle.band, {file_width_ - 1, file_height_ - 1, 1, 1}, &last, GDT_Float32, 0);
        });
    }

    const RawMap& head() const override { return head_.map; }
    SampleKind kind() const override { return coding_.kind; }
    std::optional<int> unknownCode() const override { return coding_.unknown_code; }
    void read(int x, int y, int width, int height, void* to) const override {
        withSampleType(coding_.kind, [&](auto sample) {
            readAs({x, y, width, height}, static_cast<decltype(sample)*>(to));
        });
    }
    std::vector<float> overview(int columns, int rows) const override {
        const Placement& placed = head_.placed;
        std::vector<float> samples(std::size_t(columns) * std::size_t(rows), unknown<float>());
        // Rows of the overview whose middles the file covers.
        const auto firstFrom = [&](int row) { return int(std::ceil(double(row) * rows / placed.rows - 0.5)); };
        const int top = std::max(firstFrom(placed.rows_above), 0);
        const int bottom = std::min(firstFrom(placed.rows_above + file_height_), rows);
        // A band a core: GDAL decodes the blocks at bands' ends twice.
        const int bands = int(std::max(1u, std::thread::hardware_concurrency()));
        parallelFor(std::size_t(bands), [&](std::size_t band) {
            const auto rowAt = [&](int k) { return top + int(std::int64_t(bottom - top) * k / bands); };
            const int begin = rowAt(int(band)), end = rowAt(int(band) + 1);
            if (begin < end) readOverview(columns, rows, begin, end, samples.data());
        });
        return samples;
    }
    std::string identity() const override { return identityOf(files_) + fmt::format("-{}", head_.bands[0]); }

  private:
    static std::vector<std::filesystem::path> filesOf(const OpenMap& open) {
        const std::filesystem::path& path = open.file.path;
        std::vector<std::filesystem::path> files{path, open.file.label, path.string() + ".aux.xml"};
        if (const std::string world = worldFileOf(path); !world.empty()) files.push_back(path.parent_path() / world);
        std::ranges::move(open.files(), std::back_inserter(files));
        std::erase_if(files, [](const auto& file) { return !std::filesystem::is_regular_file(file); });
        std::ranges::sort(files);
        files.erase(std::unique(files.begin(), files.end()), files.end());
        return files;
    }

    std::unique_ptr<Handle> reopen() const {
        auto handle = std::make_unique<Handle>(Handle{openMap(file_, true)});
        if (handle->file.width() != file_width_ || handle->file.height() != file_height_ ||
            handle->file.bands() < head_.bands[0])
            throwInvalid("{}: {}: has changed since it was opened: it had {}x{} texels, now {}x{}", handle->file.name(),
                         nameOf(file_.format), file_width_, file_height_, handle->file.width(), handle->file.height());
        handle->setBand(head_.bands[0]);
        if (head_.unknown.mask) handle->mask = gdal().GDALGetMaskBand(handle->band);
        return handle;
    }

    template <typename Sample>
    Sample unknown() const {
        if constexpr (std::is_floating_point_v<Sample>) return std::numeric_limits<Sample>::quiet_NaN();
        return Sample(coding_.unknown_code.value_or(0));
    }

    template <typename Sample>
    void readAs(const Window& window, Sample* to) const {
        const Placement& placed = head_.placed;
        assert(window.x >= 0 && window.y >= 0 && window.x + window.width <= placed.columns &&
               window.y + window.height <= placed.rows);
        const int top = std::clamp(placed.rows_above, window.y, window.y + window.height);
        const int bottom = std::clamp(placed.rows_above + file_height_, top, window.y + window.height);
        const std::ptrdiff_t width = window.width;
        std::fill(to, to + (top - window.y) * width, unknown<Sample>());
        std::fill(to + (bottom - window.y) * width, to + window.height * width, unknown<Sample>());
        if (top == bottom || width == 0) return;
        Window of_file{window.x, top - placed.rows_above, window.width, bottom - top};
        if (placed.mirrored) of_file.x = placed.columns - window.x - window.width;
        if (placed.flipped) of_file.y = file_height_ - of_file.y - of_file.height;
        Sample* known = to + (top - window.y) * width;
        const auto placeOf = [&](const Window& piece) {
            return known + (piece.y - of_file.y) * width + (piece.x - of_file.x);
        };
        if (sharesBlocks(of_file))
            forPieces(of_file, block_, 1, [&](const Window& piece) { copyPiece(piece, placeOf(piece), width); });
        else
            handles_.with([&](const Handle& handle) {
                forPieces(of_file, block_, kPieceTexels,
                          [&](const Window& piece) { readPiece(handle, piece, placeOf(piece), width); });
            });
        if (placed.mirrored) mirrorRows(known, of_file.width, of_file.height);
        if (placed.flipped) flipRows(known, of_file.width, of_file.height);
    }

    /// Rows [begin, end) of an overview of columns x rows, which the file covers.
    void readOverview(int columns, int rows, int begin, int end, float* to) const {
        const Placement& placed = head_.placed;
        const auto fileRow = [&](int row) {
            return std::clamp(int(std::int64_t(row) * placed.rows / rows) - placed.rows_above, 0, file_height_);
        };
        Window window{0, fileRow(begin), placed.columns, 0};
        window.height = std::max(fileRow(end) - window.y, 1);
        if (placed.flipped) window.y = file_height_ - window.y - window.height;
        const int height = end - begin;
        float* const band = to + std::ptrdiff_t(begin) * columns;
        handles_.with([&](const Handle& handle) {
            const std::vector<double> stored = handle.fetchReduced(handle.band, window, columns, height);
            std::vector<double> known(stored.size(), 1.0);
            if (handle.mask) known = handle.fetchReduced(handle.mask, window, columns, height);
            for (std::size_t i = 0; i < stored.size(); ++i) {
                const double value = stored[i] - (head_.sample.signed_bytes && stored[i] > 127.0 ? 256.0 : 0.0);
                band[i] = known[i] == 0.0 || head_.unknown.is(value) ? unknown<float>() : float(value);
            }
        });
        if (placed.mirrored) mirrorRows(band, columns, height);
        if (placed.flipped) flipRows(band, columns, height);
    }

    /// Whether a window is likely to have blocks in common with those beside it, which are worth keeping.
    bool sharesBlocks(const Window& window) const {
        return std::int64_t(window.width) * window.height <= kPieceTexels &&
               std::int64_t(block_.width) * block_.height <= kPieceTexels;
    }

    /// Of a part of one block, by way of the whole one.
    template <typename Sample>
    void copyPiece(const Window& piece, Sample* to, std::ptrdiff_t stride) const {
        const std::int64_t across = (file_width_ + block_.width - 1) / block_.width;
        const int column = piece.x / block_.width, row = piece.y / block_.height;
        Window whole{column * block_.width, row * block_.height, block_.width, block_.height};
        whole.width = std::min(whole.width, file_width_ - whole.x);
        whole.height = std::min(whole.height, file_height_ - whole.y);
        const std::size_t bytes = std::size_t(whole.width) * std::size_t(whole.height) * sizeof(Sample);
        const BlockCache::Samples samples = blocks_.get(row * across + column, bytes, [&](std::byte* read) {
            handles_.with(
                [&](const Handle& handle) { readPiece(handle, whole, reinterpret_cast<Sample*>(read), whole.width); });
        });
        const Sample* from = reinterpret_cast<const Sample*>(samples->data());
        from += std::ptrdiff_t(piece.y - whole.y) * whole.width + (piece.x - whole.x);
        for (int j = 0; j < piece.height; ++j) std::copy_n(from + j * whole.width, piece.width, to + j * stride);
    }

    /// `to` has rows of `stride` samples.
    template <typename Sample>
    void readPiece(const Handle& handle, const Window& piece, Sample* to, std::ptrdiff_t stride) const {
        if constexpr (std::is_floating_point_v<Sample>) {
            readFloats(handle, piece, to, stride);
        } else {
            const GDALDataType type = std::is_signed_v<Sample> ? GDT_Int16 : GDT_UInt16;
            handle.fetch(handle.band, piece, to, type, std::size_t(stride) * sizeof(Sample));
            for (int j = 0; head_.sample.signed_bytes && j < piece.height; ++j)
                for (Sample& s : std::span(to + j * stride, std::size_t(piece.width))) s = Sample(std::int8_t(s));
        }
        if (!handle.mask) return;
        std::vector<std::uint8_t> mask(std::size_t(piece.width) * std::size_t(piece.height));
        handle.fetch(handle.mask, piece, mask.data(), GDT_Byte, 0);
        const std::uint8_t* known = mask.data();
        for (int j = 0; j < piece.height; ++j)
            for (Sample& s : std::span(to + j * stride, std::size_t(piece.width)))
                if (*known++ == 0) s = unknown<Sample>();
    }

    /// By way of doubles, so that what a float does not hold is rounded once, and compared with nodata as it is stored.
    void readFloats(const Handle& handle, const Window& piece, float* to, std::ptrdiff_t stride) const {
        std::vector<double> stored(std::size_t(piece.width) * std::size_t(piece.height));
        handle.fetch(handle.band, piece, stored.data(), GDT_Float64, 0);
        const double* from = stored.data();
        for (int j = 0; j < piece.height; ++j)
            for (float& s : std::span(to + j * stride, std::size_t(piece.width))) {
                s = head_.unknown.is(*from) ? unknown<float>() : float(*from);
                ++from;
            }
    }

    PlacedFile file_;
    int file_width_, file_height_;
    MapHead head_;
    Coding coding_;
    std::vector<std::filesystem::path> files_;
    Block block_;
    mutable BlockCache blocks_;
    mutable Handles handles_;
};

constexpr int kMostSide = 131072;
constexpr std::uint64_t kMostTexels = std::uint64_t(131072) * 65536;

void checkLargeSize(const OpenMap& open, int width, int height) {
    if (width > kMostSide || height > kMostSide || std::uint64_t(width) * std::uint64_t(height) > kMostTexels)
        throwInvalid("{}: {}: the size is {}x{}, expected sides of at most {} and at most {} texels", open.name(),
                     nameOf(open.file.format), width, height, kMostSide, kMostTexels);
}

/// The greatest absolute value that a sample can have; 0 where a type says nothing of it because its range is far
/// beyond that of heights.
double greatestOf(const SampleType& sample) {
    return sample.is_float || sample.bits > 16 ? 0.0 : sample.fullScale() + 1.0;
}

/// `placed`: the file's words about its place count, as in readHead().
std::shared_ptr<const LargeMap> openWindows(const PlacedFile& file, std::optional<int> band, std::uint64_t least_texels,
                                            bool placed) {
    const Gdal& g = gdal();
    auto handle = std::make_unique<Handle>(Handle{openMap(file, true)});
    const OpenMap& open = handle->file;
    MapHead head = readHead(open, band, placed);
    if (std::uint64_t(head.map.width) * std::uint64_t(head.map.height) < least_texels) return nullptr;
    handle->setBand(head.bands[0]);
    handle->mask = head.unknown.mask;
    if (head.bands.size() > 1 || g.GDALGetRasterColorTable(handle->band)) return nullptr;
    checkLargeSize(open, open.width(), open.height());
    checkLargeSize(open, head.map.width, head.map.height);
    if (file.format == PlacedFile::Format::Tiff) {
        InputFile in(file.path);
        checkTiffBlocks(in);
    }
    completeHead(head, open, greatestOf(head.sample));
    if (!head.sample.isExact())
        head.map.notices.push_back({Notice::Kind::Note, open.name() + ": values that need more than the 24 bits of a "
                                                                      "float are rounded"});
    constexpr GIntBig kCacheBytes = 48 << 20;
    g.GDALSetCacheMax64(kCacheBytes);
    return std::make_shared<GdalLargeMap>(std::move(handle), std::move(head));
}

bool canLoadGdal() try {
    gdal();
    return true;
} catch (const Error&) {
    return false;
}

}  // namespace

std::shared_ptr<const LargeMap> openLargeMap(const std::filesystem::path& path, std::optional<int> band,
                                             std::uint64_t least_texels) {
    if (const std::optional<FileForGdal> found = fileForGdal(path, band)) try {
            if (found->file.format == PlacedFile::Format::AsciiGrid) return nullptr;
            return openWindows(found->file, band, least_texels, true);
        } catch (const Error& error) {
            throw withReason(error, *found);
        }
    InputFile file(path);
    if (formatOf(file) != MapFormat::Tiff) return nullptr;
    const TiffPage page = tiffPageOf(file);
    if (!page.plain_grey || page.width * page.height < least_texels || !canLoadGdal()) return nullptr;
    return openWindows({PlacedFile::Format::Tiff, path, {}}, band, least_texels, false);
}

}  // namespace dsphere::geo
