#include "scene/directives.h"
#include "scene/transforms.h"

namespace dsphere {

namespace {

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

}  // namespace

void lightSource(Statement s) {
    auto [name, p] = readNamed(s, "light", {"distant", "point"});
    if (name.text == "distant")
        s.state.scene.lights.push_back(distantLight(s, p));
    else
        s.state.scene.lights.push_back(pointLight(s, p));
}

}  // namespace dsphere
