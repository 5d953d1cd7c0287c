#pragma once

// Scene text to tokens. Columns count bytes from 1; '#' begins a comment that ends with its line.

#include "scene/scene.h"

#include <string>
#include <string_view>

namespace dsphere {

struct Token {
    enum class Kind { Word, String, Open, Close, End, Malformed };

    Kind kind = Kind::End;
    std::string text;      ///< a string's is without its quotes, escapes resolved; what is wrong with a malformed one
    SourceLocation where;  ///< of the first character, the quote included

    bool is(Kind wanted) const { return kind == wanted; }
};

class Lexer {
  public:
    /// `text` must outlive the lexer; `file` is what locations name.
    Lexer(std::string_view text, std::string file);

    /// The next token, which stays to be taken.
    const Token& peek() const { return ahead_; }

    /// Takes a token; at the end of the text always End. Throws SceneError for a malformed one, which counts as taken:
    /// a string that does not end on its line, an unknown escape (\" and \\ are the known ones), a control character.
    Token next();
    /// Takes a token unread, malformed or not.
    void skip();

    /// What the last comment line `# get: ...` before the next token says, or nothing: how to get the files that the
    /// scene names after it.
    const std::string& howToGet() const { return how_to_get_; }

    /// Takes a quoted string; `what` says in the error what should have stood here ("a camera's type").
    Token takeString(std::string_view what);

  private:
    Token scan();
    Token scanString(Token token);
    Token scanWord(Token token);
    void skipSpace();
    void skipComment();
    void advance();
    bool atEnd() const { return position_ == text_.size(); }
    char current() const { return text_[position_]; }

    std::string_view text_;
    std::size_t position_ = 0;
    SourceLocation here_;
    std::string how_to_get_;
    Token ahead_;
};

/// The finite number that the token spells in full. Throws SceneError otherwise.
double numberOf(const Token& token);

/// Whether the token is the bare word nan, in any case: a number where NaN has a meaning.
bool isNan(const Token& token);

/// The 32-bit integer that the token spells in full, as `16` or `16.0`. Throws SceneError otherwise.
int integerOf(const Token& token);

}  // namespace dsphere
