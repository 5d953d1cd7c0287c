// The EXR that `render --aov` writes: its channels, what they mean, and its header.

#include "image/picture.h"
#include "tests/cli/fixture.h"

#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfIntAttribute.h>
#include <ImfMatrixAttribute.h>
#include <ImfStandardAttributes.h>

#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <set>

namespace dsphere::test {
namespace {

using glm::dvec3;

class AovTest : public CliTest {
  protected:
    Image render(std::vector<std::string> options) {
        options.insert(options.begin(), {"render", "planet.pbrt", "-o", "a.exr"});
        Outcome outcome = run(options);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return readExr(path("a.exr"));
    }

    /// The unit direction through a pixel's centre, from the fixture's scene: y spans tan(20 degrees), x is to the
    /// right.
    static dvec3 direction(std::size_t i) {
        double x = double(i % kWidth) + 0.5, y = double(i / kWidth) + 0.5;
        double half = std::tan(20.0 * std::numbers::pi / 180.0);
        return glm::normalize(dvec3((2.0 * x - kWidth) / kHeight * half, (kHeight - 2.0 * y) / kHeight * half, -1.0));
    }
    static dvec3 vectorAt(const Image& image, const std::string& name, std::size_t i) {
        return {image.at(name + ".X").floats()[i], image.at(name + ".Y").floats()[i],
                image.at(name + ".Z").floats()[i]};
    }
    /// Calls body(pixel, id) for every pixel that hits, and expects some of both shapes.
    template <typename Body>
    static void forHits(const Image& image, Body body) {
        std::map<unsigned, int> seen;
        const auto& ids = image.at("id").floats();
        for (std::size_t i = 0; i < ids.size(); ++i) {
            const unsigned id = unsigned(ids[i]);
            ++seen[id];
            if (id > 0) body(i, id);
        }
        EXPECT_EQ(seen.size(), 3u) << "misses, the planet and its neighbour";
        for (const auto& [id, count] : seen) EXPECT_GT(count, 10) << id;
    }
    static dvec3 centreOf(unsigned id) { return id == 1 ? dvec3(0.0) : dvec3(1.5, 0.0, 0.0); }
};

TEST_F(AovTest, ChannelsAndTheirTypes) {
    Image image = render({"--aov", "all"});
    const std::set<std::string> expected = {
        "R",    "G",    "B", "A", "t",        "P.X",      "P.Y",      "P.Z", "N.X", "N.Y",   "N.Z",     "Ns.X",
        "Ns.Y", "Ns.Z", "u", "v", "Albedo.R", "Albedo.G", "Albedo.B", "id",  "lit", "steps", "residual"};
    std::set<std::string> found;
    for (const Channel& channel : image.channels) found.insert(channel.name);
    EXPECT_EQ(found, expected);

    Imf::InputFile file(path("a.exr").c_str());  // readExr widens HALF
    const Imf::ChannelList& list = file.header().channels();
    for (auto c = list.begin(); c != list.end(); ++c) EXPECT_EQ(c.channel().type, Imf::FLOAT) << c.name();
}

TEST_F(AovTest, OnlyWhatIsAskedFor) {
    auto names = [](const Image& image) {
        std::vector<std::string> all;
        for (const Channel& channel : image.channels) all.push_back(channel.name);
        return all;
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(names(render({"--aov", "id,P"})), (Names{"A", "B", "G", "P.X", "P.Y", "P.Z", "R", "id"}));
    EXPECT_EQ(names(render({"--aov", "t", "--spp", "0"})), (Names{"t"}));
}

// `steps` alone may tell of work that a missing ray made.
TEST_F(AovTest, Misses) {
    Image image = render({"--aov", "all", "--spp", "0"});
    const auto& ids = image.at("id").floats();
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (ids[i] != 0.0f) continue;
        for (const Channel& channel : image.channels) {
            if (channel.name == "steps") continue;
            double value = double(channel.floats()[i]);
            double expected = channel.name == "t" ? std::numeric_limits<double>::infinity() : 0.0;
            ASSERT_EQ(value, expected) << channel.name << " of pixel " << i;
        }
    }
}

TEST_F(AovTest, PositionIsTheRayAtItsDistance) {
    Image image = render({"--aov", "all"});
    forHits(image, [&](std::size_t i, unsigned) {
        dvec3 p = dvec3(0.0, 0.0, 4.0) + double(image.at("t").floats()[i]) * direction(i);
        EXPECT_LT(glm::distance(p, vectorAt(image, "P", i)), 1e-5) << "pixel " << i;
    });
}

TEST_F(AovTest, IdCountsTheShapesFromOne) {
    Image image = render({"--aov", "id,P"});
    forHits(image, [&](std::size_t i, unsigned id) {
        double distance = glm::distance(vectorAt(image, "P", i), centreOf(id));
        EXPECT_GE(distance, (id == 1 ? 1.0 : 0.2) - 1e-6);
        EXPECT_LE(distance, (id == 1 ? 1.1 : 0.2) + 1e-6);
    });
}

TEST_F(AovTest, NormalsAreUnitAndFaceTheCamera) {
    Image image = render({"--aov", "all"});
    forHits(image, [&](std::size_t i, unsigned id) {
        dvec3 n = vectorAt(image, "N", i);
        EXPECT_NEAR(glm::length(n), 1.0, 1e-6);
        EXPECT_LT(glm::dot(n, direction(i)), 1e-6) << "a first hit goes in";
        EXPECT_EQ(vectorAt(image, "Ns", i), n);
        if (id == 2) {
            EXPECT_LT(glm::distance(n, (vectorAt(image, "P", i) - centreOf(2)) / 0.2), 1e-5);
        }
    });
}

// A displaced sphere's axis is y and its v begins in the north; a sphere's is z, and its v ends at +z, as pbrt has it.
TEST_F(AovTest, LongitudeAndLatitudeBelongToThePosition) {
    Image image = render({"--aov", "all"});
    forHits(image, [&](std::size_t i, unsigned id) {
        dvec3 p = vectorAt(image, "P", i) - centreOf(id);
        double u = id == 1 ? 0.5 + std::atan2(p.x, p.z) / (2.0 * std::numbers::pi)
                           : std::atan2(p.y, p.x) / (2.0 * std::numbers::pi);
        double angle = std::acos((id == 1 ? p.y : p.z) / glm::length(p)) / std::numbers::pi;
        double v = id == 1 ? angle : 1.0 - angle;
        EXPECT_GE(image.at("u").floats()[i], 0.0f);
        double turn = std::remainder(image.at("u").floats()[i] - u, 1.0);
        EXPECT_NEAR(turn * std::sin(std::numbers::pi * angle), 0.0, 2e-6);  // near a pole P's rounding turns far
        EXPECT_NEAR(image.at("v").floats()[i], v, 2e-6);
    });
}

// The neighbour stands between planet and sun: nothing shades it but itself.
TEST_F(AovTest, LitIsTheSunlitSide) {
    Image image = render({"--aov", "all"});
    dvec3 sun = glm::normalize(dvec3(1.0, 0.0, 0.5));
    int lit = 0, dark = 0;
    forHits(image, [&](std::size_t i, unsigned id) {
        double cosine = glm::dot(vectorAt(image, "N", i), sun);
        unsigned mask = unsigned(image.at("lit").floats()[i]);
        EXPECT_LE(mask, 1u) << "there is one light";
        if (cosine < -1e-6) {
            EXPECT_EQ(mask, 0u) << "pixel " << i;
        }
        if (id == 2 && cosine > 1e-6) {
            EXPECT_EQ(mask, 1u) << "pixel " << i;
        }
        ++(mask ? lit : dark);
    });
    EXPECT_GT(lit, 100);
    EXPECT_GT(dark, 100);
}

TEST_F(AovTest, AlbedoStepsAndResidual) {
    Image image = render({"--aov", "all"});
    forHits(image, [&](std::size_t i, unsigned id) {
        EXPECT_EQ(image.at("Albedo.G").floats()[i], 0.5f) << "the default material's";
        EXPECT_LE(image.at("residual").floats()[i], 1e-6f);
        if (id == 1) {
            EXPECT_GE(image.at("steps").floats()[i], 4.0f) << "a hit reads a patch";
        }
        EXPECT_LT(image.at("steps").floats()[i], 2000.0f);
    });
}

TEST_F(AovTest, Header) {
    render({"--aov", "P,id", "--spp", "3", "--cropwindow", "0.1,1,0,0.9"});
    Imf::InputFile file(path("a.exr").c_str());
    const Imf::Header& header = file.header();
    EXPECT_EQ(header.typedAttribute<Imf::StringAttribute>("software").value(), "dsphere " DSPHERE_VERSION);
    EXPECT_EQ(header.typedAttribute<Imf::StringAttribute>("scene").value(), "planet.pbrt");
    EXPECT_FALSE(header.typedAttribute<Imf::StringAttribute>("device").value().empty());
    EXPECT_EQ(header.typedAttribute<Imf::IntAttribute>("samplesPerPixel").value(), 3);
    EXPECT_GT(header.typedAttribute<Imf::FloatAttribute>("renderTimeSeconds").value(), 0.0f);
    EXPECT_EQ(header.lineOrder(), Imf::INCREASING_Y);
    EXPECT_EQ(header.displayWindow().max, Imath::V2i(kWidth - 1, kHeight - 1));
}

// OpenEXR's matrices act on row vectors; y of NDC points up, as pbrt has it.
TEST_F(AovTest, HeaderMatricesTakePositionsToTheirPixels) {
    Image image = render({"--aov", "all"});
    Imf::InputFile file(path("a.exr").c_str());
    const Imath::M44f to_camera = file.header().typedAttribute<Imf::M44fAttribute>("worldToCamera").value();
    const Imath::M44f to_ndc = file.header().typedAttribute<Imf::M44fAttribute>("worldToNDC").value();
    forHits(image, [&](std::size_t i, unsigned) {
        dvec3 p = vectorAt(image, "P", i);
        Imath::V3f world(float(p.x), float(p.y), float(p.z)), camera, ndc;
        to_camera.multVecMatrix(world, camera);
        EXPECT_NEAR(camera.length(), image.at("t").floats()[i], 1e-5);
        EXPECT_GT(camera.z, 0.0f);
        to_ndc.multVecMatrix(world, ndc);
        EXPECT_NEAR(ndc.x * kWidth, double(i % kWidth) + 0.5, 1e-3);
        EXPECT_NEAR((1.0 - ndc.y) * kHeight, double(i / kWidth) + 0.5, 1e-3);
    });
}

}  // namespace
}  // namespace dsphere::test
