// The greatest map that devices hold opens within 700 MB: read by a process of its own, whose peak the system tells.

#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "image/rawmap.h"
#include "tests/image/tiffwriter.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

constexpr int kWidth = 16384, kHeight = 8192;

/// Noise that no codec shrinks, row by row.
void writeTiff(const std::filesystem::path& path, const TiffForm& form) {
    TIFF* tiff = TIFFOpen(path.c_str(), "w");
    ASSERT_NE(tiff, nullptr);
    setTiffFields<std::uint16_t>(tiff, form, kWidth, kHeight);
    TIFFSetField(tiff, TIFFTAG_ZIPQUALITY, 1);
    std::vector<std::uint16_t> row(kWidth);
    std::uint32_t state = 1;
    for (int j = 0; j < kHeight; ++j) {
        for (std::uint16_t& sample : row) sample = std::uint16_t((state = state * 1664525u + 1013904223u) >> 16);
        ASSERT_GE(TIFFWriteScanline(tiff, row.data(), std::uint32_t(j), 0), 0);
    }
    TIFFClose(tiff);
}

/// The peak memory of reading the map, bytes; 0 when it cannot be read.
std::uint64_t peakOfReading(const std::filesystem::path& path) {
    const pid_t child = fork();
    if (child == 0) {
        const RawMap map = readRawMap(path);
        _exit(map.samples.size() == std::size_t(kWidth) * kHeight ? 0 : 1);
    }
    int status = 1;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? std::uint64_t(usage.ru_maxrss) * 1024 : 0;
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

TEST(Memory, A16384WideTiffOpensWithin700MB) {
    if (kSanitized) GTEST_SKIP() << "the sanitizer's own memory counts";
    const TempFolder folder;
    const std::filesystem::path path = folder.path() / "large.tif";
    TiffForm one_strip;
    one_strip.compression = COMPRESSION_ADOBE_DEFLATE;
    one_strip.rows_per_strip = kHeight;
    writeTiff(path, one_strip);
    const std::uint64_t peak = peakOfReading(path);
    std::printf("a compressed strip of %d rows: %.0f MB at most\n", kHeight, double(peak) * 1e-6);
    EXPECT_GT(peak, std::uint64_t(kWidth) * kHeight * 4);
    EXPECT_LT(peak, 700'000'000u);
}

}  // namespace
}  // namespace dsphere::test
