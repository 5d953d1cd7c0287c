#include "render/absentlist.h"

#include "surface/heldmap.h"
#include "tests/render/world.h"
#include "tests/support/expecterror.h"
#include "tests/support/testdevice.h"

#include <algorithm>
#include <cstring>

namespace dsphere::test {
namespace {

/// A scene of one map in 40 tiles of 256 texels a side (8 across, 5 down, as the south pole has a row of its own), for
/// 32 of which, the least number, there is room.
class AbsentListTest : public WorldTest {
  protected:
    AbsentListTest() {
        RawMap raw;
        raw.width = 2048;
        raw.height = 1024;
        raw.samples.assign(2048 * 1024, 1.0f);
        map_ = makeTiledHeightmap(holdMap(std::move(raw), geo::SampleKind::UInt16), DisplacedSphere());
        packed_.nodes.push_back(std::make_unique<NodeGrid>(map_));
        packed_.memory_limit = 1;
    }

    /// Settles pixels 0, 1 ... that need so many tiles each, all different, and ask for one after the other.
    void settle(const std::vector<std::uint32_t>& needed) {
        TilePool pool(device_, packed_);
        ASSERT_EQ(pool.slots(), TilePool::kLeastSlots);
        AbsentList list(device_, pool, needed.size());
        std::vector<std::uint32_t> met(needed.size(), 0);
        std::byte* const bytes = list.buffer().mapped().data();
        layout::AbsentPixel* const asked = reinterpret_cast<layout::AbsentPixel*>(bytes + sizeof(layout::AbsentHead));
        const auto ask = [&](const std::vector<std::uint32_t>& pixels) {
            layout::AbsentHead head = {};
            for (std::uint32_t pixel : pixels) {
                if (met[pixel] == needed[pixel]) continue;
                std::uint32_t first = 0;
                for (std::uint32_t other = 0; other < pixel; ++other) first += needed[other];
                asked[head.count++] = {pixel, first + met[pixel]++};
            }
            std::memcpy(bytes, &head, sizeof(head));
            list.buffer().flush();
        };
        std::vector<std::uint32_t> all(needed.size());
        for (std::uint32_t pixel = 0; pixel < all.size(); ++pixel) all[pixel] = pixel;
        ask(all);
        list.settle([&](std::uint32_t count) {
            std::vector<std::uint32_t> again;
            for (std::uint32_t k = 0; k < count; ++k) again.push_back(asked[needed.size() + k].pixel);
            ask(again);
        });
        EXPECT_EQ(met, needed);
    }

    gpu::Device device_{{testDevice()}};
    Heightmap map_;
    PackedScene packed_;
};

// The first pixel's tiles stay while the second one is done with it, and must not be counted as the second one's.
TEST_F(AbsentListTest, TilesOfPixelsThatAreDoneMakeRoom) {
    settle({10, 25});
    settle({25, 10, 5});
}

TEST_F(AbsentListTest, AllTilesHaveRoomWhereMemoryAllows) {
    packed_.memory_limit = 0;
    EXPECT_GE(TilePool(device_, packed_).slots(), 40u);
}

TEST_F(AbsentListTest, OnePixelMayNeedAllThatThereIsRoomFor) {
    settle({32});
    const std::string message = messageOf(ExitCode::Failure, [&] { settle({33}); });
    EXPECT_TRUE(holds(message, "one ray needs more than the 32 tiles of heights that the device has room for"));
}

}  // namespace
}  // namespace dsphere::test
