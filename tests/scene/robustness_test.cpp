// Whatever the bytes, a parse ends in a sound Scene or in Error (InvalidInput).

#include "base/limits.h"
#include "scene/transforms.h"
#include "tests/scene/support.h"

#include <random>

namespace dsphere {
namespace {

bool isFraction(const dvec3& rgb) {
    return glm::all(glm::greaterThanEqual(rgb, dvec3(0.0))) && glm::all(glm::lessThanEqual(rgb, dvec3(1.0)));
}

void expectSound(const Scene& scene) {
    EXPECT_FALSE(scene.shapes.empty());
    EXPECT_TRUE(scene.camera.fov_degrees > 0.0 && scene.camera.fov_degrees < 180.0);
    EXPECT_TRUE(isInvertible(scene.camera.camera_from_world));
    EXPECT_TRUE(scene.film.width >= 1 && scene.film.width <= limits::kResolution);
    EXPECT_TRUE(scene.film.height >= 1 && scene.film.height <= limits::kResolution);
    EXPECT_TRUE(scene.film.crop[0] < scene.film.crop[1] && scene.film.crop[2] < scene.film.crop[3]);
    EXPECT_GE(scene.sampler.pixel_samples, 1);
    for (const Shape& shape : scene.shapes) {
        EXPECT_TRUE(isFinite(shape.world_from_object) && isFinite(glm::inverse(shape.world_from_object)));
        const auto* constant = textureAs<ConstantColour>(shape.material);
        EXPECT_TRUE(!constant || isFraction(constant->rgb));
        const auto* board = textureAs<Checkerboard>(shape.material);
        EXPECT_TRUE(!board || (isFraction(board->even) && isFraction(board->odd)));
        const auto* mesh = std::get_if<TriangleMesh>(&shape.geometry);
        EXPECT_TRUE(!mesh || (!mesh->triangles.empty() && mesh->triangles.size() <= 64));
        EXPECT_TRUE(!mesh || mesh->uvs.empty() || mesh->uvs.size() == mesh->points.size());
    }
    for (const Light& light : scene.lights) {
        auto* distant = std::get_if<DistantLight>(&light);
        EXPECT_TRUE(!distant || std::abs(glm::length(distant->direction) - 1.0) < 1e-15);
        auto* area = std::get_if<AreaLight>(&light);
        EXPECT_TRUE(!area || (area->shape >= 0 && area->shape < int(scene.shapes.size())));
    }
}

/// Whether the text is a scene; anything but a sound Scene or an Error of bad input that says where fails the test.
bool survives(const std::string& text) {
    try {
        expectSound(parse(text));
        return true;
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::InvalidInput);
        EXPECT_EQ(std::string(error.what()).find("test.pbrt:"), 0u) << error.what();
    } catch (const std::exception& error) {
        ADD_FAILURE() << error.what() << "\n" << text;
    }
    return false;
}

TEST(Robustness, TheFullSceneIsValid) {
    EXPECT_TRUE(survives(kFullScene));
}

TEST(Robustness, EveryTruncation) {
    int scenes = 0;
    for (std::size_t length = 0; length < kFullScene.size(); ++length) scenes += survives(kFullScene.substr(0, length));
    // Only what stands after the first shape's block can be missing from a scene: some, but by far not most.
    EXPECT_GT(scenes, 10);
    EXPECT_LT(scenes, int(kFullScene.size()) / 3);
}

std::string mutated(std::mt19937& random) {
    static const std::string alphabet = "\"[]#\\-+.0123456789eEnainf \n\t\x80\xff";
    std::string text = kFullScene;
    int changes = 1 + int(random() % 4);
    for (int i = 0; i < changes; ++i) {
        std::size_t at = random() % text.size();
        char letter = random() % 8 ? alphabet[random() % alphabet.size()] : char(random() % 256);
        switch (random() % 4) {
            case 0:
                text[at] = letter;
                break;
            case 1:
                text.insert(at, 1, letter);
                break;
            case 2:
                text.erase(at, 1 + random() % 8);
                break;
            case 3:
                text.insert(at, text.substr(random() % text.size(), random() % 40));
                break;
        }
    }
    return text;
}

TEST(Robustness, TwentyThousandMutations) {
    std::mt19937 random(20240601);
    int scenes = 0;
    for (int i = 0; i < 20000 && !testing::Test::HasFailure(); ++i) scenes += survives(mutated(random));
    EXPECT_GT(scenes, 200) << "the mutations no longer reach past the lexer";
    EXPECT_LT(scenes, 19000) << "the mutations no longer break anything";
    RecordProperty("scenes", scenes);
}

TEST(Robustness, RandomBytes) {
    std::mt19937 random(7);
    for (int i = 0; i < 2000; ++i) {
        std::string text(random() % 200, ' ');
        for (char& c : text) c = char(random() % 256);
        EXPECT_FALSE(survives(text));
    }
}

TEST(Robustness, LongWordsMakeShortMessages) {
    EXPECT_LT(errorOf(std::string(1000000, 'x')).size(), 1000u);
    EXPECT_LT(errorOf("Camera \"" + std::string(1000000, 'x') + "\"").size(), 1000u);
    EXPECT_LT(errorOf("Translate " + std::string(1000000, '9')).size(), 1000u);
    EXPECT_LT(errorOf("Camera \"perspective\" \"float fov\" 1" + std::string(300, '0')).size(), 1000u);
}

TEST(Robustness, DeepBlocks) {
    std::string text = "WorldBegin ";
    for (std::size_t i = 0; i < limits::kBlockDepth; ++i) text += "AttributeBegin ";
    text += "Shape \"sphere\" ";
    for (std::size_t i = 0; i < limits::kBlockDepth; ++i) text += "AttributeEnd ";
    EXPECT_EQ(parse(text).shapes.size(), 1u);
}

}  // namespace
}  // namespace dsphere
