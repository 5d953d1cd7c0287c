#include "scene/directives.h"
#include "scene/metals.h"

#include <algorithm>
#include <cmath>

namespace dsphere {

namespace {

constexpr Range kDegrees{0.0, 90.0};
constexpr Range kIndex{0.0, 1000.0};  // of refraction
constexpr double kLeastAlpha = 0.001;

Texture colourOf(Statement s, Parameters& p, std::string_view name, const Texture& otherwise) {
    return p.valueOr(name, {"rgb", "texture"}, otherwise, [&](const Parameter& c) { return textureValue(s, c); });
}

// v3 says Kd, v4 reflectance; either spelling of the material takes either.
Matte matteOf(Statement s, Parameters& p) {
    Matte matte;
    const auto kd = p.placeOf("Kd"), reflectance = p.placeOf("reflectance");
    if (kd && reflectance) p.attempt([&] { failAt(*reflectance, "Kd and reflectance mean the same: give one"); });
    for (const char* name : {"Kd", "reflectance"}) matte.reflectance = colourOf(s, p, name, matte.reflectance);
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
    const bool remap = p.boolean("remaproughness").value_or(true);
    p.attempt([&] {
        std::optional<SourceLocation> where = p.placeOf("uroughness");
        if (!where) where = p.placeOf("vroughness");
        if (where && u != v && p.isSound())
            failAt(*where, "uroughness {} is not vroughness {}; supported: the same roughness in all directions", u, v);
    });
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
    const Words types = {"rgb", "spectrum"};
    metal.eta = p.valueOr("eta", types, metal.eta, [](const Parameter& eta) {
        return eta.type == "rgb" ? tripleValue(eta, kIndex) : metalNamed(eta).eta;
    });
    metal.k = p.valueOr("k", types, metal.k,
                        [](const Parameter& k) { return k.type == "rgb" ? tripleValue(k, kIndex) : metalNamed(k).k; });
    metal.alpha = alphaOf(p, 0.01, v4);
    return metal;
}

dvec3 factorOf(Statement s, Parameters& p, std::string_view name, const dvec3& otherwise) {
    return p.valueOr(name, {"rgb", "texture"}, otherwise,
                     [&](const Parameter& factor) { return constantValue(s, factor, kFraction); });
}

Plastic plasticOf(Statement s, Parameters& p) {
    Plastic plastic;
    plastic.diffuse = colourOf(s, p, "Kd", plastic.diffuse);
    plastic.specular = factorOf(s, p, "Ks", plastic.specular);
    plastic.alpha = alphaOf(p, 0.1, false);
    return plastic;
}

/// What the scene language calls a material, and who reads its parameters.
struct MaterialWord {
    std::string_view word;
    Material (*read)(Statement, Parameters&);
};

constexpr MaterialWord kMaterialWords[] = {
    {"matte", [](Statement s, Parameters& p) -> Material { return matteOf(s, p); }},
    {"diffuse", [](Statement s, Parameters& p) -> Material { return matteOf(s, p); }},
    {"metal", [](Statement, Parameters& p) -> Material { return conductorOf(p, false); }},
    {"conductor", [](Statement, Parameters& p) -> Material { return conductorOf(p, true); }},
    {"mirror",
     [](Statement s, Parameters& p) -> Material { return Mirror{factorOf(s, p, "Kr", Mirror{}.reflectance)}; }},
    {"plastic", [](Statement s, Parameters& p) -> Material { return plasticOf(s, p); }},
};

Words materialWords() {
    Words words;
    for (const MaterialWord& material : kMaterialWords) words.push_back(material.word);
    return words;
}

const Words kMaterials = materialWords();

/// `type` is one of kMaterials.
Material materialOf(Statement s, std::string_view type, Parameters& p) {
    Material material = std::ranges::find(kMaterialWords, type, &MaterialWord::word)->read(s, p);
    p.finish();
    return material;
}

}  // namespace

void material(Statement s) {
    auto [name, p] = readNamed(s, "material", kMaterials, s.state.attributes.defaults.material);
    s.state.attributes.material = materialOf(s, name.text, p);
}

namespace {

Material readNamedMaterial(Statement s, const Token& name) {
    Parameters p(s.source.lexer, fmt::format("{} {}", s.word.text, described(name)), s.state.report);
    if (const Defaults::List& defaults = s.state.attributes.defaults.material) p.complete(*defaults);
    std::optional<std::string> type = p.choice("type", kMaterials);
    p.requireSound();
    if (!type)
        failAt(s.word.where, "MakeNamedMaterial {} lacks \"string type\"; supported: {}", described(name),
               listed(kMaterials));
    return materialOf(s, *type, p);
}

}  // namespace

void makeNamedMaterial(Statement s) {
    const Token name = s.source.lexer.takeString("the name of a material");
    if (s.state.materials.contains(name.text)) failAt(name.where, "material {} is defined twice", described(name));
    requireRoomForName(s);
    try {
        s.state.materials.emplace(name.text, readNamedMaterial(s, name));
    } catch (...) {
        s.state.materials.emplace(name.text, Material{});  // its use is no error too
        throw;
    }
}

void namedMaterial(Statement s) {
    Token name = s.source.lexer.takeString("a material's name");
    auto found = s.state.materials.find(name.text);
    if (found == s.state.materials.end()) {
        if (s.state.recovery.file_missing) throw AlreadyReported{};
        failAt(name.where, "undefined material {}", described(name));
    }
    s.state.attributes.material = found->second;
}

}  // namespace dsphere
