#include "viewer/pathcompletion.h"

#include "tests/support/tempfolder.h"

#include <gtest/gtest.h>

namespace dsphere::viewer {
namespace {

TEST(PathCompletion, GoesOnAsFarAsAllAgree) {
    test::TempFolder folder;
    folder.write("moon-1.pbrt", "");
    folder.write("moon-2.pbrt", "");
    folder.write(".hidden", "");
    std::filesystem::create_directory(folder.path() / "maps");
    const std::string start = folder.path().string() + "/";
    const PathCompletions all = completionsOf(start);
    EXPECT_EQ(all.paths, (std::vector<std::string>{start + "maps/", start + "moon-1.pbrt", start + "moon-2.pbrt"}));
    EXPECT_EQ(all.common, start + "m");
    EXPECT_EQ(completionsOf(start + "mo").common, start + "moon-");
    EXPECT_EQ(completionsOf(start + "ma").common, start + "maps/");
    EXPECT_EQ(completionsOf(start + ".h").paths.size(), 1u);
    EXPECT_EQ(completionsOf(start + "mars").common, start + "mars") << "nothing begins so";
    EXPECT_TRUE(completionsOf("/no such folder/x").paths.empty());
}

}  // namespace
}  // namespace dsphere::viewer
