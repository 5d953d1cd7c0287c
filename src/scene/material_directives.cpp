#include "scene/directives.h"
#include "scene/ramps.h"

namespace dsphere {

namespace {

const Words kMaterials = {"matte", "diffuse"};

Texture reflectanceValue(Statement s, const Parameter& parameter) {
    if (parameter.type == "rgb") return ConstantColour{tripleValue(parameter, kFraction)};
    const Token& name = stringValue(parameter);
    auto found = s.state.textures.find(name.text);
    if (found == s.state.textures.end()) failAt(name.where, "undefined texture {}", described(name));
    return found->second;
}

// v3 says Kd, v4 reflectance; either spelling of the material takes either.
Matte matteOf(Statement s, Parameters& p) {
    Matte matte;
    const Parameter* kd = p.take("Kd", {"rgb", "texture"});
    const Parameter* reflectance = p.take("reflectance", {"rgb", "texture"});
    if (kd && reflectance) failAt(reflectance->where, "Kd and reflectance mean the same: give one");
    if (kd) matte.reflectance = reflectanceValue(s, *kd);
    if (reflectance) matte.reflectance = reflectanceValue(s, *reflectance);
    p.number("sigma", {0.0, 0.0});  // a rough (Oren-Nayar) surface is not supported
    p.finish();
    return matte;
}

}  // namespace

void material(Statement s) {
    auto [name, p] = readNamed(s, "material", kMaterials);
    s.state.attributes.material = matteOf(s, p);
}

void makeNamedMaterial(Statement s) {
    auto [name, p] = readNamed(s, "name of a material", {});
    if (s.state.materials.contains(name.text)) failAt(name.where, "material {} is defined twice", described(name));
    if (!p.choice("type", kMaterials))
        failAt(s.word.where, "MakeNamedMaterial {} lacks \"string type\"; supported: {}", described(name),
               listed(kMaterials));
    s.state.materials.emplace(name.text, matteOf(s, p));
}

void namedMaterial(Statement s) {
    Token name = s.source.lexer.takeString("a material's name");
    auto found = s.state.materials.find(name.text);
    if (found == s.state.materials.end()) failAt(name.where, "undefined material {}", described(name));
    s.state.attributes.material = found->second;
}

namespace {

HeightRamp heightRamp(Parameters& p) {
    Words names;
    for (const Ramp& ramp : ramps()) names.push_back(ramp.name);
    return {p.choice("ramp", names).value_or("terrain")};
}

ImageMap imageMap(Statement s, Parameters& p) {
    std::optional<Token> filename = p.string("filename");
    std::optional<double> scale = p.number("scale", kNotNegative);
    p.choice("wrap", {"repeat"});
    p.finish();
    if (!filename) failAt(s.word.where, "Texture \"imagemap\" lacks \"string filename\"");
    if (filename->text.empty()) failAt(filename->where, "the image's name is empty");
    return {s.source.resolve(filename->text), dvec3(scale.value_or(1.0)), filename->where};
}

}  // namespace

void texture(Statement s) {
    Token name = s.source.lexer.takeString("a texture's name");
    if (s.state.textures.contains(name.text)) failAt(name.where, "texture {} is defined twice", described(name));
    requireOneOf(s.source.lexer.takeString("a texture's type"), "texture type", {"color", "spectrum"});
    auto [kind, p] = readNamed(s, "texture", {"constant", "heightramp", "imagemap"});
    Texture texture = ConstantColour{dvec3(1.0)};
    if (kind.text == "constant") {
        if (auto value = p.rgb("value", kFraction)) texture = ConstantColour{*value};
    } else if (kind.text == "heightramp") {
        texture = heightRamp(p);
    } else {
        texture = imageMap(s, p);
    }
    p.finish();
    s.state.textures.emplace(name.text, texture);
}

}  // namespace dsphere
