#include "scene/diagnostics.h"

#include "base/limits.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <tuple>

namespace dsphere {

namespace {

constexpr std::size_t kLongestWord = 80;  // bytes of a word that a message repeats

}  // namespace

void Report::add(const SceneError& error) {
    if (waiting_.size() <= limits::kReportedErrors) waiting_.push_back(error);
}

bool Report::endDirective() {
    std::ranges::stable_sort(
        waiting_, {}, [](const SceneError& error) { return std::tuple(error.where().line, error.where().column); });
    const bool any = !waiting_.empty();
    for (const SceneError& error : waiting_) listed_.add(error.what());
    waiting_.clear();
    return any;
}

void Report::note(const SourceLocation& where, const std::string& subject, const std::string& what) {
    if (noted_.insert(subject).second)
        notices_.push_back({Notice::Kind::Note, fmt::format("{}: {} {}", where.text(), subject, what)});
}

void Report::warn(const SourceLocation& where, const std::string& what) {
    notices_.push_back({Notice::Kind::Warning, fmt::format("{}: {}", where.text(), what)});
}

std::string inQuotes(std::string_view word) {
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
        case Token::Kind::Malformed:
            return "a malformed word";
        case Token::Kind::Word:
        case Token::Kind::String:
            break;
    }
    return inQuotes(token.text);
}

std::string listed(const Words& words) {
    return fmt::format("{}", fmt::join(words, ", "));
}

void requireOneOf(const Token& word, std::string_view what, const Words& supported) {
    if (std::find(supported.begin(), supported.end(), word.text) != supported.end()) return;
    failAt(word.where, "unknown {} {}; supported: {}", what, described(word), listed(supported));
}

}  // namespace dsphere
