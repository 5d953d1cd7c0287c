#include "image/rawmap.h"

#include <gtest/gtest.h>

#include "tests/image/encoders.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

std::string refusalOf(const std::filesystem::path& path) {
    const std::string message = messageOf(ExitCode::InvalidInput, [&] { readRawMap(path); });
    EXPECT_TRUE(holds(message, path.string()));
    return message;
}

TEST(RawMap, TellsWhyAFileCannotBeOpened) {
    const TempFolder folder;
    EXPECT_TRUE(holds(refusalOf(folder.path() / "missing.png"), "No such file"));
    EXPECT_TRUE(holds(refusalOf(folder.path()), "it is a folder"));
    EXPECT_TRUE(holds(refusalOf(folder.write("file", "x") / "below.png"), "Not a directory"));
    EXPECT_TRUE(holds(refusalOf("/dev/null"), "not a regular file"));
}

TEST(RawMap, ContentDecidesWhateverTheName) {
    const TempFolder folder;
    EXPECT_EQ(readRawMap(folder.write("a.gtx", pngFile(1, 1, 16, PngColour::Grey, {7}))).type, "16-bit PNG");
    EXPECT_EQ(readRawMap(folder.write("a.png", pnmFile(1, 1, 255, {7}))).type, "8-bit PGM");
    EXPECT_EQ(readRawMap(folder.write("a", pfmFile(1, 1, {7.0f}, true))).type, "float32 PFM");
    EXPECT_EQ(readRawMap(folder.write("b.gtx", gtxFile({}, std::vector<float>(40)))).type, "float32 GTX");
}

TEST(RawMap, RefusesOtherFormats) {
    const TempFolder folder;
    EXPECT_TRUE(holds(refusalOf(folder.write("a.tif", "II\x2b*0000")), "49 49 2b 2a"));
    EXPECT_TRUE(holds(refusalOf(folder.write("a.pbm", "P4 1 1 0")), "unknown format"));
    EXPECT_TRUE(holds(refusalOf(folder.write("a.dat", "x")), "unknown format"));
    EXPECT_TRUE(holds(refusalOf(folder.write("a.png", "")), "is empty"));
    // A GTX grid under another name has nothing to be known by.
    EXPECT_TRUE(holds(refusalOf(folder.write("a.bin", gtxFile({}, std::vector<float>(40)))), "named .gtx"));
}

}  // namespace
}  // namespace dsphere::test
