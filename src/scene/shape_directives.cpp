#include "base/limits.h"
#include "scene/directives.h"
#include "scene/shaperange.h"
#include "scene/transforms.h"

namespace dsphere {

namespace {

constexpr Range kPercent{-limits::kDisplacement, limits::kDisplacement};
constexpr Range kFullTurn{360.0, kInfinity};

std::optional<Registration> registrationOf(Parameters& p) {
    std::optional<std::string> word = p.choice("registration", {"texel", "gridline"});
    if (!word) return {};
    return *word == "texel" ? Registration::Texel : Registration::Gridline;
}

// What a closed form replaces or has no use for is an error beside it, and so are its frequencies without it.
std::optional<Ripples> ripplesOf(Parameters& p) {
    std::optional<std::string> name = p.choice("displacementfunction", {"ripples"});
    Ripples ripples;
    ripples.u_frequency = p.integer("ufrequency", 1, limits::kRippleFrequency).value_or(ripples.u_frequency);
    ripples.v_frequency = p.integer("vfrequency", 1, limits::kRippleFrequency).value_or(ripples.v_frequency);
    if (!p.placeOf("displacementfunction")) {
        for (const char* frequency : {"ufrequency", "vfrequency"})
            if (auto where = p.placeOf(frequency))
                p.attempt(
                    [&] { failAt(*where, "{} belongs to a displacementfunction, which is not given", frequency); });
    } else {
        for (const char* other : {"displacementmap", "filter", "registration", "blur", "nodata", "band"})
            if (auto where = p.placeOf(other))
                p.attempt([&] { failAt(*where, "{} and displacementfunction exclude each other: give one", other); });
    }
    return name ? std::optional(ripples) : std::nullopt;
}

DisplacedSphere displacedSphere(Statement s, Parameters& p) {
    DisplacedSphere sphere;
    sphere.radius = p.number("radius", kPositive).value_or(sphere.radius);
    std::optional<double> percent = p.number("maxdispl", kPercent);
    sphere.max_displacement = percent.value_or(sphere.max_displacement);
    if (auto path = p.string("displacementmap")) {
        if (path->text.empty())
            p.attempt([&] { failAt(path->where, "the displacementmap's name is empty"); });
        else
            sphere.map_path = resolvePath(s, path->text);
    }
    sphere.midlevel = p.number("midlevel", kAnyNumber).value_or(sphere.midlevel);
    sphere.ripples = ripplesOf(p);
    if (p.choice("filter", {"bilinear", "bspline"}) == "bspline") sphere.filter = Filter::BSpline;
    sphere.smooth_normals = p.boolean("smoothnormals").value_or(sphere.smooth_normals);
    sphere.registration = registrationOf(p);
    sphere.longitude_origin = p.number("lonorigin", kLongitudeOrigin);
    sphere.height_min = p.number("heightmin", kAnyNumber);
    sphere.height_max = p.number("heightmax", kAnyNumber);
    sphere.height_scale = p.number("heightscale", kAnyNumber);
    sphere.blur = p.number("blur", kBlur).value_or(sphere.blur);
    sphere.nodata = p.numberOrNan("nodata", kStoredValue);
    sphere.band = p.integer("band", 1, kMostBands);
    p.finish();
    if (percent && sphere.height_scale) failAt(s.word.where, "maxdispl and heightscale exclude each other: give one");
    if (sphere.height_min && sphere.height_min == sphere.height_max) failAt(s.word.where, "heightmin equals heightmax");
    return sphere;
}

Sphere plainSphere(Parameters& p) {
    Sphere sphere;
    sphere.radius = p.number("radius", kPositive).value_or(sphere.radius);
    p.ignoreWithin("zmin", {-kInfinity, -sphere.radius}, "at most minus the radius: whole spheres");
    p.ignoreWithin("zmax", {sphere.radius, kInfinity}, "at least the radius: whole spheres");
    p.ignoreWithin("phimax", kFullTurn, "360: whole spheres");
    return sphere;
}

Disk disk(Statement s, Parameters& p) {
    Disk disk;
    disk.height = p.number("height", kAnyNumber).value_or(disk.height);
    disk.radius = p.number("radius", kPositive).value_or(disk.radius);
    disk.inner_radius = p.number("innerradius", kNotNegative).value_or(disk.inner_radius);
    p.ignoreWithin("phimax", kFullTurn, "360: whole disks");
    p.finish();
    if (disk.inner_radius >= disk.radius)
        failAt(s.word.where, "innerradius {} is not below the radius {}", disk.inner_radius, disk.radius);
    return disk;
}

Geometry geometryOf(Statement s, std::string_view name, Parameters& p) {
    // Nothing is cut out of a shape.
    for (const char* alpha : {"alpha", "shadowalpha"}) p.ignoreWithin(alpha, {1.0, kInfinity}, "1, opaque");
    if (name == "displacedsphere") return displacedSphere(s, p);
    if (name == "disk") return disk(s, p);
    if (name == "trianglemesh") return triangleMesh(s, p);
    if (name == "bilinearmesh") return bilinearMesh(s, p);
    Sphere sphere = plainSphere(p);
    p.finish();
    return sphere;
}

// The shape just parsed shines as the attributes say: its index is the next one.
void addAreaLight(Statement s, std::string_view kind, const Shape& shape) {
    const Emission& emission = *s.state.attributes.emission;
    if (kind != "sphere" && kind != "disk")
        failAt(s.word.where, "an AreaLightSource holds for this {}, which cannot shine; supported: sphere, disk", kind);
    if (s.state.attributes.reversed && !emission.two_sided)
        failAt(s.word.where,
               "ReverseOrientation turns the side from which this {} shines; supported: without it, a disk turned over",
               kind);
    if (emission.two_sided && kind == "sphere")
        failAt(s.word.where, "a sphere cannot shine on both sides; supported: twosided on a disk");
    if (!angleKeepingScale(dmat3(shape.world_from_object)))
        failAt(s.word.where,
               "the transform of this {} that shines changes angles; supported: rotations, mirrorings and uniform "
               "scales",
               kind);
    s.state.scene.lights.push_back(AreaLight{int(s.state.scene.shapes.size()), emission.radiance, emission.two_sided});
}

}  // namespace

namespace {

void requireFitting(Statement s, std::string_view kind, const Shape& shape) {
    if (textureAs<HeightRamp>(shape.material) && kind != "displacedsphere")
        failAt(s.word.where, "a heightramp colours by height, which a {} has not; supported on: displacedsphere", kind);
}

void requireRoomForShape(Statement s, const Shape& shape) {
    ParseState& state = s.state;
    const bool shines = state.attributes.emission.has_value();
    requireRoom(s, state.scene.shapes.size() + 1, state.scene.lights.size() + (shines ? 1 : 0));
    if (const auto* mesh = std::get_if<TriangleMesh>(&shape.geometry)) state.triangles += mesh->triangles.size();
    if (state.triangles > limits::kTriangles)
        stopAt(state.report, s.word.where, "the meshes of the scene have more than {} triangles", limits::kTriangles);
}

}  // namespace

void requireRoom(Statement s, std::size_t shapes, std::size_t lights) {
    Report& report = s.state.report;
    if (shapes > limits::kShapes) stopAt(report, s.word.where, "the scene has more than {} shapes", limits::kShapes);
    if (lights > limits::kLights)
        stopAt(report, s.word.where, "the scene has more than {} lights, those that shine as shapes counted",
               limits::kLights);
    if (shapes * (lights + 1) > limits::kMarches)
        stopAt(report, s.word.where, "the shapes times the lights and the camera are more than {} here",
               limits::kMarches);
}

void shape(Statement s) {
    auto [name, p] = readNamed(s, "shape", {"displacedsphere", "sphere", "disk", "trianglemesh", "bilinearmesh"},
                               s.state.attributes.defaults.shape);
    Shape shape;
    shape.world_from_object = s.state.attributes.ctm;
    shape.material = s.state.attributes.material;
    shape.where = s.word.where;
    const bool singular = !isInvertible(shape.world_from_object);
    if (singular) p.attempt([&] { failAt(s.word.where, "the shape's transform is singular"); });
    shape.geometry = geometryOf(s, name.text, p);
    requireFitting(s, name.text, shape);
    requireShapeInRange(shape);
    requireRoomForShape(s, shape);
    if (s.state.attributes.emission) addAreaLight(s, name.text, shape);
    s.state.scene.shapes.push_back(std::move(shape));
}

}  // namespace dsphere
