#include "scene/directives.h"
#include "scene/transforms.h"

#include <cmath>

namespace dsphere {

namespace {

constexpr double kRigid = 1e-5;  // how far a rotation may scale: written matrices have six digits

// v4's scale is a float, v3's a colour.
dvec3 scaleOf(Parameters& p) {
    const Parameter* parameter = p.take("scale", {"float", "rgb"});
    if (!parameter) return dvec3(1.0);
    if (parameter->type == "rgb") return tripleValue(*parameter, kNotNegative);
    return dvec3(numberValue(*parameter, kNotNegative));
}

dvec3 emission(Statement s, Parameters& p, std::string_view name) {
    dvec3 product = p.rgb(name, kNotNegative).value_or(dvec3(1.0)) * scaleOf(p);
    if (glm::any(glm::isinf(product))) failAt(s.word.where, "{} times scale overflows", name);
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
    if (glm::any(glm::isinf(light.position)) || glm::any(glm::isnan(light.position)))
        failAt(s.word.where, "the point light's position overflows");
    return light;
}

// v3 names the image by mapname, v4 by filename.
std::optional<Token> lightImage(Parameters& p) {
    std::optional<Token> mapname = p.string("mapname"), filename = p.string("filename");
    if (mapname && filename) failAt(*p.placeOf("filename"), "mapname and filename mean the same: give one");
    std::optional<Token> name = mapname ? mapname : filename;
    if (name && name->text.empty()) failAt(name->where, "the image's name is empty");
    return name;
}

InfiniteLight infiniteLight(Statement s, Parameters& p) {
    InfiniteLight light;
    light.radiance = emission(s, p, "L");
    light.where = s.word.where;
    if (std::optional<Token> name = lightImage(p)) {
        light.map_path = s.source.resolve(name->text);
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
    auto [name, p] = readNamed(s, "light", {"distant", "point", "infinite"});
    auto& lights = s.state.scene.lights;
    if (name.text == "distant")
        lights.push_back(distantLight(s, p));
    else if (name.text == "point")
        lights.push_back(pointLight(s, p));
    else
        lights.push_back(infiniteLight(s, p));
}

void areaLightSource(Statement s) {
    auto [name, p] = readNamed(s, "area light", {"diffuse"});
    Emission shining;
    shining.radiance = emission(s, p, "L");
    shining.two_sided = p.boolean("twosided").value_or(shining.two_sided);
    p.finish();
    s.state.attributes.emission = shining;
}

}  // namespace dsphere
