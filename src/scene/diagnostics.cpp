#include "scene/diagnostics.h"

#include <algorithm>

namespace dsphere {

namespace {

constexpr std::size_t kLongestWord = 80;  // bytes of a word that a message repeats

}  // namespace

std::string quoted(std::string_view word) {
    if (word.size() <= kLongestWord) return fmt::format("\"{}\"", word);
    return fmt::format("\"{}...\"", word.substr(0, kLongestWord));
}

std::string described(const Token& token) {
    switch (token.kind) {
        case Token::Kind::Open:
            return "'['";
        case Token::Kind::Close:
            return "']'";
        case Token::Kind::End:
            return "the end of the file";
        case Token::Kind::Word:
        case Token::Kind::String:
            break;
    }
    return quoted(token.text);
}

std::string listed(const Words& words) {
    return fmt::format("{}", fmt::join(words, ", "));
}

void requireOneOf(const Token& word, std::string_view what, const Words& supported) {
    if (std::find(supported.begin(), supported.end(), word.text) != supported.end()) return;
    failAt(word.where, "unknown {} {}; supported: {}", what, described(word), listed(supported));
}

}  // namespace dsphere
