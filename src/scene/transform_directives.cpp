#include "scene/directives.h"
#include "scene/transforms.h"

#include <array>

namespace dsphere {

namespace {

dvec3 readTriple(Lexer& input) {
    dvec3 triple;
    for (int i = 0; i < 3; ++i) triple[i] = numberOf(input.next());
    return triple;
}

void setTransform(Statement s, const dmat4& ctm) {
    if (!isFinite(ctm)) failAt(s.word.where, "{} overflows the current transform", s.word.text);
    s.state.attributes.ctm = ctm;
}

// pbrt's order: the transform written last is applied to points first.
void multiply(Statement s, const dmat4& m) {
    setTransform(s, s.state.attributes.ctm * m);
}

void requireBracket(Lexer& input, Token::Kind kind, std::string_view bracket) {
    Token token = input.next();
    if (!token.is(kind))
        failAt(token.where, "expected {}: a matrix is 16 numbers in [ ], found {}", bracket, described(token));
}

// 16 numbers, column by column: the translation is numbers 13 to 15.
dmat4 readMatrix(Statement s) {
    Lexer& input = s.source.lexer;
    requireBracket(input, Token::Kind::Open, "'['");
    dmat4 m;
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = numberOf(input.next());
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
    double degrees = numberOf(s.source.lexer.next());
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

}  // namespace dsphere
