#include "base/limits.h"
#include "scene/blackbody.h"
#include "scene/directives.h"
#include "scene/transforms.h"

#include <algorithm>
#include <cmath>

namespace dsphere {

namespace {

constexpr Range kKelvin{500.0, 100000.0};
constexpr double kRigid = 1e-5;  // how far a rotation may scale: written matrices have six digits

// v4's scale is a float, v3's a colour.
dvec3 scaleOf(Parameters& p) {
    return p.valueOr("scale", {"float", "rgb"}, dvec3(1.0), [](const Parameter& scale) {
        return scale.type == "rgb" ? tripleValue(scale, kNotNegative) : dvec3(numberValue(scale, kNotNegative));
    });
}

// One number is v4's temperature; pairs of a temperature and a factor are v3's.
dvec3 blackbodyOf(const Parameter& parameter) {
    if (parameter.values.size() == 1) return blackbodyOfLuminance1(numberValue(parameter, kKelvin));
    const std::vector<double> pairs = listValue(parameter, 2, "pairs of kelvin and factor", 16);
    dvec3 sum(0.0);
    for (std::size_t i = 0; i < pairs.size(); i += 2) {
        if (!kKelvin.holds(pairs[i]) || !(pairs[i + 1] >= 0.0))
            failAt(parameter.values[i].where,
                   "parameter {} is {} kelvin times {}; supported: {} kelvin, times 0 or more",
                   inQuotes(parameter.name), pairs[i], pairs[i + 1], kKelvin.text());
        sum += pairs[i + 1] * blackbodyOfPeak1(pairs[i]);
    }
    return sum;
}

dvec3 emission(Statement s, Parameters& p, std::string_view name) {
    const dvec3 colour = p.valueOr(name, {"rgb", "blackbody"}, dvec3(1.0), [](const Parameter& light) {
        return light.type == "rgb" ? tripleValue(light, kNotNegative) : blackbodyOf(light);
    });
    const dvec3 product = colour * scaleOf(p);
    if (glm::any(glm::greaterThan(product, dvec3(limits::kRadiance))))
        p.attempt([&] {
            failAt(s.word.where, "{} times scale is {}; supported: at most {}", name,
                   std::max({product.x, product.y, product.z}), limits::kRadiance);
        });
    p.refuse("power", fmt::format("lights are not scaled by their power; give {}, the light itself", name));
    p.refuse("illuminance", fmt::format("lights are not scaled by what they light; give {} and scale", name));
    // How many samples pbrt takes of this light at once.
    for (const char* samples : {"samples", "nsamples"}) p.ignore(samples, {"integer"});
    return product;
}

DistantLight distantLight(Statement s, Parameters& p) {
    DistantLight light;
    light.radiance = emission(s, p, "L");
    dvec3 from = p.point("from").value_or(dvec3(0.0));
    dvec3 to = p.point("to").value_or(dvec3(0.0, 0.0, 1.0));
    p.finish();
    std::optional<dvec3> direction = unitVector(transformVector(s.state.attributes.ctm, from - to));
    if (!direction)
        failAt(s.word.where, "the distant light has no direction: from and to coincide under the transform");
    light.direction = *direction;
    return light;
}

PointLight pointLight(Statement s, Parameters& p) {
    PointLight light;
    light.intensity = emission(s, p, "I");
    light.position = transformPoint(s.state.attributes.ctm, p.point("from").value_or(dvec3(0.0)));
    p.finish();
    if (!glm::all(glm::lessThanEqual(glm::abs(light.position), dvec3(limits::kGreatestCoordinate))))
        failAt(s.word.where, "the point light is at {} {} {}; supported: coordinates up to {}", light.position.x,
               light.position.y, light.position.z, limits::kGreatestCoordinate);
    return light;
}

// v3 names the image by mapname, v4 by filename.
std::optional<Token> lightImage(Parameters& p) {
    std::optional<Token> mapname = p.string("mapname"), filename = p.string("filename");
    std::optional<Token> name = mapname ? mapname : filename;
    p.attempt([&] {
        if (mapname && filename) failAt(*p.placeOf("filename"), "mapname and filename mean the same: give one");
        if (name && name->text.empty()) failAt(name->where, "the image's name is empty");
    });
    return name;
}

InfiniteLight infiniteLight(Statement s, Parameters& p) {
    InfiniteLight light;
    light.radiance = emission(s, p, "L");
    light.where = s.word.where;
    if (std::optional<Token> name = lightImage(p)) {
        light.map_path = resolvePath(s, name->text);
        light.where = name->where;
    }
    p.finish();
    light.world_from_light = dmat3(s.state.attributes.ctm);
    std::optional<double> scale = angleKeepingScale(light.world_from_light);
    if (!scale || std::abs(*scale - 1.0) > kRigid)
        failAt(s.word.where, "the infinite light's transform scales or shears; supported: rotations and mirrorings");
    for (const Light& other : s.state.scene.lights)
        if (const auto* earlier = std::get_if<InfiniteLight>(&other))
            failAt(s.word.where, "a second infinite light, the first being at {}; supported: one",
                   earlier->where.text());
    return light;
}

}  // namespace

void lightSource(Statement s) {
    auto [name, p] = readNamed(s, "light", {"distant", "point", "infinite"}, s.state.attributes.defaults.light);
    auto& lights = s.state.scene.lights;
    requireRoom(s, s.state.scene.shapes.size(), lights.size() + 1);
    if (name.text == "distant")
        lights.push_back(distantLight(s, p));
    else if (name.text == "point")
        lights.push_back(pointLight(s, p));
    else
        lights.push_back(infiniteLight(s, p));
}

void areaLightSource(Statement s) {
    auto [name, p] = readNamed(s, "area light", {"diffuse"}, s.state.attributes.defaults.light);
    Emission shining;
    shining.radiance = emission(s, p, "L");
    shining.two_sided = p.boolean("twosided").value_or(shining.two_sided);
    p.finish();
    s.state.attributes.emission = shining;
}

}  // namespace dsphere
