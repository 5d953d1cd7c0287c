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

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";  // UTF-8's, which some editors write first
constexpr std::string_view kGet = "# get:";

/// The first thing that is wrong with a token is what it tells.
void spoil(Token& token, const SourceLocation& where, std::string what) {
    if (token.is(Token::Kind::Malformed)) return;
    token = {Token::Kind::Malformed, std::move(what), where};
}

void append(Token& token, char c, const SourceLocation& where) {
    if (isControl(c))
        spoil(token, where,
              fmt::format("control character 0x{:02x}; a scene is plain text", static_cast<unsigned char>(c)));
    if (!token.is(Token::Kind::Malformed)) token.text += c;
}

// from_chars knows no leading plus, which pbrt's files may have.
std::string_view withoutPlus(std::string_view text) {
    bool signed_twice = text.size() > 1 && text[1] == '-';
    return !text.empty() && text[0] == '+' && !signed_twice ? text.substr(1) : text;
}

}  // namespace

Lexer::Lexer(std::string_view text, std::string file) : text_(text) {
    here_.file = std::move(file);
    if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
    ahead_ = scan();
}

Token Lexer::next() {
    Token token = ahead_;
    if (!token.is(Token::Kind::End)) ahead_ = scan();
    if (token.is(Token::Kind::Malformed)) failAt(token.where, "{}", token.text);
    return token;
}

void Lexer::skip() {
    if (!ahead_.is(Token::Kind::End)) ahead_ = scan();
}

Token Lexer::takeString(std::string_view what) {
    if (ahead_.is(Token::Kind::Malformed)) return next();
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
    while (!atEnd()) {
        if (current() == '#')
            skipComment();
        else if (isSpace(current()))
            advance();
        else
            return;
    }
}

// Up to the end of its line.
void Lexer::skipComment() {
    const std::size_t begin = position_;
    while (!atEnd() && current() != '\n') advance();
    std::string_view comment = text_.substr(begin, position_ - begin);
    if (!comment.starts_with(kGet)) return;
    comment.remove_prefix(kGet.size());
    const std::size_t first = comment.find_first_not_of(" \t"), last = comment.find_last_not_of(" \t\r");
    how_to_get_ = first == std::string_view::npos ? "" : comment.substr(first, last + 1 - first);
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
    const SourceLocation begin = here_;
    for (advance(); !atEnd() && current() != '\n' && current() != '"'; advance()) {
        if (current() == '\\') {
            advance();
            if (atEnd() || (current() != '"' && current() != '\\'))
                spoil(token, here_, "unknown escape in a string; supported: \\\" and \\\\");
            if (atEnd() || current() == '\n') return token;
        }
        append(token, current(), here_);
    }
    if (atEnd() || current() != '"')
        spoil(token, begin, "unterminated string: a string ends on the line it begins on");
    else
        advance();
    return token;
}

Token Lexer::scanWord(Token token) {
    token.kind = Token::Kind::Word;
    for (; !atEnd() && !endsWord(current()); advance()) append(token, current(), here_);
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
    const auto isNumber = [&](std::string_view text) {
        double value = 0.0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        return token.is(Token::Kind::Word) && end == text.data() + text.size() && error != std::errc::invalid_argument;
    };
    if (!isNumber(withoutPlus(token.text))) failAt(token.where, "expected an integer, found {}", described(token));
    const double value = numberOf(token);
    if (value != std::floor(value)) failAt(token.where, "expected an integer, found {}", described(token));
    if (std::abs(value) > 2147483647.0) failAt(token.where, "{} does not fit an integer of 32 bits", described(token));
    return int(value);
}

}  // namespace dsphere
