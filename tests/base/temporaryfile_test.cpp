#include "base/temporaryfile.h"

#include "base/atomicfile.h"
#include "base/error.h"
#include "tests/support/tempfolder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <optional>

namespace dsphere {
namespace {

namespace fs = std::filesystem;

class Temporary : public testing::Test {
  protected:
    fs::path target() const { return folder_.path() / "map.tif"; }
    std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(folder_.path()), {}); }
    static void fill(const fs::path& path, const char* text) { std::ofstream(path) << text; }
    static std::string textOf(const fs::path& path) {
        std::ifstream in(path);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    test::TempFolder folder_;
};

TEST_F(Temporary, TakesTheTargetsPlaceOrLeavesNothing) {
    {
        TemporaryFile file(target());
        fill(file.name(), "half");
    }
    EXPECT_EQ(files(), 0);
    TemporaryFile file(target());
    fill(file.name(), "whole");
    EXPECT_FALSE(fs::exists(target()));
    file.commit();
    EXPECT_EQ(textOf(target()), "whole");
    EXPECT_EQ(files(), 1);
}

TEST_F(Temporary, WhoEndsAtOnceRemovesIt) {
    TemporaryFile file(target());
    fill(file.name(), "half");
    removeTemporaryFiles();
    EXPECT_EQ(files(), 0);
}

TEST_F(Temporary, TheNextRemovesWhatAKilledProcessLeft) {
    const fs::path left = temporaryName(target());
    fill(left, "half");
    TemporaryFile file(target());
    EXPECT_FALSE(fs::exists(left));
    fill(temporaryName(target()), "half");
    AtomicFile other(folder_.path() / "other");
    EXPECT_EQ(files(), 1) << "the living one stays";
    EXPECT_TRUE(fs::exists(file.name()));
}

TEST_F(Temporary, FollowsLinksAndLeavesReadOnlyFiles) {
    fill(target(), "old");
    fs::create_symlink(target(), folder_.path() / "link");
    {
        TemporaryFile file(folder_.path() / "link");
        fill(file.name(), "new");
        file.commit();
    }
    EXPECT_TRUE(fs::is_symlink(folder_.path() / "link"));
    EXPECT_EQ(textOf(target()), "new");
    fs::permissions(target(), fs::perms(0444));
    EXPECT_THROW(TemporaryFile file(target()), Error);
    EXPECT_EQ(textOf(target()), "new");
}

}  // namespace
}  // namespace dsphere
