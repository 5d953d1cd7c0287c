#include "base/overloads.h"
#include "scene/directives.h"
#include "scene/ramps.h"

namespace dsphere {

namespace {

constexpr Range kChecks{-65536.0, 65536.0};
constexpr Range kScale{0.0, 1e6};  // a factor of a texture

const Texture& textureNamed(Statement s, const Parameter& parameter) {
    const Token& name = stringValue(parameter);
    auto found = s.state.textures.find(name.text);
    if (found == s.state.textures.end()) {
        static const Texture unknown = ConstantColour{};
        if (s.state.recovery.file_missing) return unknown;
        failAt(name.where, "undefined texture {}", described(name));
    }
    return found->second;
}

dvec3 cut(const dvec3& colour) {
    return glm::min(colour, dvec3(1.0));
}

HeightRamp heightRamp(Parameters& p) {
    Words names;
    for (const Ramp& ramp : ramps()) names.push_back(ramp.name);
    return {.ramp = p.choice("ramp", names).value_or("terrain")};
}

// What pbrt's (u, v) mapping may say without moving the texture.
void ignoreMapping(Parameters& p) {
    p.ignoreWord("mapping", {"uv"});
    for (const char* delta : {"udelta", "vdelta"}) p.ignoreWithin(delta, {0.0, 0.0}, "0");
}

ImageMap imageMap(Statement s, Parameters& p) {
    std::optional<Token> filename = p.string("filename");
    std::optional<double> scale = p.number("scale", kNotNegative);
    std::optional<double> longitude_origin = p.number("lonorigin", kLongitudeOrigin);
    p.choice("wrap", {"repeat"});
    ignoreMapping(p);
    for (const char* factor : {"uscale", "vscale"}) p.ignoreWithin(factor, {1.0, 1.0}, "1");
    // The samples of a pixel smooth the image.
    p.ignore("trilinear", {"bool"});
    p.ignore("maxanisotropy", {"float"});
    p.ignoreWord("filter", {"bilinear", "trilinear", "ewa", "EWA"});
    p.ignoreFlag("gamma", true, "since integers are decoded from sRGB");
    p.ignoreWord("encoding", {"sRGB"});
    p.ignoreFlag("invert", false, "since colours are taken as they are");
    p.finish();
    if (!filename) failAt(s.word.where, "Texture \"imagemap\" lacks \"string filename\"");
    if (filename->text.empty()) failAt(filename->where, "the image's name is empty");
    return {resolvePath(s, filename->text), dvec3(scale.value_or(1.0)), longitude_origin.value_or(-180.0),
            filename->where};
}

Checkerboard checkerboard(Statement s, Parameters& p) {
    Checkerboard board;
    const Words types = {"rgb", "float", "texture"};
    const auto colour = [&](const Parameter& given) { return constantValue(s, given, kFraction); };
    board.even = p.valueOr("tex1", types, board.even, colour);
    board.odd = p.valueOr("tex2", types, board.odd, colour);
    board.u_scale = p.number("uscale", kChecks).value_or(board.u_scale);
    board.v_scale = p.number("vscale", kChecks).value_or(board.v_scale);
    ignoreMapping(p);
    p.ignoreWithin("dimension", {2.0, 2.0}, "2");
    p.ignore("aamode", {"string"});
    return board;
}

struct Multiply {
    dvec3 factor;

    void operator()(ConstantColour& constant) const { constant.rgb *= factor; }
    void operator()(HeightRamp& ramp) const { ramp.scale *= factor; }
    void operator()(ImageMap& image) const { image.scale *= factor; }
    void operator()(Checkerboard& board) const { board.even *= factor, board.odd *= factor; }
};

// The product of the two, of which one must be constant.
Texture product(Statement s, const Parameter* one, const Parameter* other) {
    auto read = [&](const Parameter* parameter) -> Texture {
        if (!parameter) return ConstantColour{dvec3(1.0)};
        if (parameter->type == "texture") return textureNamed(s, *parameter);
        return ConstantColour{constantValue(s, *parameter, kScale)};
    };
    Texture varying = read(one), factor = read(other);
    if (!std::holds_alternative<ConstantColour>(factor)) std::swap(varying, factor);
    const auto* constant = std::get_if<ConstantColour>(&factor);
    if (!constant) failAt(s.word.where, "{} and {} both vary; supported: one of them constant", one->name, other->name);
    std::visit(Multiply{constant->rgb}, varying);
    return varying;
}

// v3 multiplies tex1 by tex2, v4 tex by scale.
Texture scaled(Statement s, Parameters& p) {
    const Words types = {"rgb", "float", "texture"};
    const Parameter *tex1 = p.take("tex1", types), *tex2 = p.take("tex2", types);
    const Parameter *tex = p.take("tex", types), *scale = p.take("scale", types);
    p.finish();
    const Parameter *v3 = tex1 ? tex1 : tex2, *v4 = tex ? tex : scale;
    if (v3 && v4)
        failAt(v4->where, "{} is pbrt v4's, and {} (at {}) is pbrt v3's: give one spelling", v4->name, v3->name,
               v3->where.text());
    return v4 ? product(s, tex, scale) : product(s, tex1, tex2);
}

}  // namespace

Texture textureValue(Statement s, const Parameter& parameter) {
    if (parameter.type == "rgb") return ConstantColour{tripleValue(parameter, kFraction)};
    Texture texture = textureNamed(s, parameter);
    // Those that vary by a map are cut where they are read.
    std::visit(Overloads{[](ConstantColour& constant) { constant.rgb = cut(constant.rgb); }, [](HeightRamp&) {},
                         [](ImageMap&) {},
                         [](Checkerboard& board) { board.even = cut(board.even), board.odd = cut(board.odd); }},
               texture);
    return texture;
}

dvec3 constantValue(Statement s, const Parameter& parameter, const Range& range) {
    if (parameter.type == "rgb") return tripleValue(parameter, range);
    if (parameter.type == "float") return dvec3(numberValue(parameter, range));
    Texture texture = textureValue(s, parameter);
    if (const auto* constant = std::get_if<ConstantColour>(&texture)) return constant->rgb;
    failAt(stringValue(parameter).where, "texture {} varies, and {} must not; supported: constant, or scale of such",
           described(stringValue(parameter)), parameter.name);
}

namespace {

Texture readTexture(Statement s) {
    requireOneOf(s.source.lexer.takeString("a texture's type"), "texture type", {"color", "spectrum"});
    auto [kind, p] = readNamed(s, "texture", {"constant", "heightramp", "imagemap", "checkerboard", "scale"},
                               s.state.attributes.defaults.texture);
    Texture texture = ConstantColour{dvec3(1.0)};
    if (kind.text == "constant") {
        if (auto value = p.rgb("value", kFraction)) texture = ConstantColour{*value};
    } else if (kind.text == "heightramp") {
        texture = heightRamp(p);
    } else if (kind.text == "imagemap") {
        texture = imageMap(s, p);
    } else if (kind.text == "checkerboard") {
        texture = checkerboard(s, p);
    } else {
        texture = scaled(s, p);
    }
    p.finish();
    return texture;
}

}  // namespace

void texture(Statement s) {
    Token name = s.source.lexer.takeString("a texture's name");
    if (s.state.textures.contains(name.text)) failAt(name.where, "texture {} is defined twice", described(name));
    requireRoomForName(s);
    try {
        s.state.textures.emplace(name.text, readTexture(s));
    } catch (...) {
        s.state.textures.emplace(name.text, ConstantColour{});  // its use is no error too
        throw;
    }
}

}  // namespace dsphere
