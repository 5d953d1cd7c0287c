#include "scene/lexer.h"

#include "scene/diagnostics.h"

#include <charconv>
#include <cmath>

namespace dsphere {

namespace {

bool isSpace(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

bool isControl(char c) {
    auto code = static_cast<unsigned char>(c);
    return code < 0x20 || code == 0x7f;
}

bool endsWord(char c) {
    return isSpace(c) || c == '"' || c == '[' || c == ']' || c == '#';
}

void refuseControl(char c, const SourceLocation& where) {
    if (isControl(c)) failAt(where, "control character 0x{:02x}; a scene is plain text", static_cast<unsigned char>(c));
}

// from_chars knows no leading plus, which pbrt's files may have.
std::string_view withoutPlus(std::string_view text) {
    bool signed_twice = text.size() > 1 && text[1] == '-';
    return !text.empty() && text[0] == '+' && !signed_twice ? text.substr(1) : text;
}

}  // namespace

Lexer::Lexer(std::string_view text, std::string file) : text_(text) {
    here_.file = std::move(file);
    ahead_ = scan();
}

Token Lexer::next() {
    Token token = ahead_;
    if (!token.is(Token::Kind::End)) ahead_ = scan();
    return token;
}

Token Lexer::takeString(std::string_view what) {
    if (!ahead_.is(Token::Kind::String))
        failAt(ahead_.where, "expected {} in double quotes, found {}", what, described(ahead_));
    return next();
}

void Lexer::advance() {
    bool new_line = current() == '\n';
    here_.line += new_line;
    here_.column = new_line ? 1 : here_.column + 1;
    ++position_;
}

void Lexer::skipSpace() {
    bool comment = false;
    for (; !atEnd(); advance()) {
        if (current() == '#') comment = true;
        if (current() == '\n') comment = false;
        if (!comment && !isSpace(current())) return;
    }
}

Token Lexer::scan() {
    skipSpace();
    Token token{Token::Kind::End, "", here_};
    if (atEnd()) return token;
    if (current() == '"') return scanString(std::move(token));
    if (current() != '[' && current() != ']') return scanWord(std::move(token));
    token.kind = current() == '[' ? Token::Kind::Open : Token::Kind::Close;
    token.text = current();
    advance();
    return token;
}

Token Lexer::scanString(Token token) {
    token.kind = Token::Kind::String;
    for (advance(); !atEnd() && current() != '\n' && current() != '"'; advance()) {
        refuseControl(current(), here_);
        if (current() == '\\') {
            advance();
            if (atEnd() || (current() != '"' && current() != '\\'))
                failAt(here_, "unknown escape in a string; supported: \\\" and \\\\");
        }
        token.text += current();
    }
    if (atEnd() || current() != '"') failAt(token.where, "unterminated string: a string ends on the line it begins on");
    advance();
    return token;
}

Token Lexer::scanWord(Token token) {
    token.kind = Token::Kind::Word;
    for (; !atEnd() && !endsWord(current()); advance()) {
        refuseControl(current(), here_);
        token.text += current();
    }
    return token;
}

double numberOf(const Token& token) {
    std::string_view text = withoutPlus(token.text);
    double value = 0.0;
    auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    bool whole = token.is(Token::Kind::Word) && end == text.data() + text.size();
    if (!whole || error == std::errc::invalid_argument)
        failAt(token.where, "expected a number, found {}", described(token));
    if (error != std::errc() || !std::isfinite(value))
        failAt(token.where, "{} is not a finite number of double precision", described(token));
    return value;
}

bool isNan(const Token& token) {
    const std::string& text = token.text;
    auto is = [&](std::size_t i, char lower) { return text[i] == lower || text[i] == lower - 'a' + 'A'; };
    return token.is(Token::Kind::Word) && text.size() == 3 && is(0, 'n') && is(1, 'a') && is(2, 'n');
}

int integerOf(const Token& token) {
    std::string_view text = withoutPlus(token.text);
    int value = 0;
    auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    bool whole = token.is(Token::Kind::Word) && end == text.data() + text.size();
    if (!whole || error == std::errc::invalid_argument)
        failAt(token.where, "expected an integer, found {}", described(token));
    if (error != std::errc()) failAt(token.where, "{} does not fit an integer of 32 bits", described(token));
    return value;
}

}  // namespace dsphere
