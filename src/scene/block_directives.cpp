#include "base/limits.h"
#include "scene/directives.h"

namespace dsphere {

namespace {

void open(Statement s) {
    ParseState& state = s.state;
    if (state.blocks.size() == limits::kBlockDepth)
        stopAt(state.report, s.word.where, "more than {} blocks are open", limits::kBlockDepth);
    state.blocks.push_back(
        {s.word.text == "AttributeBegin" ? "AttributeBegin" : "TransformBegin", state.attributes, s.word.where});
}

Attributes close(Statement s, std::string_view opened_by) {
    ParseState& state = s.state;
    if (state.blocks.empty()) {
        // What the beginning of an unsound block left open is known no more.
        if (state.recovery.blocks_unsound || state.recovery.file_missing) throw AlreadyReported{};
        failAt(s.word.where, "{} without {}", s.word.text, opened_by);
    }
    OpenBlock block = std::move(state.blocks.back());
    state.blocks.pop_back();
    if (block.opened_by != opened_by) {
        const bool known = state.recovery.blocks_unsound || state.recovery.file_missing;
        state.recovery.blocks_unsound = true;
        if (known) throw AlreadyReported{};
        failAt(s.word.where, "{} inside the {} of {}", s.word.text, block.opened_by, block.where.text());
    }
    return std::move(block.saved);
}

}  // namespace

void requireNoOpenBlock(const ParseState& state, std::string_view before) {
    if (state.blocks.empty()) return;
    const OpenBlock& block = state.blocks.back();
    failAt(block.where, "{} is not closed before {}", block.opened_by, before);
}

void worldBegin(Statement s) {
    s.state.part = Part::World;
    s.state.recovery.world_assumed = false;
    s.state.attributes.ctm = dmat4(1.0);
    s.state.coordinate_systems["world"] = dmat4(1.0);
}

void worldEnd(Statement s) {
    s.state.part = Part::Ended;
    if (s.state.recovery.blocks_unsound || s.state.recovery.file_missing) return;
    s.state.recovery.blocks_unsound = !s.state.blocks.empty();
    requireNoOpenBlock(s.state, "WorldEnd");
}

void attributeBegin(Statement s) {
    open(s);
}

void attributeEnd(Statement s) {
    s.state.attributes = close(s, "AttributeBegin");
}

void transformBegin(Statement s) {
    open(s);
}

void transformEnd(Statement s) {
    s.state.attributes.ctm = close(s, "TransformBegin").ctm;
}

void attribute(Statement s) {
    const Token target = s.source.lexer.takeString("the target of Attribute");
    requireOneOf(target, "target", {"shape", "light", "material", "medium", "texture"});
    Parameters given(s.source.lexer, fmt::format("Attribute {}", described(target)), s.state.report);
    given.requireSound();
    if (target.text == "medium") return;  // there are none that could take them
    Defaults& defaults = s.state.attributes.defaults;
    Defaults::List& list = target.text == "shape"      ? defaults.shape
                           : target.text == "light"    ? defaults.light
                           : target.text == "material" ? defaults.material
                                                       : defaults.texture;
    std::vector<Parameter> all = list ? *list : std::vector<Parameter>();
    for (Parameter& parameter : given.release()) {
        std::erase_if(all, [&](const Parameter& earlier) { return earlier.name == parameter.name; });
        all.push_back(std::move(parameter));
    }
    std::size_t values = 0;
    for (const Parameter& parameter : all) values += parameter.values.size();
    if (all.size() > limits::kDefaults || values > limits::kDefaultValues)
        failAt(s.word.where, "Attribute {} gives {} parameters of {} values; supported: at most {} of {}",
               described(target), all.size(), values, limits::kDefaults, limits::kDefaultValues);
    list = std::make_shared<const std::vector<Parameter>>(std::move(all));
}

// The materials are two-sided, so that it shows in what shines alone.
void reverseOrientation(Statement s) {
    s.state.attributes.reversed = !s.state.attributes.reversed;
    s.state.report.note(s.word.where, "ReverseOrientation", "changes nothing here: materials are two-sided");
}

}  // namespace dsphere
