#pragma once

// The words that begin a directive.

#include "scene/directives.h"

#include <string_view>

namespace dsphere {

enum class Place { Anywhere, BeforeWorld, InWorld };

struct Directive {
    std::string_view word;
    Place place;
    void (*run)(Statement);
    bool supported = true;  ///< otherwise `run` tells why it is refused
};

/// The directive of that word, or nullptr.
const Directive* findDirective(std::string_view word);
bool isDirective(std::string_view word);
/// The words of all that are supported.
Words supportedDirectives();

}  // namespace dsphere
