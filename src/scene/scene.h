#pragma once

// The scene as plain data in double, as the text said it: nothing here is packed, uploaded or narrowed.
// Space: pbrt's left-handed world; transforms act on column vectors.

#include "base/math.h"
#include "base/notice.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace dsphere {

/// Where a word stands in a scene file; lines and columns count from 1. Line 0 is the file as a whole.
struct SourceLocation {
    std::string file;
    int line = 1, column = 1;

    std::string text() const;  ///< "file:line:column", or "file"
};

enum class Projection { Perspective, Orthographic };

struct Camera {
    Projection projection = Projection::Perspective;
    dmat4 camera_from_world{1.0};  ///< the CTM at the Camera directive; camera looks along +z, y up, x right
    double fov_degrees = 90.0;     ///< perspective: over the shorter axis; in (0, 180)
    /// Screen window {x0, x1, y0, y1}; unset: the shorter axis spans [-1, 1].
    std::optional<std::array<double, 4>> screen_window;
    std::optional<double> frame_aspect_ratio;  ///< width / height that the window is made for; unset: the film's

    bool operator==(const Camera&) const = default;
};

struct Film {
    std::string filename = "dsphere.exr";
    int width = 1280, height = 720;
    std::array<double, 4> crop{0.0, 1.0, 0.0, 1.0};  ///< {x0, x1, y0, y1} as fractions, y downward

    bool operator==(const Film&) const = default;
};

struct Sampler {
    int pixel_samples = 16;
    int seed = 0;

    bool operator==(const Sampler&) const = default;
};

/// How light is gathered along a camera ray.
struct Integrator {
    enum class Kind { DirectLighting, Path };

    Kind kind = Kind::DirectLighting;  ///< of scenes made in code; a scene file's default is Path
    int max_depth = 5;  ///< reflections that are followed, 0 or more; directlighting: mirrors alone reflect
    /// The greatest radiance of a sample: one whose greatest channel is above it is scaled down to it as a whole, so
    /// that its hue stays. 0: no bound. An option of the command line; scene files have no word for it.
    double clamp = 0.0;
    /// path: facets that are met after another reflection than mirrors' are rougher, see regularized(). Less noise, and
    /// bright spots thrown by metals are wider and fainter than they should be.
    bool regularize = false;
    /// Camera rays that miss everything see no infinite light: what is behind the shapes stays empty. An option of the
    /// command line, as `clamp` is.
    bool hide_distance = false;

    bool operator==(const Integrator&) const = default;
};

/// How samples about a pixel's centre weigh: a separable kernel, 0 beyond the radius r. Mitchell and Sinc are negative
/// in places. With x the distance along an axis:
///   Gaussian  exp(-falloff x^2) - exp(-falloff r^2)
///   Triangle  r - x
///   Mitchell  the cubic of Mitchell and Netravali 1988 with B and C at 2 x / r
///   Sinc      sinc(x) sinc(x / tau), sinc(x) = sin(pi x) / (pi x)
struct PixelFilter {
    enum class Kind { Box, Gaussian, Triangle, Mitchell, Sinc };

    Kind kind = Kind::Box;
    dvec2 radius{0.5};                    ///< in pixels, > 0, at most 8
    double falloff = 2.0;                 ///< 0.001 to 1000; pbrt v3's alpha, v4's 1 / (2 sigma^2)
    double b = 1.0 / 3.0, c = 1.0 / 3.0;  ///< 0 to 1
    double tau = 3.0;                     ///< 1 to 100

    bool operator==(const PixelFilter&) const = default;
};

/// "box", "gaussian", ...: as the scene language calls it.
const char* nameOf(PixelFilter::Kind kind);

enum class Registration { Texel, Gridline };

/// How heights run between a map's values.
enum class Filter { Bilinear, BSpline };

/// Heights in closed form instead of a map: h = 0.5 + 0.5 sin(2 pi u_frequency u) sin(pi v_frequency v).
struct Ripples {
    int u_frequency = 12, v_frequency = 12;  ///< 1 to 512

    bool operator==(const Ripples&) const = default;
};

/// The displaced sphere, poles on ±y: r(u, v) = radius + k (h(u, v) - midlevel).
struct DisplacedSphere {
    double radius = 1.0;            ///< > 0, object units
    double max_displacement = 0.0;  ///< percent of the radius; negative is allowed
    std::string map_path;           ///< resolved against the scene file's folder; empty: no map, h = 0
    double midlevel = 0.0;
    std::optional<double> height_scale;            ///< object units per stored unit; replaces max_displacement
    std::optional<double> height_min, height_max;  ///< stored values that mean h = 0 and h = 1
    bool own_range = false;                        ///< where those are unset: the map's least and greatest value
    bool true_scale = false;                       ///< own_range: in proportion to the radius, if the map knows it
    std::optional<Registration> registration;      ///< unset: the map's own default
    std::optional<double> longitude_origin;  ///< degrees at the image's left edge; unset: the map's own, else -180
    double blur = 0.0;                       ///< sigma of a Gaussian in texels, 0 to 1000; 0: none
    std::optional<double> nodata;            ///< the stored value that means "unknown"; may be NaN
    std::optional<int> band;                 ///< of a file with several, from 1; unset: see geo/readmap.h
    Filter filter = Filter::Bilinear;
    std::optional<Ripples> ripples;  ///< in place of a map
    bool smooth_normals = false;     ///< shading normals are the B-spline's, whatever the filter

    bool operator==(const DisplacedSphere&) const = default;
};

/// A plain sphere about the origin.
struct Sphere {
    double radius = 1.0;

    bool operator==(const Sphere&) const = default;
};

/// A flat ring in the plane z = height; innerradius <= distance from the z axis <= radius. Two-sided; its normal is +z.
struct Disk {
    double height = 0.0, radius = 1.0, inner_radius = 0.0;

    bool operator==(const Disk&) const = default;
};

/// Flat two-sided triangles, at most 64; a triangle's normal is (p1 - p0) x (p2 - p0).
struct TriangleMesh {
    std::vector<dvec3> points;                  ///< object space
    std::vector<std::array<int, 3>> triangles;  ///< indices of points
    std::vector<dvec2> uvs;                     ///< one a point, or empty: pbrt's (0,0), (1,0), (1,1) of every triangle

    bool operator==(const TriangleMesh&) const = default;
};

/// The middle of its bounding box: what a mesh's tolerances and device coordinates are counted from.
dvec3 middleOf(const TriangleMesh& mesh);

struct ConstantColour {
    dvec3 rgb{0.5};

    bool operator==(const ConstantColour&) const = default;
};

/// Coloured by the height h of the displaced sphere it is on, h = 0 the ramp's first colour and h = 1 its last.
struct HeightRamp {
    std::string ramp;  ///< a name of scene/ramps.h
    dvec3 scale{1.0};  ///< 0 or greater; the product is cut to [0, 1]

    bool operator==(const HeightRamp&) const = default;
};

/// An image, read bilinearly and repeated. On a displaced sphere it lies as the heights do, row 0 in the north; on
/// other shapes by pbrt's own (u, v), row 0 at v = 1.
struct ImageMap {
    std::string path;                  ///< resolved against the scene file's folder
    dvec3 scale{1.0};                  ///< 0 or greater; the product is cut to [0, 1]
    double longitude_origin = -180.0;  ///< degrees at the image's left edge, on displaced spheres alone
    SourceLocation where;

    bool operator==(const ImageMap& other) const {
        return path == other.path && scale == other.scale && longitude_origin == other.longitude_origin;
    }
};

/// Two colours by turns: `even` where floor(u_scale u) + floor(v_scale v) is even, (u, v) as the shape has them.
struct Checkerboard {
    dvec3 even{1.0}, odd{0.0};  ///< in [0, 1]
    double u_scale = 1.0, v_scale = 1.0;

    bool operator==(const Checkerboard&) const = default;
};

using Texture = std::variant<ConstantColour, HeightRamp, ImageMap, Checkerboard>;

/// Diffuse: Lambert's law, or with sigma > 0 that of Oren and Nayar 1994 in its simple form.
struct Matte {
    Texture reflectance = ConstantColour{};
    double sigma = 0.0;  ///< standard deviation of the facets' angle in degrees, 0 to 90

    bool operator==(const Matte&) const = default;
};

/// A rough metal: GGX facets that reflect as Fresnel's equations say, light that bounces between them included.
struct Conductor {
    dvec3 eta{0.2004, 0.9240, 1.1022}, k{3.9129, 2.4528, 2.1421};  ///< complex index of refraction, RGB; 0 to 1000
    double alpha = 0.1;                                            ///< GGX's, 0.001 to 1

    bool operator==(const Conductor&) const = default;
};

struct Mirror {
    dvec3 reflectance{0.9};  ///< in [0, 1]

    bool operator==(const Mirror&) const = default;
};

/// pbrt v3's plastic: Lambert's law, and GGX facets of a dielectric with index of refraction 1.5 above it.
struct Plastic {
    Texture diffuse = ConstantColour{dvec3(0.25)};
    dvec3 specular{0.25};  ///< factor of the facets' reflection, in [0, 1]
    double alpha = 0.1;    ///< GGX's, 0.001 to 1

    bool operator==(const Plastic&) const = default;
};

using Material = std::variant<Matte, Conductor, Mirror, Plastic>;

/// The material with GGX's alpha under 0.3 doubled, and at least 0.1 and at most 0.3 then, as pbrt v4 regularises it.
Material regularized(Material material);

/// The colour texture of a material that may vary over its shape; nullptr: the material has none.
const Texture* textureOf(const Material& material);
Texture* textureOf(Material& material);

/// The texture of the matte material that looks most like this one.
Texture matteTextureOf(const Material& material);

using Geometry = std::variant<DisplacedSphere, Sphere, Disk, TriangleMesh>;

struct Shape {
    Geometry geometry;
    dmat4 world_from_object{1.0};  ///< invertible
    Material material;
    SourceLocation where;
};

struct DistantLight {
    dvec3 direction{0.0, 0.0, -1.0};  ///< world, unit, from the scene towards the light
    dvec3 radiance{1.0};              ///< irradiance on a facing surface; L times scale

    bool operator==(const DistantLight&) const = default;
};

struct PointLight {
    dvec3 position{0.0};   ///< world
    dvec3 intensity{1.0};  ///< I times scale

    bool operator==(const PointLight&) const = default;
};

/// Light from everywhere far away: constant, or an equirectangular image of it. A scene has at most one.
struct InfiniteLight {
    dvec3 radiance{1.0};          ///< L times scale; multiplies the image
    std::string map_path;         ///< resolved; empty: constant
    dmat3 world_from_light{1.0};  ///< a rotation, perhaps mirrored. The image's top is +z; from +x at its left edge it
                                  ///< runs towards +y
    SourceLocation where;         ///< of the image's name

    bool operator==(const InfiniteLight& other) const {
        return radiance == other.radiance && map_path == other.map_path && world_from_light == other.world_from_light;
    }
};

/// A sphere or a disk that shines; its transform keeps angles. A sphere shines outward, a disk from its +z side.
struct AreaLight {
    int shape = 0;        ///< index in Scene::shapes
    dvec3 radiance{1.0};  ///< L times scale
    bool two_sided = false;

    bool operator==(const AreaLight&) const = default;
};

using Light = std::variant<DistantLight, PointLight, InfiniteLight, AreaLight>;

/// `texture` if it is a T; nullptr if it is another or there is none.
template <typename T>
const T* textureAs(const Material& material) {
    const Texture* texture = textureOf(material);
    return texture ? std::get_if<T>(texture) : nullptr;
}

struct Scene {
    std::string name;  ///< the file it came from, or "-"
    Camera camera;
    Film film;
    Sampler sampler;
    Integrator integrator;
    PixelFilter pixel_filter;
    std::vector<Shape> shapes;          ///< in the file's order; never empty
    std::vector<Light> lights;          ///< in the file's order
    std::vector<std::string> included;  ///< the files that Include has read, as they were opened
    /// By the path of a file that is not there: what its error adds, "; sought at a/b.png too; to get it: ...".
    std::map<std::string, std::string> missing;
    Notices notices;  ///< what the parser has to say of the text, in its order
};

}  // namespace dsphere
