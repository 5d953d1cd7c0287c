#pragma once

// How the parser words a user's mistake: "file:line:column: what was wrong; supported: what is".

#include "base/error.h"
#include "base/errorlist.h"
#include "scene/lexer.h"

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace dsphere {

/// A mistake in a scene's text: Error (InvalidInput) that also tells the place with which its message begins.
class SceneError : public Error {
  public:
    SceneError(const SourceLocation& where, const std::string& what)
        : Error(ExitCode::InvalidInput, where.text() + ": " + what), where_(where) {}
    const SourceLocation& where() const { return where_; }

  private:
    SourceLocation where_;
};

template <typename... Args>
[[noreturn]] void failAt(const SourceLocation& where, fmt::format_string<Args...> format, Args&&... args) {
    throw SceneError(where, fmt::format(format, std::forward<Args>(args)...));
}

/// What a directive throws to be left when the report has its errors already.
struct AlreadyReported {};

/// What a parse has to say of a text: its errors, and what is well but worth a line.
class Report {
  public:
    void add(const SceneError& error);
    bool hasErrors() const { return !listed_.empty() || !waiting_.empty(); }
    /// Makes this the last directive.
    void stop() { stopped_ = true; }
    /// Whether nothing more need be read: there are too many errors, or stop() was called.
    bool isOver() const { return stopped_ || listed_.overflows(); }
    /// Ends a directive: its errors, which came in the order of checking, go into the list by their places. Returns
    /// whether there were any.
    bool endDirective();
    /// All errors as one; see ErrorList.
    void throwIfAny() const { listed_.throwIfAny(); }

    /// Once for each `subject`, which names a parameter or directive wherever it stands.
    void note(const SourceLocation& where, const std::string& subject, const std::string& what);
    void warn(const SourceLocation& where, const std::string& what);
    const Notices& notices() const { return notices_; }

  private:
    ErrorList listed_;
    bool stopped_ = false;
    std::vector<SceneError> waiting_;
    std::set<std::string> noted_;
    Notices notices_;
};

/// As failAt(), and the rest of the scene is not read: where one limit is passed, all that follows passes it too.
template <typename... Args>
[[noreturn]] void stopAt(Report& report, const SourceLocation& where, fmt::format_string<Args...> format,
                         Args&&... args) {
    report.stop();
    throw SceneError(where, fmt::format(format, std::forward<Args>(args)...) + "; the rest is not read");
}

/// The word in double quotes, shortened when it is long: a message is one line whatever the file holds.
std::string inQuotes(std::string_view word);

/// The token as a message names it: `"word"`, `'['` or `the end of the file`.
std::string described(const Token& token);

using Words = std::vector<std::string_view>;

/// "a, b, c".
std::string listed(const Words& words);

/// Fails at `word` unless its text is one of `supported`; `what` says what it should have been ("camera").
void requireOneOf(const Token& word, std::string_view what, const Words& supported);

}  // namespace dsphere
