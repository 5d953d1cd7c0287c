// Scenes as three exporters write them: their directives and parameters, in their order.

#include "tests/scene/support.h"

#include "tests/support/exportedscenes.h"

namespace dsphere {
namespace {

TEST(Exporters, AreReadWithoutAnEdit) {
    for (const test::ExportedScene& exported : test::kExportedScenes) {
        SCOPED_TRACE(exported.name);
        Scene scene;
        ASSERT_NO_THROW(scene = parse(exported.text)) << errorOf(exported.text);
        EXPECT_FALSE(scene.shapes.empty());
        EXPECT_FALSE(scene.lights.empty());
        for (const Notice& notice : scene.notices) EXPECT_EQ(notice.kind, Notice::Kind::Note) << notice.text;
    }
}

}  // namespace
}  // namespace dsphere
