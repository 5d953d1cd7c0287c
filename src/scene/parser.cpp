#include "scene/parser.h"

#include "base/limits.h"
#include "scene/textfile.h"
#include "scene/vocabulary.h"

namespace dsphere {

namespace {

constexpr const char* kStandardInput = "-";

// A directive of the world without WorldBegin begins the world, so that those after it are not refused as well.
void requirePlace(ParseState& state, const Directive& directive, const Token& word) {
    Recovery& recovery = state.recovery;
    if (state.part == Part::Ended) failAt(word.where, "{} stands after WorldEnd; supported: comments", word.text);
    if (directive.place == Place::BeforeWorld && state.part == Part::World && !recovery.world_assumed)
        failAt(word.where, "{} stands after WorldBegin; supported: before it", word.text);
    if (directive.place == Place::InWorld && state.part == Part::Options) {
        recovery.world_assumed = recovery.blocks_unsound = true;
        state.part = Part::World;
        state.report.add({word.where, fmt::format("{} stands before WorldBegin; supported: after it", word.text)});
    }
}

void runDirective(ParseState& state, Source& source) {
    source.how_to_get = source.lexer.howToGet();
    const Token word = source.lexer.next();
    if (!word.is(Token::Kind::Word)) failAt(word.where, "expected a directive, found {}", described(word));
    const Directive* directive = findDirective(word.text);
    if (!directive)
        failAt(word.where, "unknown directive {}; supported: {}", described(word), listed(supportedDirectives()));
    requirePlace(state, *directive, word);
    directive->run({state, source, word});
}

// A bare word with a capital is meant as a directive, if not a known one: arguments are numbers, true, false or nan.
bool beginsDirective(const Token& token) {
    return token.is(Token::Kind::Word) && token.text[0] >= 'A' && token.text[0] <= 'Z' && !isNan(token);
}

// What belongs to a directive that failed tells nothing more.
void skipToDirective(Lexer& input) {
    while (!input.peek().is(Token::Kind::End) && !beginsDirective(input.peek())) input.skip();
}

/// Runs all directives of a file, and goes on at the next directive where one fails.
void parseAll(ParseState& state, Source& source) {
    while (!source.lexer.peek().is(Token::Kind::End) && !state.report.isOver()) {
        const bool ended = state.part == Part::Ended;
        bool left = false;
        try {
            runDirective(state, source);
        } catch (const SceneError& error) {
            state.report.add(error);
        } catch (const AlreadyReported&) {
            left = true;
        }
        if (state.report.endDirective() || left) skipToDirective(source.lexer);
        if (ended) return;  // one error tells that nothing may follow WorldEnd
    }
}

std::size_t bytesLeft(const ParseState& state) {
    return limits::kTextBytes - state.bytes;
}

// What the whole text lacks. Beside other mistakes only what they cannot have caused is told.
void requireComplete(ParseState& state, const Token& end) {
    if (state.report.isOver()) return;
    try {
        if (!state.recovery.blocks_unsound && !state.recovery.file_missing)
            requireNoOpenBlock(state, "the end of the scene");
        if (state.report.hasErrors()) return;
        if (state.part == Part::Options) failAt(end.where, "the scene has no WorldBegin");
        if (state.scene.shapes.empty()) failAt(end.where, "the scene has no shape");
    } catch (const SceneError& error) {
        state.report.add(error);
        state.report.endDirective();
    }
}

Scene parseText(ParseState state, std::string_view text, const std::string& name) {
    state.scene.name = name;
    state.scene.integrator.kind = Integrator::Kind::Path;
    state.bytes = text.size();
    Source source{.lexer = Lexer(text, name), .folder = state.folder};
    parseAll(state, source);
    requireComplete(state, source.lexer.peek());
    state.report.throwIfAny();
    state.scene.notices = state.report.notices();
    return std::move(state.scene);
}

/// `name` stands in the message of what readText() throws.
template <typename Read>
std::string readFirst(const std::string& name, Read read) {
    try {
        return read();
    } catch (const Error&) {
        throw;
    } catch (const std::runtime_error& error) {
        throwInvalid("{}: {}", name, error.what());
    }
}

}  // namespace

void include(Statement s) {
    const Token name = s.source.lexer.takeString("a file's name");
    if (s.source.depth == limits::kIncludeDepth)
        failAt(s.word.where, "Include {} nests deeper than {} files", described(name), limits::kIncludeDepth);
    if (++s.state.includes > limits::kIncludes)
        stopAt(s.state.report, s.word.where, "more than {} Includes in a scene", limits::kIncludes);
    const std::filesystem::path path = resolvePath(s, name.text);
    std::string text;
    try {
        text = readText(path, bytesLeft(s.state));
    } catch (const TextTooLong& error) {
        stopAt(s.state.report, name.where, "{}", error.what());
    } catch (const Error&) {
        throw;
    } catch (const std::runtime_error& error) {
        s.state.recovery.file_missing = true;
        const auto missing = s.state.scene.missing.find(path.string());
        failAt(name.where, "{}{}", error.what(), missing == s.state.scene.missing.end() ? "" : missing->second);
    }
    s.state.bytes += text.size();
    s.state.scene.included.push_back(path.string());
    Source source{.lexer = Lexer(text, path.string()), .folder = path.parent_path(), .depth = s.source.depth + 1};
    parseAll(s.state, source);
}

std::string resolvePath(Statement s, const std::string& name) {
    const std::filesystem::path beside = s.source.folder / name, first = s.state.folder / name;
    std::error_code ignored;
    if (std::filesystem::exists(beside, ignored)) return beside.string();
    if (std::filesystem::exists(first, ignored)) return first.string();
    std::string more;
    if (first != beside) more += fmt::format("; sought at {} too", first.string());
    if (!s.source.how_to_get.empty()) more += fmt::format("; to get it: {}", s.source.how_to_get);
    if (!more.empty()) s.state.scene.missing.emplace(beside.string(), more);
    return beside.string();
}

void requireRoomForName(Statement s) {
    const ParseState& state = s.state;
    if (state.materials.size() + state.textures.size() + state.coordinate_systems.size() >= limits::kDefinitions)
        stopAt(s.state.report, s.word.where, "more than {} names of materials, textures and coordinate systems",
               limits::kDefinitions);
}

NamedParameters readNamed(Statement s, std::string_view what, const Words& supported, const Defaults::List& defaults) {
    Token name = s.source.lexer.takeString(fmt::format("the {}", what));
    if (!supported.empty()) requireOneOf(name, what, supported);
    std::string owner = fmt::format("{} {}", s.word.text, described(name));
    Parameters parameters(s.source.lexer, std::move(owner), s.state.report);
    if (defaults) parameters.complete(*defaults);
    return {std::move(name), std::move(parameters)};
}

Scene parseScene(std::string_view text, const std::string& name, const std::filesystem::path& folder) {
    ParseState state;
    state.folder = folder;
    return parseText(std::move(state), text, name);
}

Scene parseSceneFile(const std::filesystem::path& path) {
    const bool standard_input = path == kStandardInput;
    const std::string text = readFirst(path.string(), [&] {
        return standard_input ? readStandardInput(limits::kTextBytes) : readText(path, limits::kTextBytes);
    });
    const bool stream = standard_input || isOpenDescriptor(path);
    return parseScene(text, path.string(), stream ? std::filesystem::path() : path.parent_path());
}

}  // namespace dsphere
