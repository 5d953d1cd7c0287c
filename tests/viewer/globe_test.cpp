#include "viewer/globe.h"

#include "scene/parser.h"
#include "surface/scenemaps.h"
#include "surface/spline.h"
#include "tests/support/tempfolder.h"
#include "tests/support/testmaps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dsphere::viewer {
namespace {

struct Planet {
    test::TempFolder folder;
    Scene scene;
    SceneMaps maps;
    std::unique_ptr<NodeGrid> nodes;

    explicit Planet(const std::string& transform) {
        test::writePgm16(folder.path() / "map.pgm", test::fractalMap(64, 32));
        scene =
            parseScene("WorldBegin\nShape \"sphere\"\n" + transform +
                           "\nShape \"displacedsphere\" \"string displacementmap\" \"map.pgm\" \"float maxdispl\" 10\n",
                       "globe.pbrt", folder.path());
        maps = loadSceneMaps(scene);
        nodes = std::make_unique<NodeGrid>(*maps.maps[0]);
    }
    Globe globe() const { return Globe(scene.shapes[1], nodes.get(), maps.reliefs[1]); }
};

TEST(Globe, IsTheFirstDisplacedSphere) {
    Planet planet("Translate 1 2 3 Scale 2 2 2");
    EXPECT_EQ(Globe::shapeOf(planet.scene), 1u);
    Globe globe = planet.globe();
    EXPECT_EQ(globe.centre(), dvec3(1.0, 2.0, 3.0));
    EXPECT_NEAR(globe.radius(), 2.0 * planet.maps.reliefs[1].greatest_radius, 1e-12);
}

TEST(Globe, ReadsTheMapAtItsTexels) {
    Planet planet("");
    Globe globe = planet.globe();
    const Heightmap& map = *planet.maps.maps[0];
    const Relief& relief = planet.maps.reliefs[1];
    for (int j = 0; j < map.height; j += 5)
        for (int i = 0; i < map.width; i += 7) {
            double latitude = 90.0 - 180.0 * (j + 0.5) / map.height, longitude = -180.0 + 360.0 * (i + 0.5) / map.width;
            double lat = glm::radians(latitude), lon = glm::radians(longitude);
            dvec3 direction(std::cos(lat) * std::sin(lon), std::sin(lat), std::cos(lat) * std::cos(lon));
            Place place = globe.placeOf(1.3 * direction);
            EXPECT_NEAR(place.latitude, latitude, 1e-9);
            EXPECT_NEAR(place.longitude, longitude, 1e-9);
            ASSERT_TRUE(place.stored.has_value());
            EXPECT_NEAR(*place.stored, map.at(i, j), 1e-3);
            EXPECT_NEAR(globe.ground(direction), relief.base + relief.scale * map.at(i, j), 1e-6);
            EXPECT_NEAR(globe.altitude(direction * 2.0), 2.0 - globe.ground(direction), 1e-12);
        }
    EXPECT_NEAR(*globe.placeOf({0.0, 2.0, 0.0}).stored, map.north_pole, 1e-3);
    EXPECT_NEAR(*globe.placeOf({0.0, -2.0, 0.0}).stored, map.south_pole, 1e-3);
}

TEST(Globe, OfAPlainSphere) {
    Scene scene = parseScene("WorldBegin\nTranslate 0 0 5\nShape \"sphere\" \"float radius\" 2\n", "s.pbrt", {});
    Globe globe(scene.shapes[0], nullptr, {});
    EXPECT_EQ(globe.radius(), 2.0);
    EXPECT_NEAR(globe.altitude({0.0, 0.0, 0.0}), 3.0, 1e-12);
    EXPECT_FALSE(globe.placeOf({1.0, 0.0, 5.0}).stored.has_value());
}

// The smooth surface is lower on peaks than what runs through the map's values.
TEST(Globe, GroundOfASpline) {
    Planet planet("");
    const Heightmap& map = *planet.maps.maps[0];
    Relief relief = planet.maps.reliefs[1];
    relief.filter = Filter::BSpline;
    Globe globe(planet.scene.shapes[1], planet.nodes.get(), relief);
    const SplineNodes spline(*planet.nodes);
    for (int j = 0; j <= planet.nodes->rows(); j += 7) {
        const std::vector<SplineNodes::Node> row = spline.row(j);
        const double colatitude = planet.nodes->colatitude(j);
        for (int i = 0; i < planet.nodes->width(); i += 11) {
            const double lon = planet.nodes->longitude(i);
            const dvec3 direction(std::sin(colatitude) * std::sin(lon), std::cos(colatitude),
                                  std::sin(colatitude) * std::cos(lon));
            EXPECT_NEAR(globe.ground(direction), relief.base + relief.scale * row[std::size_t(i)][0], 1e-6);
        }
    }
    EXPECT_NEAR(*globe.placeOf({0.0, 2.0, 0.0}).stored, map.north_pole, 1e-3);
}

TEST(Globe, ClearanceOfFlatShapes) {
    Scene scene = parseScene(
        "WorldBegin\nShape \"disk\" \"float radius\" 2 \"float innerradius\" 1 \"float height\" 3\n"
        "Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0] \"integer indices\" [0 1 2]\n",
        "s.pbrt", {});
    const Globe disk(scene.shapes[0], nullptr, {}), mesh(scene.shapes[1], nullptr, {});
    EXPECT_NEAR(disk.clearance({1.5, 0.0, 5.0}), 2.0, 1e-12);
    EXPECT_NEAR(disk.clearance({0.0, 0.0, 3.0}), 1.0, 1e-12);
    EXPECT_NEAR(disk.clearance({0.0, 5.0, 3.0}), 3.0, 1e-12);
    EXPECT_NEAR(mesh.clearance({0.2, 0.2, -0.7}), 0.7, 1e-12);
    EXPECT_NEAR(mesh.clearance({-3.0, -4.0, 0.0}), 5.0, 1e-12);
    EXPECT_NEAR(mesh.clearance({1.0, 1.0, 0.0}), std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(mesh.clearance({0.5, -1.0, 0.0}), 1.0, 1e-12);
    EXPECT_FALSE(disk.round());
    EXPECT_FALSE(mesh.round());
}

}  // namespace
}  // namespace dsphere::viewer
