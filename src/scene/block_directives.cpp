#include "scene/directives.h"

namespace dsphere {

namespace {

void open(Statement s) {
    s.state.blocks.push_back(
        {s.word.text == "AttributeBegin" ? "AttributeBegin" : "TransformBegin", s.state.attributes, s.word.where});
}

Attributes close(Statement s, std::string_view opened_by) {
    if (s.state.blocks.empty()) failAt(s.word.where, "{} without {}", s.word.text, opened_by);
    OpenBlock block = std::move(s.state.blocks.back());
    if (block.opened_by != opened_by)
        failAt(s.word.where, "{} inside the {} of {}", s.word.text, block.opened_by, block.where.text());
    s.state.blocks.pop_back();
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
    s.state.attributes.ctm = dmat4(1.0);
}

void worldEnd(Statement s) {
    requireNoOpenBlock(s.state, "WorldEnd");
    s.state.part = Part::Ended;
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

}  // namespace dsphere
