#pragma once

// A directive's `"type name" value` list, typed, and strict: whatever nobody asked for is an error.

#include "base/math.h"
#include "scene/diagnostics.h"
#include "scene/lexer.h"

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dsphere {

/// The numbers that a parameter may take.
struct Range {
    double least = -std::numeric_limits<double>::infinity();
    double greatest = std::numeric_limits<double>::infinity();
    bool open = false;  ///< finite ends are themselves excluded

    bool holds(double x) const { return open ? x > least && x < greatest : x >= least && x <= greatest; }
    std::string text() const;  ///< "in [0, 1]", "greater than 0"; needs a finite `least`
};

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr Range kAnyNumber{};
inline constexpr Range kPositive{0.0, kInfinity, true};
inline constexpr Range kNotNegative{0.0, kInfinity};
inline constexpr Range kFraction{0.0, 1.0};
// Of displaced spheres. A stored value is what rounds to a finite float: maps hold floats.
inline constexpr Range kLongitudeOrigin{-360.0, 360.0};
inline constexpr Range kBlur{0.0, 1000.0};
inline constexpr Range kStoredValue{-3.4028235e38, 3.4028235e38};
inline constexpr int kMostBands = 65536;

/// One parameter as written: its values are read when their type is asked for.
struct Parameter {
    std::string type;  ///< `color`, `point3` and `vector3` are told as `rgb`, `point` and `vector`
    std::string name;
    std::vector<Token> values;
    SourceLocation where;  ///< of the declaration's opening quote
    bool used = false;
};

class Parameters {
  public:
    /// Reads all parameters up to the next directive. `owner` is what messages call the directive: `Shape "disk"`.
    /// Throws Error (InvalidInput): malformed declaration, unknown type, name given twice, unclosed or nested bracket.
    Parameters(Lexer& input, std::string owner);

    /// The parameter of that name, or nullptr; fails when it has none of the `types`. Every name that is asked for
    /// counts as supported, so a directive asks for all of its parameters before finish().
    const Parameter* take(std::string_view name, const Words& types);

    std::optional<double> number(std::string_view name, const Range& range);
    /// As number(), but nan may be given too.
    std::optional<double> numberOrNan(std::string_view name, const Range& range);
    std::optional<int> integer(std::string_view name, int least, int greatest);
    /// true or false, as pbrt v4 spells them, or in quotes, as v3 does.
    std::optional<bool> boolean(std::string_view name);
    /// Where the parameter of that name stands, if it is given.
    std::optional<SourceLocation> placeOf(std::string_view name) const;
    std::optional<Token> string(std::string_view name);
    std::optional<std::string> choice(std::string_view name, const Words& supported);
    std::optional<dvec3> rgb(std::string_view name, const Range& range);
    std::optional<dvec3> point(std::string_view name);
    std::optional<std::array<double, 4>> fourNumbers(std::string_view name, const Range& range);

    /// Fails at the first parameter that was not asked for.
    void finish() const;

  private:
    void add(Parameter parameter);

    std::string owner_;
    std::vector<Parameter> parameters_;
    std::vector<std::string> supported_;  // "type name" in the order asked for
};

// The values of a parameter that was taken; each fails on a wrong count, a word of another type, a value out of range.
double numberValue(const Parameter& parameter, const Range& range);
dvec3 tripleValue(const Parameter& parameter, const Range& range);
const Token& stringValue(const Parameter& parameter);
/// Any number of numbers, a multiple of `per_item`, of `what` ("points") at most `most` items.
std::vector<double> listValue(const Parameter& parameter, std::size_t per_item, std::string_view what,
                              std::size_t most);

}  // namespace dsphere
