#include "image/tiffsource.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <new>

// Nothing may be thrown through libtiff.

namespace dsphere {
namespace {

// A compressed strip is decoded from a copy of the whole of it, unless the file is mapped. Below this the copy does not
// matter.
constexpr std::uint64_t kLeastMapped = std::uint64_t(64) << 20;

tmsize_t readBytes(thandle_t handle, void* to, tmsize_t count) try {
    TiffSource& source = *static_cast<TiffSource*>(handle);
    if (source.position >= source.file.size()) return 0;
    source.file.seek(source.position);
    const auto wanted = std::size_t(std::min<std::uint64_t>(std::uint64_t(count), source.file.remaining()));
    source.file.read(to, wanted);
    source.position += wanted;
    return tmsize_t(wanted);
} catch (const std::exception&) {
    return -1;
}

tmsize_t writeNothing(thandle_t, void*, tmsize_t) {
    return 0;
}

toff_t seekTo(thandle_t handle, toff_t offset, int whence) {
    TiffSource& source = *static_cast<TiffSource*>(handle);
    const std::uint64_t from = whence == SEEK_CUR ? source.position : whence == SEEK_END ? source.file.size() : 0;
    return source.position = from + offset;
}

int keepOpen(thandle_t) {
    return 0;
}

toff_t sizeOf(thandle_t handle) {
    return static_cast<TiffSource*>(handle)->file.size();
}

int mapFile(thandle_t handle, void** base, toff_t* size) {
    TiffSource& source = *static_cast<TiffSource*>(handle);
    source.mapped = MappedFile::open(source.file.name(), source.file.size());
    if (!source.mapped) return 0;
    *base = source.mapped->data();
    *size = source.file.size();
    return 1;
}

void unmapFile(thandle_t handle, void*, toff_t) {
    static_cast<TiffSource*>(handle)->mapped.reset();
}

int keepError(TIFF*, void* user, const char*, const char* format, va_list arguments) {
    auto& reason = static_cast<TiffSource*>(user)->reason;
    if (reason[0] == '\0') std::vsnprintf(reason.data(), reason.size(), format, arguments);
    return 1;  // handled: nothing is printed
}

/// Warnings are of tags unknown to libtiff, GeoTIFF's for one.
int dropWarning(TIFF*, void*, const char*, const char*, va_list) {
    return 1;
}

}  // namespace

void TiffSource::fail(std::string_view what) const {
    checkIsWhole();
    file.invalid("TIFF: {}: {}", what, reason[0] ? reason.data() : "unknown reason");
}

void TiffSource::checkIsWhole() const {
    if (mapped && mapped->isCut()) file.invalid("was cut short while it was read");
}

void TiffSource::forget() const {
    if (mapped) mapped->forget();
}

TiffHandle openTiff(TiffSource& source, std::uint64_t most_memory) {
    const std::unique_ptr<TIFFOpenOptions, CloseTiff> options(TIFFOpenOptionsAlloc());
    if (!options) throw std::bad_alloc();
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keepError, &source);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), dropWarning, nullptr);
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), tmsize_t(most_memory));
    const char* mode = source.file.size() < kLeastMapped ? "rm" : "r";  // m: do not map
    TiffHandle tiff(TIFFClientOpenExt(source.file.name().c_str(), mode, &source, readBytes, writeNothing, seekTo,
                                      keepOpen, sizeOf, mapFile, unmapFile, options.get()));
    if (!tiff) source.fail("cannot be read");
    return tiff;
}

}  // namespace dsphere
