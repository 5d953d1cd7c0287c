#pragma once

// A directive's `"type name" value` list, typed, and strict: whatever nobody asked for is an error.
//
// A wrong parameter goes into the report and counts as absent, so that one run finds all wrong ones; finish() leaves
// the directive if there were any.

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
    bool optional = false;  ///< given by Attribute: the directive need not know it
};

class Parameters {
  public:
    /// Reads all parameters up to the next directive. `owner` is what messages call the directive: `Shape "disk"`.
    /// Reports malformed declarations, unknown types, names given twice; throws SceneError for an unclosed bracket.
    Parameters(Lexer& input, std::string owner, Report& report);

    /// Takes those of `defaults` whose names are not given.
    void complete(const std::vector<Parameter>& defaults);
    /// All of them, taken out.
    std::vector<Parameter> release() { return std::move(parameters_); }

    /// The parameter of that name, or nullptr; a type that is none of `types` is reported. Integers serve as floats and
    /// the other way round. Every name that is asked for counts as supported, so a directive asks for all of its
    /// parameters before finish().
    const Parameter* take(std::string_view name, const Words& types);
    /// `read(parameter)` if it is given, else `otherwise`; what `read` throws is reported.
    template <typename T, typename Read>
    T valueOr(std::string_view name, const Words& types, T otherwise, Read read) {
        const Parameter* parameter = take(name, types);
        if (parameter) attempt([&] { otherwise = read(*parameter); });
        return otherwise;
    }

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

    // Parameters of pbrt that cannot change a picture here: accepted and noted.
    /// Unless `check(parameter)` throws.
    template <typename Check>
    void ignoreIf(std::string_view name, const Words& types, Check check) {
        const Parameter* parameter = find(name, types);
        if (parameter) attempt([&] { check(*parameter), note(*parameter); });
    }
    /// Whatever it says.
    void ignore(std::string_view name, const Words& types);
    /// Within `range` alone; `why` completes the error otherwise: "supported: 0, a pinhole".
    void ignoreWithin(std::string_view name, const Range& range, std::string_view why);
    void ignoreFlag(std::string_view name, bool expected, std::string_view why);
    void ignoreWord(std::string_view name, const Words& supported);
    /// Reports the parameter if it is given, and says why it has no place here.
    void refuse(std::string_view name, std::string_view why);

    /// Runs `check`, and reports what it throws.
    template <typename Check>
    void attempt(Check check) {
        try {
            check();
        } catch (const SceneError& error) {
            report_->add(error);
            failed_ = true;
        }
    }
    /// Leaves the directive (AlreadyReported) if any parameter so far was wrong: what is checked next may rest on it.
    void requireSound() const;
    bool isSound() const { return !failed_; }
    /// Reports all parameters that were not asked for, then requireSound().
    void finish();

  private:
    void add(Parameter parameter);
    const Parameter* find(std::string_view name, const Words& types);
    void note(const Parameter& parameter);

    std::string owner_;
    Report* report_;
    bool failed_ = false;
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
