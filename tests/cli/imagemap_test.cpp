// Scenes whose surfaces images colour, by the real program.

#include "image/picture.h"
#include "tests/cli/fixture.h"
#include "tests/image/encoders.h"
#include "tests/image/jpegwriter.h"

#include <nlohmann/json.hpp>

namespace dsphere::test {
namespace {

class ImageMapTest : public CliTest {
  protected:
    ImageMapTest() {
        std::vector<std::uint8_t> codes(3 * 64 * 32);
        for (std::size_t k = 0; k < codes.size(); ++k) codes[k] = std::uint8_t(k % 3 == 0 ? 255 : k * 7);
        folder_.write("photo.jpg", jpegFile(64, 32, codes, {}));
        folder_.write("painted.pbrt", painted("photo.jpg"));
    }

    static std::string painted(const std::string& image) {
        std::string scene = planet();
        const std::string shape = "Shape \"displacedsphere\"";
        return scene.replace(scene.find(shape), 0,
                             "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"" + image +
                                 "\"\nMaterial \"diffuse\" \"texture reflectance\" \"t\"\n");
    }
};

TEST_F(ImageMapTest, RendersAndVerifies) {
    Outcome outcome = run({"render", "painted.pbrt", "--json", "--validation"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(nlohmann::json::parse(outcome.out)["image_bytes"], 4 * 256 * 33) << "a row of 256 codes, and the image";
    EXPECT_EQ(run({"verify", "painted.pbrt", "--resolution", "200,150"}).code, 0);
    nlohmann::json info = nlohmann::json::parse(run({"info", "painted.pbrt", "--json"}).out);
    EXPECT_EQ(info["images"][0]["type"], "8-bit JPEG");
    EXPECT_EQ(info["images"][0]["device_bytes"], 4 * 64 * 32);
}

// Both shapes have the image; the scene holds it once.
TEST_F(ImageMapTest, AnImageIsReadOnce) {
    EXPECT_EQ(nlohmann::json::parse(run({"info", "painted.pbrt", "--json"}).out)["images"].size(), 1u);
}

TEST_F(ImageMapTest, ErrorsNameTheImagesPlace) {
    folder_.write("bad.pbrt", painted("none.jpg"));
    expectFailure(run({"render", "bad.pbrt"}), 3, "bad.pbrt:8:53: none.jpg: cannot be read");
    std::filesystem::resize_file(path("photo.jpg"), std::filesystem::file_size(path("photo.jpg")) - 1);
    expectFailure(run({"render", "painted.pbrt"}), 3, "painted.pbrt:8:53: photo.jpg: JPEG: truncated or damaged");
    folder_.write("nan.pfm", pfmFile(1, 1, {std::nanf("")}, true));
    folder_.write("bad.pbrt", painted("nan.pfm"));
    expectFailure(run({"render", "bad.pbrt"}), 3, "nan.pfm: the colour at column 0, row 0 holds nan");
}

}  // namespace
}  // namespace dsphere::test
