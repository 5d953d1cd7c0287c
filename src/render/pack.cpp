#include "render/pack.h"

#include "base/error.h"
#include "base/limits.h"
#include "base/overloads.h"
#include "render/packlevels.h"
#include "render/packlight.h"
#include "render/packmaterial.h"
#include "render/packmesh.h"
#include "render/tovec4.h"
#include "scene/ramps.h"

#include <algorithm>
#include <cmath>

namespace dsphere {

namespace {

using layout::ObjectData;
using layout::vec4;

static_assert(RAMP_POINTS == kRampPoints);

// Every hit lies within 1e-6 R of the surface (the contract, which verify holds for each hit), so that far along the
// normal is outside.
constexpr double kSecondaryOffset = 1e-6;

/// Object space: the matrices, and the length that counts as 1 there.
struct ObjectSpace {
    dmat4 world_from_object, object_from_world;
    double unit;
};

dmat4 translated(dmat4 m, const dvec3& by) {
    m[3] = m * dvec4(by, 1.0);
    return m;
}

dvec3 centreOf(const Shape& shape) {
    return transformPoint(worldFromDevice(shape), dvec3(0.0));
}

ObjectSpace objectSpaceOf(const Shape& shape, double unit) {
    const dmat4 world = worldFromDevice(shape);
    return {world, glm::inverse(world), unit};
}

/// A vector as the shader keeps it twice as long: row + row_lo, whose sum has 48 bits.
void splitInto(vec4& row, vec4& row_lo, const dvec3& v) {
    row = toVec4(v, 0.0);
    row_lo = toVec4(v - dvec3(row), 0.0);
}

// The rays start at a point and have a direction that are linear in x and y; so is then their point at one multiple of
// the direction, on the plane through the object's centre parallel to the picture. Counted from the pixel nearest the
// object's centre all are small: counted from the picture's corner, a small far object's would be differences of large
// numbers.
void packCameraRays(ObjectData& object, const ObjectSpace& space, const Raster& raster) {
    dvec3 world_centre = transformPoint(space.world_from_object, dvec3(0.0));
    dvec2 centre = raster.project(world_centre);
    double x = std::clamp(std::floor(centre.x), 0.0, raster.width - 1.0);
    double y = std::clamp(std::floor(centre.y), 0.0, raster.height - 1.0);
    auto toObject = [&](const dvec3& v) { return transformVector(space.object_from_world, v); };
    dvec3 world_start = raster.start.at(x + 0.5, y + 0.5);
    dvec3 start = transformPoint(space.object_from_world, world_start) / space.unit;
    dvec3 d0 = toObject(raster.direction.at(x + 0.5, y + 0.5));
    double scale = 1.0 / glm::length(d0);
    d0 *= scale;
    dvec3 dx = scale * toObject(raster.direction.right), dy = scale * toObject(raster.direction.down);
    double depth = transformPoint(raster.camera_from_world, world_centre).z;  // of the plane, in directions of depth 1
    double steps = float(depth / (space.unit * scale));
    object.anchor_x = float(x);
    object.anchor_y = float(y);
    splitInto(object.direction_0, object.direction_0_lo, d0);
    splitInto(object.direction_x, object.direction_x_lo, dx);
    splitInto(object.direction_y, object.direction_y_lo, dy);
    splitInto(object.point_0, object.point_0_lo, start + steps * d0);
    splitInto(object.point_x, object.point_x_lo, toObject(raster.start.right) / space.unit + steps * dx);
    splitInto(object.point_y, object.point_y_lo, toObject(raster.start.down) / space.unit + steps * dy);
    object.direction_0.w = float(steps);
    object.from_start = toVec4(world_centre - world_start, 0.0);
    object.start_x = toVec4(raster.start.right, 0.0);
    object.start_y = toVec4(raster.start.down, 0.0);
}

// What a pixel spans at least: directions grow towards the picture's corners, and rays are counted by their length.
void packPixelSize(ObjectData& object, const ObjectSpace& space, const Raster& raster) {
    auto least = [&](const RasterLinear& linear) {
        return std::min(glm::length(transformVector(space.object_from_world, linear.right)),
                        glm::length(transformVector(space.object_from_world, linear.down)));
    };
    double longest = 0.0;
    for (double x : {0.0, double(raster.width)})
        for (double y : {0.0, double(raster.height)})
            longest =
                std::max(longest, glm::length(transformVector(space.object_from_world, raster.direction.at(x, y))));
    object.pixel_size = float(least(raster.start) / space.unit);
    object.pixel_growth = float(least(raster.direction) / longest);
}

void packTransforms(ObjectData& object, const ObjectSpace& space) {
    dmat4 to_object = glm::transpose(space.object_from_world);  // columns are now rows
    dmat4 to_world = glm::transpose(space.world_from_object);
    auto objectRow = [&](int i) { return vec4(to_object[i] / space.unit); };
    auto worldRow = [&](int i) { return toVec4(dvec3(to_world[i]) * space.unit, to_world[i].w); };
    object.to_object_x = objectRow(0);
    object.to_object_y = objectRow(1);
    object.to_object_z = objectRow(2);
    object.to_world_x = worldRow(0);
    object.to_world_y = worldRow(1);
    object.to_world_z = worldRow(2);
}

// Of a sphere about the centre, world, that holds a displaced sphere; negative for other shapes. A matrix A stretches
// by at most the root of the greatest row sum of its transpose times A.
double holdingRadius(const ObjectData& object, const Shape& shape, double unit) {
    if (object.kind != KIND_DISPLACED) return -1e15;
    const dmat3 linear(shape.world_from_object);
    const dmat3 square = glm::transpose(linear) * linear;
    double greatest = 0.0;
    for (int i = 0; i < 3; ++i)
        greatest = std::max(greatest, std::abs(square[i].x) + std::abs(square[i].y) + std::abs(square[i].z));
    return 1.00001 * unit * std::sqrt(greatest * double(object.shell_squared));
}

double innerShareOf(const Shape& shape) {
    const auto* disk = std::get_if<Disk>(&shape.geometry);
    return disk ? disk->inner_radius / disk->radius : 0.0;
}

void packImages(PackedScene& packed, const Scene& scene, const SceneMaps& maps) {
    for (const auto& image : maps.images) packed.images.emplace_back(*image);
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        const Shape& shape = scene.shapes[i];
        const ColourMap* image = maps.image(i);
        if (!image) continue;
        PackedObject& object = packed.state.objects[i];
        const double longitude_origin = textureAs<ImageMap>(shape.material)->longitude_origin;
        object.image = maps.image_of_shape[i];
        object.centres = packImage(object.data, *image, longitude_origin, innerShareOf(shape));
    }
    packed.light_image = maps.light_image;
}

int findOrAddRelief(PackedScene& packed, int map, const Relief& relief, Levels levels) {
    double base = relief.base / relief.greatest_radius, scale = relief.scale / relief.greatest_radius;
    for (std::size_t i = 0; i < packed.reliefs.size(); ++i) {
        const PackedRelief& other = packed.reliefs[i];
        if (other.map == map && other.base == base && other.scale == scale && other.filter == relief.filter &&
            other.smooth_normals == relief.smooth_normals)
            return int(i);
    }
    PackedRelief added{map, base, scale, relief.filter, relief.smooth_normals, {}, {}, -1};
    const NodeGrid& nodes = *packed.nodes[std::size_t(map)];
    added.bounds = buildBounds(nodes, relief);
    added.shader = packMap(nodes, added.bounds, relief);
    packed.reliefs.push_back(std::move(added));
    const int index = int(packed.reliefs.size()) - 1;
    if (levels == Levels::All) packLevels(packed, index, relief);
    return index;
}

/// Fills what depends on the kind of shape, with the length that is 1 in the shader's object space.
void packGeometry(PackedObject& packed_object, PackedScene& packed, const Shape& shape, int map, const Relief& relief,
                  Levels levels) {
    ObjectData& object = packed_object.data;
    object.kind = geometryKind(shape.geometry);
    object.base = 1.0f;
    object.mean_radius = -1.0f;
    object.offset = float(kSecondaryOffset);
    object.shell_squared = float((1.0 + Bounds::kSlack) * (1.0 + Bounds::kSlack)) + 1.2e-7f;
    const auto packDisplaced = [&](const DisplacedSphere&) {
        packed_object.relief = findOrAddRelief(packed, map, relief, levels);
        double base = relief.base / relief.greatest_radius;
        object.base = float(base);
        object.base_lo = float(base - double(object.base));
        object.scale = float(relief.scale / relief.greatest_radius);
        object.mean_radius = float(0.5 + 0.5 * relief.least_radius / relief.greatest_radius);
        return relief.greatest_radius;
    };
    const auto packDisk = [&](const Disk& disk) {
        object.base = float(disk.height / disk.radius);
        object.inner_squared = float(std::pow(disk.inner_radius / disk.radius, 2.0));
        return disk.radius;
    };
    packed_object.unit =
        std::visit(Overloads{packDisplaced, [](const Sphere& sphere) { return sphere.radius; }, packDisk,
                             [&](const TriangleMesh& mesh) { return packMesh(object, mesh, packed.triangles); }},
                   shape.geometry);
}

static_assert(MAX_OBJECTS == limits::kShapes && MAX_LIGHTS == limits::kLights && MAX_MARCHES == limits::kMarches &&
              MAX_TRIANGLES == limits::kTriangles && MAX_DEPTH == limits::kMaxDepth);

// The parser has checked a text's; scenes are made in code too.
void requireLimits(const Scene& scene, std::size_t triangles) {
    if (scene.shapes.size() > std::size_t(MAX_OBJECTS))
        throwInvalid("{}: {} shapes; at most {} are supported", scene.name, scene.shapes.size(), MAX_OBJECTS);
    if (scene.lights.size() > std::size_t(MAX_LIGHTS))
        throwInvalid("{}: {} lights; at most {} are supported", scene.name, scene.lights.size(), MAX_LIGHTS);
    if (scene.shapes.size() * (scene.lights.size() + 1) > MAX_MARCHES)
        throwInvalid("{}: {} shapes times {} lights and the camera; at most {} marches a pixel are supported",
                     scene.name, scene.shapes.size(), scene.lights.size(), MAX_MARCHES);
    if (scene.integrator.max_depth > MAX_DEPTH)
        throwInvalid("{}: maxdepth {}; at most {} is supported", scene.name, scene.integrator.max_depth, MAX_DEPTH);
    if (triangles > std::size_t(MAX_TRIANGLES))
        throwInvalid("{}: {} triangles; at most {} are supported", scene.name, triangles, MAX_TRIANGLES);
}

}  // namespace

dmat4 worldFromDevice(const Shape& shape) {
    const auto* mesh = std::get_if<TriangleMesh>(&shape.geometry);
    return mesh ? translated(shape.world_from_object, middleOf(*mesh)) : shape.world_from_object;
}

void packCamera(PackedState& state, const Scene& scene) {
    Raster raster = makeRaster(scene.camera, scene.film);
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        PackedObject& object = state.objects[i];
        const ObjectSpace space = objectSpaceOf(scene.shapes[i], object.unit);
        packCameraRays(object.data, space, raster);
        packPixelSize(object.data, space, raster);
    }
}

void packLook(PackedState& state, const PathTables& tables, const Scene& scene, const SceneMaps& maps) {
    for (std::size_t i = 0; i < scene.shapes.size(); ++i)
        packColour(state.objects[i].data, scene.shapes[i], maps.reliefs[i]);
    state.lights = packLights(scene, maps, tables, centreOf(scene.shapes[0]));
    state.materials = packMaterials(scene, tables);
}

PackedScene packScene(const Scene& scene, const SceneMaps& maps, Levels levels) {
    PackedScene packed;
    packed.traits = traitsOf(scene);
    requireLimits(scene, packed.traits.triangles);
    packed.memory_limit = maps.memory_limit;
    for (const auto& map : maps.maps) {
        packed.nodes.push_back(std::make_unique<NodeGrid>(*map));
        packed.traits.tiles = packed.traits.tiles || map->tiled;
    }
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        const Shape& shape = scene.shapes[i];
        PackedObject object;
        packGeometry(object, packed, shape, maps.map_of_shape[i], maps.reliefs[i], levels);
        packTransforms(object.data, objectSpaceOf(shape, object.unit));
        object.data.from_first =
            toVec4(centreOf(shape) - centreOf(scene.shapes[0]), holdingRadius(object.data, shape, object.unit));
        packed.state.objects.push_back(std::move(object));
    }
    packImages(packed, scene, maps);
    packed.tables = makePathTables(scene, maps);
    packCamera(packed.state, scene);
    packLook(packed.state, packed.tables, scene, maps);
    for (const Ramp& ramp : ramps())
        for (const dvec3& point : ramp.points) packed.ramp_points.push_back(toVec4(point, 1.0));
    return packed;
}

}  // namespace dsphere
