#include "scene/parser.h"

#include "scene/directives.h"

#include <fstream>
#include <iostream>
#include <iterator>

namespace dsphere {

namespace {

constexpr int kMaxIncludeDepth = 16;
constexpr int kMaxIncludes = 4096;                        // files that include files may otherwise multiply without end
constexpr std::size_t kMaxBytes = std::size_t(64) << 20;  // of one scene file
constexpr const char* kStandardInput = "-";

void include(Statement s);

enum class Place { Anywhere, BeforeWorld, InWorld };

struct Directive {
    std::string_view word;
    Place place;
    void (*run)(Statement);
};

constexpr Directive kDirectives[] = {
    {"Include", Place::Anywhere, include},
    {"LookAt", Place::Anywhere, lookAt},
    {"Translate", Place::Anywhere, translate},
    {"Scale", Place::Anywhere, scale},
    {"Rotate", Place::Anywhere, rotate},
    {"Identity", Place::Anywhere, identity},
    {"Transform", Place::Anywhere, transform},
    {"ConcatTransform", Place::Anywhere, concatTransform},
    {"Camera", Place::BeforeWorld, camera},
    {"Film", Place::BeforeWorld, film},
    {"Sampler", Place::BeforeWorld, sampler},
    {"Integrator", Place::BeforeWorld, integrator},
    {"PixelFilter", Place::BeforeWorld, pixelFilter},
    {"WorldBegin", Place::BeforeWorld, worldBegin},
    {"WorldEnd", Place::InWorld, worldEnd},
    {"AttributeBegin", Place::InWorld, attributeBegin},
    {"AttributeEnd", Place::InWorld, attributeEnd},
    {"TransformBegin", Place::InWorld, transformBegin},
    {"TransformEnd", Place::InWorld, transformEnd},
    {"Material", Place::InWorld, material},
    {"MakeNamedMaterial", Place::InWorld, makeNamedMaterial},
    {"NamedMaterial", Place::InWorld, namedMaterial},
    {"Texture", Place::InWorld, texture},
    {"LightSource", Place::InWorld, lightSource},
    {"AreaLightSource", Place::InWorld, areaLightSource},
    {"Shape", Place::InWorld, shape},
};

const Directive& findDirective(const Token& token) {
    if (!token.is(Token::Kind::Word)) failAt(token.where, "expected a directive, found {}", described(token));
    Words words;
    for (const Directive& directive : kDirectives) {
        if (directive.word == token.text) return directive;
        words.push_back(directive.word);
    }
    failAt(token.where, "unknown directive {}; supported: {}", described(token), listed(words));
}

void requirePlace(const Directive& directive, const Token& word, Part part) {
    if (part == Part::Ended) failAt(word.where, "{} stands after WorldEnd; supported: comments", word.text);
    if (directive.place == Place::BeforeWorld && part == Part::World)
        failAt(word.where, "{} stands after WorldBegin; supported: before it", word.text);
    if (directive.place == Place::InWorld && part == Part::Options)
        failAt(word.where, "{} stands before WorldBegin; supported: after it", word.text);
}

/// Runs all directives of a file; returns the token that ends it.
Token parseAll(ParseState& state, Source& source) {
    for (;;) {
        Token word = source.lexer.next();
        if (word.is(Token::Kind::End)) return word;
        const Directive& directive = findDirective(word);
        requirePlace(directive, word, state.part);
        directive.run({state, source, word});
    }
}

std::string readAll(std::istream& input, const std::string& message_start) {
    std::string text;
    char block[65536];
    while (input.read(block, sizeof block) || input.gcount() > 0) {
        text.append(block, std::size_t(input.gcount()));
        if (text.size() > kMaxBytes) throwInvalid("{}: a scene file holds at most {} bytes", message_start, kMaxBytes);
    }
    if (input.bad()) throwInvalid("{}: cannot read: {}", message_start, lastSystemError());
    return text;
}

/// `message_start` begins the error: the file's name, or the place that includes it.
std::string readFile(const std::filesystem::path& path, const std::string& message_start) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        throwInvalid("{}: {} is a directory, not a scene file", message_start, path.string());
    std::ifstream input(path, std::ios::binary);
    if (!input) throwInvalid("{}: cannot open {}: {}", message_start, path.string(), lastSystemError());
    return readAll(input, message_start);
}

void include(Statement s) {
    Token name = s.source.lexer.takeString("a file's name");
    if (s.source.depth == kMaxIncludeDepth)
        failAt(s.word.where, "Include {} nests deeper than {} files", described(name), kMaxIncludeDepth);
    if (++s.state.includes > kMaxIncludes) failAt(s.word.where, "more than {} Includes in a scene", kMaxIncludes);
    std::filesystem::path path = s.source.resolve(name.text);
    std::string text = readFile(path, name.where.text());
    s.state.scene.included.push_back(path.string());
    Source source{Lexer(text, path.string()), path.parent_path(), s.source.depth + 1};
    parseAll(s.state, source);
}

}  // namespace

NamedParameters readNamed(Statement s, std::string_view what, const Words& supported) {
    Token name = s.source.lexer.takeString(fmt::format("the {}", what));
    if (!supported.empty()) requireOneOf(name, what, supported);
    std::string owner = fmt::format("{} {}", s.word.text, described(name));
    return {std::move(name), Parameters(s.source.lexer, std::move(owner))};
}

Scene parseScene(std::string_view text, const std::string& name, const std::filesystem::path& folder) {
    ParseState state;
    state.scene.name = name;
    state.scene.integrator.kind = Integrator::Kind::Path;
    Source source{Lexer(text, name), folder};
    Token end = parseAll(state, source);
    if (state.part == Part::Options) failAt(end.where, "the scene has no WorldBegin");
    requireNoOpenBlock(state, "the end of the scene");
    if (state.scene.shapes.empty()) failAt(end.where, "the scene has no shape");
    return std::move(state.scene);
}

Scene parseSceneFile(const std::filesystem::path& path) {
    if (path == kStandardInput) return parseScene(readAll(std::cin, kStandardInput), kStandardInput, {});
    return parseScene(readFile(path, path.string()), path.string(), path.parent_path());
}

}  // namespace dsphere
