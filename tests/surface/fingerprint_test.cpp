#include "surface/fingerprint.h"

#include <gtest/gtest.h>

#include <set>

#include "scene/parser.h"
#include "tests/image/encoders.h"
#include "tests/support/pngwriter.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

class Fingerprint : public testing::Test {
  protected:
    Fingerprint() {
        writeMap("map.png", 7);
        writeMap("same.png", 7);
        writeMap("other.png", 8);
        folder_.write("sky.pfm", pfmFile(2, 1, {1, 2}, true));
        folder_.write("dusk.pfm", pfmFile(2, 1, {1, 3}, true));
    }
    void writeMap(const std::string& name, unsigned value) {
        folder_.write(name, pngFile(2, 1, 16, PngColour::Grey, {1, value}));
    }
    std::uint64_t of(const std::string& options, const std::string& world) {
        Scene scene = parseScene(options + "\nWorldBegin\n" + world, "a.pbrt", folder_.path());
        return fingerprint(scene, loadSceneMaps(scene));
    }
    static std::string planet(const std::string& map, const std::string& more = "") {
        return "Shape \"displacedsphere\" \"string displacementmap\" \"" + map + "\" \"float maxdispl\" 5 " + more +
               "\n";
    }

    const TempFolder folder_;
};

TEST_F(Fingerprint, IsOfWhatTheFilesHold) {
    const std::uint64_t one = of("", planet("map.png"));
    EXPECT_EQ(one, of("", planet("same.png")));
    EXPECT_EQ(one, of("Sampler \"a\" \"integer pixelsamples\" 99 \"integer seed\" 4", planet("map.png")));
    EXPECT_EQ(one, of("Film \"rgb\" \"string filename\" \"x.exr\"", "\n\n" + planet("map.png")));
    EXPECT_NE(one, of("", planet("other.png")));
}

TEST_F(Fingerprint, TellsEveryChange) {
    const std::string sphere = "Shape \"sphere\"\n", checks = "Texture \"t\" \"color\" \"checkerboard\" ";
    const std::pair<std::string, std::string> scenes[] = {
        {"", sphere},
        {"", "Shape \"disk\""},
        {"", sphere + sphere},
        {"", "Translate 0 0 1e-9 " + sphere},
        {"", "Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0]"},
        {"", planet("map.png", "\"float blur\" .1")},
        {"", planet("map.png", "\"bool smoothnormals\" true")},
        {"Camera \"perspective\" \"float fov\" 40", sphere},
        {"Film \"rgb\" \"integer xresolution\" 1281", sphere},
        {"Film \"rgb\" \"float cropwindow\" [0 1 0 .5]", sphere},
        {"Integrator \"path\" \"integer maxdepth\" 4", sphere},
        {"Integrator \"path\" \"bool regularize\" true", sphere},
        {"Integrator \"directlighting\"", sphere},
        {"PixelFilter \"gaussian\"", sphere},
        {"", "Material \"matte\" \"float sigma\" 1 " + sphere},
        {"", "Material \"mirror\" " + sphere},
        {"", "Material \"metal\" " + sphere},
        {"", "Material \"conductor\" " + sphere},
        {"", "Material \"plastic\" " + sphere},
        {"", checks + "Material \"matte\" \"texture Kd\" \"t\" " + sphere},
        {"", checks + "\"float uscale\" 2 Material \"matte\" \"texture Kd\" \"t\" " + sphere},
        {"", "LightSource \"point\" " + sphere},
        {"", "LightSource \"distant\" " + sphere},
        {"", "LightSource \"infinite\" " + sphere},
        {"", "LightSource \"infinite\" \"string filename\" \"sky.pfm\" " + sphere},
        {"", "LightSource \"infinite\" \"string filename\" \"dusk.pfm\" " + sphere},
        {"", "AreaLightSource \"diffuse\" " + sphere},
        {"", "AreaLightSource \"diffuse\" \"rgb L\" [1 1 .9] " + sphere},
    };
    std::set<std::uint64_t> seen;
    for (const auto& [options, world] : scenes) EXPECT_TRUE(seen.insert(of(options, world)).second) << options << world;
}

}  // namespace
}  // namespace dsphere::test
