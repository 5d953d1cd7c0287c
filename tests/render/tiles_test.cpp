// Tiles of a picture: joined where that saves dispatches, and every pixel traced once a sample however they are.

#include "render/tiles.h"

#include "render/devicefilm.h"
#include "tests/render/world.h"

#include <cmath>
#include <set>

namespace dsphere::test {
namespace {

std::uint64_t area(const std::vector<Box>& boxes) {
    std::uint64_t pixels = 0;
    for (const Box& box : boxes) pixels += std::uint64_t(box.width()) * std::uint64_t(box.height());
    return pixels;
}

bool holds(const Box& outer, const Box& inner) {
    return outer.x0 <= inner.x0 && outer.y0 <= inner.y0 && outer.x1 >= inner.x1 && outer.y1 >= inner.y1;
}

TEST(JoinTiles, OfOneWidth) {
    const std::vector<Box> joined = joinTiles({{8, 0, 640, 16}, {8, 16, 640, 32}, {8, 32, 640, 47}});
    EXPECT_EQ(joined, (std::vector<Box>{{8, 0, 640, 47}}));
}

TEST(JoinTiles, NotWhereRowsLieBetween) {
    const std::vector<Box> apart = {{0, 0, 64, 16}, {0, 32, 64, 48}};
    EXPECT_EQ(joinTiles(apart), apart);
}

TEST(JoinTiles, NotWhereThatTracesMuchMore) {
    const std::vector<Box> apart = {{0, 0, 1024, 16}, {1024, 16, 2048, 32}};
    EXPECT_EQ(joinTiles(apart), apart);
    const Box first{0, 0, 64, 16}, second{64, 16, 128, 32};
    EXPECT_EQ(joinTiles({first, second}), (std::vector<Box>{{0, 0, 128, 32}}));
}

TEST(JoinTiles, OfNone) {
    EXPECT_TRUE(joinTiles({}).empty());
}

// A disk's: few dispatches, few pixels more, and every tile in one box, which has its rows to itself.
TEST(JoinTiles, OfADisk) {
    std::vector<Box> tiles;
    for (int y = 0; y < 720; y += 16) {
        const double up = std::abs(y + 8 - 360) - 8;
        const int half = int(std::sqrt(std::max(360.0 * 360.0 - up * up, 0.0)));
        tiles.push_back({640 - half, y, 640 + half, y + 16});
    }
    const std::vector<Box> joined = joinTiles(tiles);
    EXPECT_LT(joined.size(), tiles.size() / 2);
    EXPECT_LT(double(area(joined)), 1.06 * double(area(tiles)));
    for (const Box& tile : tiles)
        EXPECT_EQ(std::count_if(joined.begin(), joined.end(), [&](const Box& box) { return holds(box, tile); }), 1);
    for (std::size_t k = 1; k < joined.size(); ++k) EXPECT_EQ(joined[k - 1].y1, joined[k].y0);
}

class TileRunTest : public WorldTest {
  protected:
    static constexpr std::uint32_t kSums = 1u << PLANE_R | 1u << PLANE_G | 1u << PLANE_B | 1u << PLANE_A;
    static constexpr int kSamples = 5;

    World seen(int width, int height, const std::string& shape) const {
        return worldOf(
            "LookAt 0 .5 4  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 40\nFilm \"rgb\" \"integer "
            "xresolution\" " +
            std::to_string(width) + " \"integer yresolution\" " + std::to_string(height) +
            "\nWorldBegin\nLightSource \"distant\" \"point3 from\" [1 1 4] \"point3 to\" [0 0 0]\n" + shape);
    }

    /// The sums of the samples, each in rounds of `target` seconds; as one box if that is 0.
    Image sums(const World& world, double target) {
        const Box box = cropBox(world.scene.film);
        FilmPipelines pipelines(device_, world.packed.traits, 1.0f, Marcher::Exact, kSums);
        const DeviceScene scene(device_, world.packed);
        DeviceFilm film(device_, box.width(), box.height(), kSums);
        FilmTracer tracer(device_, pipelines, scene, film.image());
        const std::vector<Span> spans = shownSpans(world.packed.traits, world.packed.state.objects, box);
        TileRun run(makeTiles(spans, 0, box.width(), tracer.columns()), 0, 0);
        for (int sample = 0; sample < kSamples; ++sample) {
            if (target == 0.0) tracer.run(std::vector{layout::RenderParams{0, 0, box.x1, box.y1, 0, 0, sample, 0}});
            while (target > 0.0 && !run.done()) run.step(tracer, sample, 0, target);
            run.rewind();
        }
        return film.read(box, box);
    }

    gpu::Device device_{{"", true}};
};

const double kTargets[] = {1.0, 1e-3, 1e-5};  // seconds: for the whole picture, some tiles, and a part of one

// A wall that fills the picture. Heights that no number of threads divides; a picture wider than a tile.
TEST_F(TileRunTest, EachPixelOnce) {
    for (const auto& [width, height] : {std::pair(97, 1), {97, 9}, {97, 41}, {97, 333}, {2300, 70}}) {
        const World wall = seen(width, height, "Shape \"disk\" \"float radius\" 100 \"float height\" 1.5\n");
        for (const double target : kTargets) {
            const Image image = sums(wall, target);
            const std::vector<float>& alpha = image.at("A").floats();
            EXPECT_EQ(std::set(alpha.begin(), alpha.end()), std::set{float(kSamples)})
                << width << "x" << height << ", " << target << " s";
        }
    }
}

// A planet, whose tiles follow its silhouette: as one box that holds them all.
TEST_F(TileRunTest, AsOneBox) {
    for (const auto& [width, height] : {std::pair(400, 333), {3000, 200}}) {
        const World world = seen(width, height, planet());
        const Image expected = sums(world, 0.0);
        for (const double target : kTargets) {
            const Image image = sums(world, target);
            for (const Channel& channel : image.channels)
                EXPECT_EQ(channel.floats(), expected.at(channel.name).floats())
                    << channel.name << ", " << target << " s";
        }
    }
}

}  // namespace
}  // namespace dsphere::test
