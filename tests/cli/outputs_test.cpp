// No output takes the place of an input, of another output, or of what may not be written.

#include "image/picture.h"
#include "tests/cli/fixture.h"

#include <sys/stat.h>

namespace dsphere::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

class OutputsTest : public CliTest {
  protected:
    OutputsTest() {
        Image image;
        image.data = image.display = {0, 0, 8, 4};
        for (const char* name : {"R", "G", "B"}) image.addFloat(name).floats().assign(32, 0.25f);
        writePng(path("earth.png"), image);
        writeExr(path("sky.exr"), image, {});
        fs::create_directory(path("parts"));
        folder_.write("parts/light.pbrt", "LightSource \"infinite\" \"string filename\" \"../sky.exr\"\n");
        folder_.write("full.pbrt", planet() +
                                       "Texture \"earth\" \"spectrum\" \"imagemap\" \"string filename\" \"earth.png\"\n"
                                       "Material \"diffuse\" \"texture reflectance\" \"earth\"\n"
                                       "Translate 1 0 0\n"
                                       "Shape \"sphere\" \"float radius\" .1\n"
                                       "Include \"parts/light.pbrt\"\n");
    }

    /// The run must fail before any work, name both files, and leave all as it was.
    void expectRefused(const Words& words, const std::string& output, const std::string& input) {
        std::map<fs::path, std::string> before = contents();
        Outcome outcome = run(words);
        expectFailure(outcome, 2, output);
        EXPECT_TRUE(holds(outcome.err, input));
        EXPECT_EQ(contents(), before) << outcome.err;
    }

    std::map<fs::path, std::string> contents() const {
        std::map<fs::path, std::string> all;
        for (const auto& entry : fs::recursive_directory_iterator(folder_.path()))
            if (entry.is_regular_file()) all[entry.path()] = readBytes(entry.path());
        return all;
    }
};

TEST_F(OutputsTest, NoInputOfARenderIsReplaced) {
    fs::copy_file(path("earth.png"), path("map.png"));
    expectRefused({"render", "map.png", "-o", "map.png"}, "map.png",
                  "--outfile would replace map.png, which is a heightmap");
    expectRefused({"render", "map.png", "-o", "./map.png"}, "./map.png: --outfile", "would replace map.png");
    expectRefused({"render", "map.png", "-o", path("map.png").string()}, path("map.png").string(), "replace map.png");
    expectRefused({"render", "full.pbrt", "-o", "earth.png"}, "earth.png", "which is an image");
    expectRefused({"render", "full.pbrt", "-o", "sky.exr"}, "sky.exr", "which is a light's image");
    expectRefused({"bench", "full.pbrt", "--csv", "full.pbrt"}, "full.pbrt: --csv", "which is the scene");
}

TEST_F(OutputsTest, NorByTheScenesOwnFilm) {
    folder_.write("own.pbrt",
                  "Film \"rgb\" \"string filename\" \"map.png\"\n"
                  "WorldBegin\n"
                  "Shape \"displacedsphere\" \"string displacementmap\" \"map.png\"\n");
    fs::copy_file(path("earth.png"), path("map.png"));
    expectRefused({"render", "own.pbrt"}, "map.png: the scene's Film would replace", "which is a heightmap");
}

TEST_F(OutputsTest, NamesAndLinksDoNotHideAnInput) {
    fs::create_symlink("earth.png", path("link.png"));
    fs::create_hard_link(path("earth.png"), path("second.png"));
    expectRefused({"render", "full.pbrt", "-o", "link.png"}, "link.png", "earth.png");
    expectRefused({"render", "full.pbrt", "-o", "second.png"}, "second.png", "earth.png");
    expectRefused({"render", "full.pbrt", "-o", "parts/../earth.png"}, "parts/../earth.png", "would replace");
    fs::rename(path("parts/light.pbrt"), path("parts/light.png"));
    folder_.write("short.pbrt", planet() + "Include \"parts/light.png\"\n");
    expectRefused({"render", "short.pbrt", "-o", "parts/light.png"}, "parts/light.png", "which is an included file");
}

TEST_F(OutputsTest, EveryOutputOfEveryCommand) {
    fs::create_symlink("sky.exr", path("v-difference.exr"));
    expectRefused({"verify", "full.pbrt", "-o", "v"}, "v-difference.exr: the difference would replace", "sky.exr");
    expectRefused({"diff", "sky.exr", "sky.exr", "-o", "sky.exr"}, "sky.exr", "which is picture A");
    fs::copy_file(path("earth.png"), path("piece.tif"));
    expectRefused({"import", "piece.tif", "map.pgm", "./piece.tif"}, "piece.tif", "which is an input");
    expectRefused({"bench", "full.pbrt", "--csv", "earth.png"}, "earth.png: --csv would replace", "an image");
    expectRefused({"bench", "--baseline", "sky.exr", "--json-file", "sky.exr"}, "sky.exr", "the baseline");
    expectRefused({"bench", "--csv", "new.txt", "--html", "./new.txt"}, "./new.txt",
                  "--csv and --html name the same file");
    expectRefused({"bench", "--csv", "new.svg", "--markdown", "new.md"}, "new.svg", "the same file");
}

TEST_F(OutputsTest, WhatIsReadOnlyStays) {
    folder_.write("old.exr", "old");
    fs::permissions(path("old.exr"), fs::perms::owner_read);
    expectFailure(run({"render", "planet.pbrt", "-o", "old.exr"}), 1,
                  "old.exr: cannot be written: it exists and is read-only");
    EXPECT_EQ(readBytes(path("old.exr")), "old");
}

TEST_F(OutputsTest, ALinkStaysAndItsTargetIsWritten) {
    fs::create_symlink("parts/real.exr", path("link.exr"));
    for (int times = 0; times < 2; ++times) {  // the first makes the target, the second replaces it
        ASSERT_EQ(run({"render", "planet.pbrt", "-o", "link.exr"}).code, 0);
        EXPECT_TRUE(fs::is_symlink(path("link.exr")));
        EXPECT_FALSE(fs::is_symlink(path("parts/real.exr")));
        EXPECT_EQ(readExr(path("parts/real.exr")).data, (Box{0, 0, kWidth, kHeight}));
    }
}

TEST_F(OutputsTest, PermissionsArePassedOn) {
    folder_.write("old.exr", "old");
    fs::permissions(path("old.exr"), fs::perms::owner_read | fs::perms::owner_write);
    ASSERT_EQ(run({"render", "planet.pbrt", "-o", "old.exr"}).code, 0);
    EXPECT_EQ(fs::status(path("old.exr")).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(OutputsTest, ResumingReplacesWhatItGoesOnFrom) {
    ASSERT_EQ(run({"render", "planet.pbrt", "-o", "a.exr", "--spp", "1"}).code, 0);
    EXPECT_EQ(run({"render", "planet.pbrt", "-o", "./a.exr", "--spp", "2", "--resume", "a.exr"}).code, 0);
}

// A killed process's file; the lock of a living one would keep it.
TEST_F(OutputsTest, LeftoversOfKilledRunsAreRemoved) {
    folder_.write(".dsphere-0123456789abcdef.tmp", "half a picture");
    folder_.write(".dsphere-notes.tmp", "a user's own");
    ASSERT_EQ(run({"render", "planet.pbrt", "-o", "a.exr", "--spp", "1"}).code, 0);
    EXPECT_FALSE(exists(".dsphere-0123456789abcdef.tmp"));
    EXPECT_TRUE(exists(".dsphere-notes.tmp"));
}

}  // namespace
}  // namespace dsphere::test
