#pragma once

// How the parser words a user's mistake: "file:line:column: what was wrong; supported: what is".

#include "base/error.h"
#include "scene/lexer.h"

#include <string>
#include <string_view>
#include <vector>

namespace dsphere {

/// Throws Error (InvalidInput) whose message begins with the place.
template <typename... Args>
[[noreturn]] void failAt(const SourceLocation& where, fmt::format_string<Args...> format, Args&&... args) {
    throwInvalid("{}: {}", where.text(), fmt::format(format, std::forward<Args>(args)...));
}

/// The word in double quotes, shortened when it is long: a message is one line whatever the file holds.
std::string quoted(std::string_view word);

/// The token as a message names it: `"word"`, `'['` or `the end of the file`.
std::string described(const Token& token);

using Words = std::vector<std::string_view>;

/// "a, b, c".
std::string listed(const Words& words);

/// Fails at `word` unless its text is one of `supported`; `what` says what it should have been ("camera").
void requireOneOf(const Token& word, std::string_view what, const Words& supported);

}  // namespace dsphere
