#include "scene/directives.h"
#include "scene/transforms.h"

namespace dsphere {

namespace {

std::optional<Registration> registrationOf(Parameters& p) {
    std::optional<std::string> word = p.choice("registration", {"texel", "gridline"});
    if (!word) return {};
    return *word == "texel" ? Registration::Texel : Registration::Gridline;
}

constexpr int kMostRipples = 512;

// What a closed form replaces or has no use for is an error beside it, and so are its frequencies without it.
std::optional<Ripples> ripplesOf(Parameters& p) {
    std::optional<std::string> name = p.choice("displacementfunction", {"ripples"});
    Ripples ripples;
    ripples.u_frequency = p.integer("ufrequency", 1, kMostRipples).value_or(ripples.u_frequency);
    ripples.v_frequency = p.integer("vfrequency", 1, kMostRipples).value_or(ripples.v_frequency);
    if (!name) {
        for (const char* frequency : {"ufrequency", "vfrequency"})
            if (auto where = p.placeOf(frequency))
                failAt(*where, "{} belongs to a displacementfunction, which is not given", frequency);
        return {};
    }
    for (const char* other : {"displacementmap", "filter", "registration", "blur", "nodata", "band"})
        if (auto where = p.placeOf(other))
            failAt(*where, "{} and displacementfunction exclude each other: give one", other);
    return ripples;
}

DisplacedSphere displacedSphere(Statement s, Parameters& p) {
    DisplacedSphere sphere;
    sphere.radius = p.number("radius", kPositive).value_or(sphere.radius);
    std::optional<double> percent = p.number("maxdispl", kAnyNumber);
    sphere.max_displacement = percent.value_or(sphere.max_displacement);
    if (auto path = p.string("displacementmap")) {
        if (path->text.empty()) failAt(path->where, "the displacementmap's name is empty");
        sphere.map_path = s.source.resolve(path->text);
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
    p.finish();
    return sphere;
}

Disk disk(Statement s, Parameters& p) {
    Disk disk;
    disk.height = p.number("height", kAnyNumber).value_or(disk.height);
    disk.radius = p.number("radius", kPositive).value_or(disk.radius);
    disk.inner_radius = p.number("innerradius", kNotNegative).value_or(disk.inner_radius);
    p.finish();
    if (disk.inner_radius >= disk.radius)
        failAt(s.word.where, "innerradius {} is not below the radius {}", disk.inner_radius, disk.radius);
    return disk;
}

}  // namespace

namespace {

// The shape just parsed shines as the attributes say: its index is the next one.
void addAreaLight(Statement s, std::string_view kind, const Shape& shape) {
    const Emission& emission = *s.state.attributes.emission;
    if (kind != "sphere" && kind != "disk")
        failAt(s.word.where, "an AreaLightSource holds for this {}, which cannot shine; supported: sphere, disk", kind);
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

void shape(Statement s) {
    auto [name, p] = readNamed(s, "shape", {"displacedsphere", "sphere", "disk", "trianglemesh"});
    Shape shape;
    shape.world_from_object = s.state.attributes.ctm;
    shape.material = s.state.attributes.material;
    shape.where = s.word.where;
    if (!isInvertible(shape.world_from_object)) failAt(s.word.where, "the shape's transform is singular");
    if (name.text == "displacedsphere")
        shape.geometry = displacedSphere(s, p);
    else if (name.text == "sphere")
        shape.geometry = plainSphere(p);
    else if (name.text == "disk")
        shape.geometry = disk(s, p);
    else
        shape.geometry = triangleMesh(s, p);
    bool by_height = textureAs<HeightRamp>(shape.material) != nullptr;
    if (by_height && name.text != "displacedsphere")
        failAt(s.word.where, "a heightramp colours by height, which a {} has not; supported on: displacedsphere",
               name.text);
    if (s.state.attributes.emission) addAreaLight(s, name.text, shape);
    s.state.scene.shapes.push_back(std::move(shape));
}

}  // namespace dsphere
