#include "render/planes.h"

#include "tests/support/expecterror.h"

#include <gtest/gtest.h>

#include <bit>
#include <set>

namespace dsphere::test {
namespace {

TEST(Planes, AreInTheOrderOfTheirLayers) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < planeInfos().size(); ++i) {
        EXPECT_EQ(planeInfos()[i].plane, int(i));
        EXPECT_TRUE(names.insert(planeInfos()[i].channel).second) << planeInfos()[i].channel;
    }
    EXPECT_EQ(names.size(), std::size_t(PLANE_COUNT));
}

TEST(Planes, WordsNameTheirPlanes) {
    EXPECT_EQ(parseAovs(""), 0u);
    EXPECT_EQ(parseAovs("t"), planeBit(PLANE_T));
    EXPECT_EQ(parseAovs("P"), planeBit(PLANE_PX) | planeBit(PLANE_PY) | planeBit(PLANE_PZ));
    EXPECT_EQ(parseAovs("N"), planeBit(PLANE_NX) | planeBit(PLANE_NY) | planeBit(PLANE_NZ));
    EXPECT_EQ(parseAovs("Ns"), planeBit(PLANE_NSX) | planeBit(PLANE_NSY) | planeBit(PLANE_NSZ));
    EXPECT_EQ(parseAovs("id,u,id"), planeBit(PLANE_ID) | planeBit(PLANE_U));
    EXPECT_EQ(parseAovs("all"), parseAovs("t,P,N,Ns,u,v,Albedo,id,lit,steps,residual"));
    EXPECT_EQ(std::popcount(parseAovs("all")), 19);
}

TEST(Planes, UnknownWordsAreUsageErrors) {
    for (const char* list : {"depth", "T", "t,,P", ",", " t", "t, P", "P.X", "R", "object", "flags", "all,t"}) {
        std::string message = messageOf(ExitCode::Usage, [&] { parseAovs(list); });
        EXPECT_TRUE(holds(message, "residual")) << list;
    }
}

}  // namespace
}  // namespace dsphere::test
