#include "render/filmtracer.h"

#include "render/devicefilm.h"
#include "render/planes.h"
#include "tests/render/world.h"

namespace dsphere::test {
namespace {

class PassTest : public WorldTest {
  protected:
    // Straight down on the pole from so close, and so narrow, that all pixels lie where the filter doubts every ray.
    World poleWorld(int width, int height) const {
        return worldOf(
            "LookAt 0 4 0  0 0 0  0 0 1\nCamera \"perspective\" \"float fov\" .0002\nFilm \"rgb\" \"integer "
            "xresolution\" " +
            std::to_string(width) + " \"integer yresolution\" " + std::to_string(height) + "\nWorldBegin\n" + planet());
    }

    gpu::Device device_{{"", true}};
};

// A pixel that opens a group, and is alone in it, is done too.
TEST_F(PassTest, TheRetryTakesEveryPixelWhateverTheirNumber) {
    constexpr int kMost = GROUP_SIZE_X * GROUP_SIZE_Y + 1;
    const std::uint32_t mask = planeBit(PLANE_ID);
    World made = poleWorld(kMost, kMost);
    FilmPipelines pipelines(device_, made.packed.traits, 1.0f, Marcher::Exact, mask);
    const DeviceScene scene(device_, made.packed);
    for (int count = 1; count <= kMost; ++count) {
        DeviceFilm film(device_, kMost, kMost, mask);
        FilmTracer tracer(device_, pipelines, scene, film.image());
        tracer.run(std::vector{layout::RenderParams{0, 0, count, 1, 0, 0, -1, 0}});
        ASSERT_EQ(tracer.retried(), std::uint64_t(count));
        const Box box{0, 0, count, 1};
        const Image image = film.read(box, box);
        for (std::size_t i = 0; i < image.pixelCount(); ++i)
            ASSERT_EQ(image.at("id").uints()[i], 1u) << "pixel " << i << " of " << count;
    }
}

// The list of pixels to retry is dispatched in rows of RETRY_ROW workgroups: more than one row, and the last not full,
// as a whole and cut into parts that take one row each.
TEST_F(PassTest, TheRetryTakesMoreThanARowOfGroups) {
    const int rows = 272, width = 272;
    const std::uint32_t mask = planeBit(PLANE_T) | planeBit(PLANE_ID);
    World made = poleWorld(width, rows);
    FilmPipelines pipelines(device_, made.packed.traits, 1.0f, Marcher::Exact, mask);
    const DeviceScene scene(device_, made.packed);
    const Box box{0, 0, width, rows};
    const auto render = [&](int rows_at_once) {
        DeviceFilm film(device_, width, rows, mask);
        FilmTracer tracer(device_, pipelines, scene, film.image());
        for (int y = 0; y < rows; y += rows_at_once)
            tracer.run(std::vector{layout::RenderParams{0, y, width, std::min(y + rows_at_once, rows), 0, 0, -1, 0}});
        EXPECT_EQ(tracer.retried(), box.width() * std::uint64_t(box.height()));
        return film.read(box, box);
    };
    const Image whole = render(rows), parts = render(4);
    const std::uint64_t stride = runsOnCpu(device_) ? 1 : 32,
                        in_a_row = RETRY_ROW * GROUP_SIZE_X * GROUP_SIZE_Y / stride;
    ASSERT_GT(whole.pixelCount(), in_a_row);
    ASSERT_NE(whole.pixelCount() % in_a_row, 0u);
    for (std::size_t i = 0; i < whole.pixelCount(); ++i) {
        ASSERT_EQ(whole.at("id").uints()[i], 1u) << "pixel " << i;
        ASSERT_EQ(whole.at("t").floats()[i], parts.at("t").floats()[i]) << "pixel " << i;
    }
}

}  // namespace
}  // namespace dsphere::test
