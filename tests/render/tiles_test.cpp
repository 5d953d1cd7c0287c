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
    static constexpr const char* kWall = "Shape \"disk\" \"float radius\" 100 \"float height\" 1.5\n";

    /// What adds up samples of a scene.
    struct Tracing {
        Tracing(gpu::Device& device, const World& world)
            : box(cropBox(world.scene.film)),
              pipelines(device, world.packed.traits, 1.0f, Marcher::Exact, kSums),
              scene(device, world.packed),
              film(device, box.width(), box.height(), kSums),
              tracer(device, pipelines, scene, film.image()) {}

        std::vector<float> alpha() const { return film.read(box, box).at("A").floats(); }

        Box box;
        FilmPipelines pipelines;
        DeviceScene scene;
        DeviceFilm film;
        FilmTracer tracer;
    };

    World seen(int width, int height, const std::string& shape) const {
        return worldOf(
            "LookAt 0 .5 4  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 40\nFilm \"rgb\" \"integer "
            "xresolution\" " +
            std::to_string(width) + " \"integer yresolution\" " + std::to_string(height) +
            "\nWorldBegin\nLightSource \"distant\" \"point3 from\" [1 1 4] \"point3 to\" [0 0 0]\n" + shape);
    }

    /// The sums of the samples, each in rounds of `target` seconds; as one box if that is 0.
    Image sums(const World& world, double target) {
        Tracing tracing(device_, world);
        const Box& box = tracing.box;
        const std::vector<Span> spans = shownSpans(world.packed.traits, world.packed.state.objects, box);
        TileRun run(makeTiles(spans, 0, box.width(), tracing.tracer.columns()), 0, 0);
        for (int sample = 0; sample < kSamples; ++sample) {
            if (target == 0.0)
                tracing.tracer.run(std::vector{layout::RenderParams{0, 0, box.x1, box.y1, 0, 0, sample, 0}});
            while (target > 0.0 && !run.done()) run.step(tracing.tracer, sample, 0, target);
            run.rewind();
        }
        return tracing.film.read(box, box);
    }

    gpu::Device device_{{"", true}};
};

const double kTargets[] = {1.0, 1e-3, 1e-5};  // seconds: for the whole picture, some tiles, and a part of one

// A wall that fills the picture. Heights that no number of threads divides; a picture wider than a tile.
TEST_F(TileRunTest, EachPixelOnce) {
    for (const auto& [width, height] : {std::pair(97, 1), {97, 9}, {97, 41}, {97, 333}, {2300, 70}}) {
        const World wall = seen(width, height, kWall);
        for (const double target : kTargets) {
            const Image image = sums(wall, target);
            const std::vector<float>& alpha = image.at("A").floats();
            EXPECT_EQ(std::set(alpha.begin(), alpha.end()), std::set{float(kSamples)})
                << width << "x" << height << ", " << target << " s";
        }
    }
}

// The rest of a tile that a round has cut is not joined to the next tile: the box around both holds what the round
// before has done. A pixel is said to take so long that a round has room for half a tile; the one after it may be 16
// times as large.
TEST_F(TileRunTest, ThePartsOfATile) {
    const World wall = seen(256, 48, kWall);
    Tracing tracing(device_, wall);
    constexpr double kTarget = 1000.0;  // seconds
    tracing.tracer.pixelSeconds() = kTarget / 1950.0;
    TileRun run({{0, 0, 256, 16}, {0, 16, 256, 32}, {0, 32, 256, 48}}, 0, 0);
    run.step(tracing.tracer, 0, 0, kTarget);
    const int columns = tracing.tracer.columns();
    ASSERT_EQ(run.doneRows().x, 1950 / 16 / columns * columns);
    while (!run.done()) run.step(tracing.tracer, 1, 0, kTarget);
    const std::vector<float> alpha = tracing.alpha();
    EXPECT_EQ(std::set(alpha.begin(), alpha.end()), std::set{1.0f});
}

// Nor is a tile joined to one that has another beside it, which the box around both would hold a part of.
TEST_F(TileRunTest, TilesBesideOthers) {
    const World wall = seen(2104, 32, kWall);
    Tracing tracing(device_, wall);
    tracing.tracer.pixelSeconds() = 1e-6;  // so that all are one round
    const std::vector<Box> tiles = {{40, 0, 2085, 16}, {0, 16, 2048, 32}, {2048, 16, 2104, 32}};
    TileRun run(tiles, 0, 0);
    while (!run.done()) run.step(tracing.tracer, 1, 0, 1000.0);
    const std::vector<float> alpha = tracing.alpha();
    for (const Box& tile : tiles)
        for (int x = tile.x0; x < tile.x1; ++x)
            ASSERT_EQ(alpha[std::size_t(tile.y0) * 2104 + std::size_t(x)], 1.0f) << x << ", " << tile.y0;
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
