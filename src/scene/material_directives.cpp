#include "scene/directives.h"
#include "scene/metals.h"

#include <algorithm>
#include <cmath>

namespace dsphere {

namespace {

constexpr Range kDegrees{0.0, 90.0};
constexpr Range kIndex{0.0, 1000.0};  // of refraction
constexpr double kLeastAlpha = 0.001;

// v3 says Kd, v4 reflectance; either spelling of the material takes either.
Matte matteOf(Statement s, Parameters& p) {
    Matte matte;
    const Parameter* kd = p.take("Kd", {"rgb", "texture"});
    const Parameter* reflectance = p.take("reflectance", {"rgb", "texture"});
    if (kd && reflectance) failAt(reflectance->where, "Kd and reflectance mean the same: give one");
    if (kd) matte.reflectance = textureValue(s, *kd);
    if (reflectance) matte.reflectance = textureValue(s, *reflectance);
    matte.sigma = p.number("sigma", kDegrees).value_or(matte.sigma);
    return matte;
}

// Of roughness: v3's fit (TrowbridgeReitzDistribution::RoughnessToAlpha), v4's square root.
double remapped(double roughness, bool v4) {
    if (v4) return std::sqrt(roughness);
    const double x = std::log(std::max(roughness, 0.001));
    return 1.62142 + x * (0.819955 + x * (0.1734 + x * (0.0171201 + x * 0.000640711)));
}

// GGX's alpha of `roughness` or its two halves along u and v, which must agree.
double alphaOf(Parameters& p, double roughness, bool v4) {
    roughness = p.number("roughness", kNotNegative).value_or(roughness);
    const double u = p.number("uroughness", kNotNegative).value_or(roughness);
    const double v = p.number("vroughness", kNotNegative).value_or(roughness);
    if (u != v) {
        std::optional<SourceLocation> where = p.placeOf("uroughness");
        failAt(where ? *where : *p.placeOf("vroughness"),
               "uroughness {} is not vroughness {}; supported: the same roughness in all directions", u, v);
    }
    const bool remap = p.boolean("remaproughness").value_or(true);
    return std::clamp(remap ? remapped(u, v4) : u, kLeastAlpha, 1.0);
}

// Of v4's "metal-Cu-eta", or plainly "Cu".
const Metal& metalNamed(const Parameter& parameter) {
    const Token& word = stringValue(parameter);
    Words names;
    for (const Metal& metal : metals()) {
        if (word.text == metal.name || word.text == fmt::format("metal-{}-{}", metal.name, parameter.name))
            return metal;
        names.push_back(metal.name);
    }
    failAt(word.where, "unknown spectrum {} of {}; supported: {}, also as \"metal-Cu-{}\"", described(word),
           parameter.name, listed(names), parameter.name);
}

Conductor conductorOf(Parameters& p, bool v4) {
    Conductor metal;
    if (const Parameter* eta = p.take("eta", {"rgb", "spectrum"}))
        metal.eta = eta->type == "rgb" ? tripleValue(*eta, kIndex) : metalNamed(*eta).eta;
    if (const Parameter* k = p.take("k", {"rgb", "spectrum"}))
        metal.k = k->type == "rgb" ? tripleValue(*k, kIndex) : metalNamed(*k).k;
    metal.alpha = alphaOf(p, 0.01, v4);
    return metal;
}

dvec3 factorOf(Statement s, Parameters& p, std::string_view name, const dvec3& otherwise) {
    const Parameter* parameter = p.take(name, {"rgb", "texture"});
    return parameter ? constantValue(s, *parameter, kFraction) : otherwise;
}

Plastic plasticOf(Statement s, Parameters& p) {
    Plastic plastic;
    if (const Parameter* kd = p.take("Kd", {"rgb", "texture"})) plastic.diffuse = textureValue(s, *kd);
    plastic.specular = factorOf(s, p, "Ks", plastic.specular);
    plastic.alpha = alphaOf(p, 0.1, false);
    return plastic;
}

const Words kMaterials = {"matte", "diffuse", "metal", "conductor", "mirror", "plastic"};

Material materialOf(Statement s, std::string_view type, Parameters& p) {
    Material material;
    if (type == "metal" || type == "conductor")
        material = conductorOf(p, type == "conductor");
    else if (type == "mirror")
        material = Mirror{factorOf(s, p, "Kr", Mirror{}.reflectance)};
    else if (type == "plastic")
        material = plasticOf(s, p);
    else
        material = matteOf(s, p);
    p.finish();
    return material;
}

}  // namespace

void material(Statement s) {
    auto [name, p] = readNamed(s, "material", kMaterials);
    s.state.attributes.material = materialOf(s, name.text, p);
}

void makeNamedMaterial(Statement s) {
    auto [name, p] = readNamed(s, "name of a material", {});
    if (s.state.materials.contains(name.text)) failAt(name.where, "material {} is defined twice", described(name));
    std::optional<std::string> type = p.choice("type", kMaterials);
    if (!type)
        failAt(s.word.where, "MakeNamedMaterial {} lacks \"string type\"; supported: {}", described(name),
               listed(kMaterials));
    s.state.materials.emplace(name.text, materialOf(s, *type, p));
}

void namedMaterial(Statement s) {
    Token name = s.source.lexer.takeString("a material's name");
    auto found = s.state.materials.find(name.text);
    if (found == s.state.materials.end()) failAt(name.where, "undefined material {}", described(name));
    s.state.attributes.material = found->second;
}

}  // namespace dsphere
