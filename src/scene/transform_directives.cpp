#include "scene/directives.h"
#include "scene/transforms.h"

namespace dsphere {

namespace {

// A directive that stands where the number should is left for the parser to go on with.
double takeNumber(Lexer& input) {
    if (input.peek().is(Token::Kind::Malformed)) input.next();
    const double number = numberOf(input.peek());
    input.next();
    return number;
}

dvec3 readTriple(Lexer& input) {
    dvec3 triple;
    for (int i = 0; i < 3; ++i) triple[i] = takeNumber(input);
    return triple;
}

// As in pbrt, the camera takes the transform that stands when it is met.
void warnAfterCamera(Statement s) {
    ParseState& state = s.state;
    const auto camera = state.given.find("Camera");
    if (state.part == Part::Options && camera != state.given.end() && !state.transformed)
        state.report.warn(s.word.where,
                          fmt::format("{} stands after Camera (at {}) and does not move it: the camera looks from the "
                                      "origin along +z",
                                      s.word.text, camera->second.text()));
    state.transformed = true;
}

void setTransform(Statement s, const dmat4& ctm) {
    if (!isFinite(ctm)) failAt(s.word.where, "{} overflows the current transform", s.word.text);
    s.state.attributes.ctm = ctm;
    warnAfterCamera(s);
}

// pbrt's order: the transform written last is applied to points first.
void multiply(Statement s, const dmat4& m) {
    setTransform(s, s.state.attributes.ctm * m);
}

void requireBracket(Lexer& input, Token::Kind kind, std::string_view bracket) {
    if (!input.peek().is(kind) && !input.peek().is(Token::Kind::Malformed))
        failAt(input.peek().where, "expected {}: a matrix is 16 numbers in [ ], found {}", bracket,
               described(input.peek()));
    input.next();
}

// 16 numbers, column by column: the translation is numbers 13 to 15.
dmat4 readMatrix(Statement s) {
    Lexer& input = s.source.lexer;
    requireBracket(input, Token::Kind::Open, "'['");
    dmat4 m;
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = takeNumber(input);
    requireBracket(input, Token::Kind::Close, "']'");
    if (m[0][3] != 0.0 || m[1][3] != 0.0 || m[2][3] != 0.0 || m[3][3] != 1.0)
        failAt(s.word.where, "{} is not affine; supported: numbers 4, 8 and 12 are 0 and number 16 is 1", s.word.text);
    return m;
}

}  // namespace

void lookAt(Statement s) {
    dvec3 eye = readTriple(s.source.lexer), look = readTriple(s.source.lexer), up = readTriple(s.source.lexer);
    std::optional<dmat4> m = lookAtMatrix(eye, look, up);
    if (!m) failAt(s.word.where, "degenerate LookAt: eye and look coincide, or up is parallel to the view");
    multiply(s, *m);
}

void translate(Statement s) {
    dmat4 m(1.0);
    m[3] = dvec4(readTriple(s.source.lexer), 1.0);
    multiply(s, m);
}

void scale(Statement s) {
    dvec3 factors = readTriple(s.source.lexer);
    dmat4 m(1.0);
    for (int i = 0; i < 3; ++i) m[i][i] = factors[i];
    multiply(s, m);
}

void rotate(Statement s) {
    double degrees = takeNumber(s.source.lexer);
    std::optional<dvec3> axis = unitVector(readTriple(s.source.lexer));
    if (!axis) failAt(s.word.where, "the axis of Rotate is 0 0 0");
    multiply(s, rotationMatrix(degrees, *axis));
}

void identity(Statement s) {
    setTransform(s, dmat4(1.0));
}

void transform(Statement s) {
    setTransform(s, readMatrix(s));
}

void concatTransform(Statement s) {
    multiply(s, readMatrix(s));
}

void coordinateSystem(Statement s) {
    const Token name = s.source.lexer.takeString("a coordinate system's name");
    requireRoomForName(s);
    s.state.coordinate_systems[name.text] = s.state.attributes.ctm;
}

void coordSysTransform(Statement s) {
    const Token name = s.source.lexer.takeString("a coordinate system's name");
    const auto found = s.state.coordinate_systems.find(name.text);
    if (found == s.state.coordinate_systems.end()) {
        if (s.state.recovery.file_missing) throw AlreadyReported{};
        failAt(name.where, "undefined coordinate system {}", described(name));
    }
    setTransform(s, found->second);
}

void activeTransform(Statement s) {
    const Token which = s.source.lexer.next();
    if (which.text == "StartTime" || which.text == "EndTime")
        failAt(s.word.where, "ActiveTransform {}: motion is not supported; supported: All", which.text);
    requireOneOf(which, "time of ActiveTransform", {"All"});
    s.state.report.note(s.word.where, "ActiveTransform", "changes nothing here: nothing moves");
}

void transformTimes(Statement s) {
    takeNumber(s.source.lexer);
    takeNumber(s.source.lexer);
    s.state.report.note(s.word.where, "TransformTimes", "changes nothing here: nothing moves");
}

}  // namespace dsphere
