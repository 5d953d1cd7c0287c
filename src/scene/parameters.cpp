#include "scene/parameters.h"

#include "base/limits.h"
#include "scene/vocabulary.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace dsphere {

namespace {

const Words kTypes = {"float",  "integer", "string",  "bool",   "rgb",     "color",   "point",    "point3",   "point2",
                      "vector", "vector2", "vector3", "normal", "normal3", "texture", "spectrum", "blackbody"};

std::string_view plainType(std::string_view type) {
    if (type == "color") return "rgb";
    if (type == "point3" || type == "vector3" || type == "normal3") return type.substr(0, type.size() - 1);
    return type;
}

bool isType(std::string_view word) {
    return std::ranges::find(kTypes, word) != kTypes.end();
}

// Whether a string reads as "type name".
bool declares(const Token& token) {
    const std::size_t space = token.text.find(' ');
    return token.is(Token::Kind::String) && space != std::string::npos && isType(token.text.substr(0, space));
}

// Splits "type name".
Parameter declaration(const Token& token) {
    std::istringstream words(token.text);
    std::string type, name, rest;
    if (!(words >> type >> name) || words >> rest)
        failAt(token.where, "expected a parameter declared as \"type name\", found {}", described(token));
    if (!isType(type)) failAt(token.where, "unknown parameter type {}; supported: {}", inQuotes(type), listed(kTypes));
    return {std::string(plainType(type)), name, {}, token.where};
}

// A directive's word is where a missing value or bracket shows.
bool isValue(const Token& token) {
    return token.is(Token::Kind::String) || (token.is(Token::Kind::Word) && !isDirective(token.text));
}

void refuseValue(Lexer& input, std::string_view expected, const Parameter& owner) {
    if (input.peek().is(Token::Kind::Malformed)) input.next();  // throws what is wrong with it
    failAt(input.peek().where, "expected {} of parameter {}, found {}", expected, inQuotes(owner.name),
           described(input.peek()));
}

// One value, or any number of them in brackets.
std::vector<Token> readValues(Lexer& input, const Parameter& owner) {
    if (isValue(input.peek()) && !declares(input.peek())) return {input.next()};
    if (!input.peek().is(Token::Kind::Open)) refuseValue(input, "a value", owner);
    input.next();
    std::vector<Token> values;
    while (isValue(input.peek())) {
        if (values.size() == limits::kValues)
            failAt(owner.where, "parameter {} has more than {} values", inQuotes(owner.name), limits::kValues);
        values.push_back(input.next());
    }
    if (!input.peek().is(Token::Kind::Close)) refuseValue(input, "']' after the values", owner);
    input.next();
    return values;
}

void requireCount(const Parameter& parameter, std::size_t count) {
    if (parameter.values.size() == count) return;
    failAt(parameter.where, "parameter {} takes {} value{}{}, found {}", inQuotes(parameter.name), count,
           count == 1 ? "" : "s", count == 1 ? "" : " in [ ]", parameter.values.size());
}

bool flagValue(const Parameter& parameter) {
    requireCount(parameter, 1);
    const Token& value = parameter.values[0];
    if (value.text != "true" && value.text != "false")
        failAt(value.where, "parameter {} is {}; supported: true, false", inQuotes(parameter.name), described(value));
    return value.text == "true";
}

double numberIn(const Token& token, const Parameter& parameter, const Range& range) {
    double value = numberOf(token);
    if (!range.holds(value))
        failAt(token.where, "parameter {} is {}; supported: {}", inQuotes(parameter.name), value, range.text());
    return value;
}

}  // namespace

std::string Range::text() const {
    if (std::isinf(greatest)) return fmt::format("{} {}", open ? "greater than" : "at least", least);
    return fmt::format("{}{}, {}{}", open ? "in (" : "in [", least, greatest, open ? ")" : "]");
}

Parameters::Parameters(Lexer& input, std::string owner, Report& report) : owner_(std::move(owner)), report_(&report) {
    while (input.peek().is(Token::Kind::String)) {
        if (parameters_.size() == limits::kParameters)
            failAt(input.peek().where, "{} has more than {} parameters", owner_, limits::kParameters);
        Parameter parameter;
        bool declared = false;
        const Token token = input.next();
        attempt([&] { parameter = declaration(token), declared = true; });
        if (!declared) parameter.name = token.text;
        parameter.values = readValues(input, parameter);
        if (declared) attempt([&] { add(std::move(parameter)); });
    }
}

void Parameters::add(Parameter parameter) {
    for (const Parameter& earlier : parameters_)
        if (earlier.name == parameter.name)
            failAt(parameter.where, "parameter {} of {} is given twice, first at {}", inQuotes(parameter.name), owner_,
                   earlier.where.text());
    parameters_.push_back(std::move(parameter));
}

void Parameters::complete(const std::vector<Parameter>& defaults) {
    for (const Parameter& parameter : defaults) {
        if (placeOf(parameter.name)) continue;
        parameters_.push_back(parameter);
        parameters_.back().optional = true;
    }
}

const Parameter* Parameters::take(std::string_view name, const Words& types) {
    supported_.push_back(fmt::format("{} {}", fmt::join(types, "|"), name));
    return find(name, types);
}

const Parameter* Parameters::find(std::string_view name, const Words& types) {
    auto found = std::find_if(parameters_.begin(), parameters_.end(), [&](auto& p) { return p.name == name; });
    if (found == parameters_.end()) return nullptr;
    const auto fits = [&](std::string_view type) {
        const auto isNumber = [](std::string_view word) { return word == "float" || word == "integer"; };
        return type == found->type || (isNumber(type) && isNumber(found->type));
    };
    found->used = true;
    if (std::ranges::any_of(types, fits)) return &*found;
    if (found->optional) return nullptr;
    attempt([&] {
        failAt(found->where, "parameter {} of {} has type {}; supported: {}", inQuotes(name), owner_, found->type,
               listed(types));
    });
    return nullptr;
}

std::optional<double> Parameters::number(std::string_view name, const Range& range) {
    using Number = std::optional<double>;
    return valueOr(name, {"float"}, Number(), [&](const Parameter& p) -> Number { return numberValue(p, range); });
}

std::optional<double> Parameters::numberOrNan(std::string_view name, const Range& range) {
    using Number = std::optional<double>;
    return valueOr(name, {"float"}, Number(), [&](const Parameter& p) -> Number {
        const bool nan = p.values.size() == 1 && isNan(p.values[0]);
        return nan ? std::numeric_limits<double>::quiet_NaN() : numberValue(p, range);
    });
}

std::optional<int> Parameters::integer(std::string_view name, int least, int greatest) {
    using Integer = std::optional<int>;
    return valueOr(name, {"integer"}, Integer(), [&](const Parameter& p) -> Integer {
        requireCount(p, 1);
        const int value = integerOf(p.values[0]);
        if (value < least || value > greatest)
            failAt(p.values[0].where, "parameter {} is {}; supported: in [{}, {}]", inQuotes(name), value, least,
                   greatest);
        return value;
    });
}

std::optional<bool> Parameters::boolean(std::string_view name) {
    using Flag = std::optional<bool>;
    return valueOr(name, {"bool"}, Flag(), [](const Parameter& p) -> Flag { return flagValue(p); });
}

std::optional<SourceLocation> Parameters::placeOf(std::string_view name) const {
    auto found = std::find_if(parameters_.begin(), parameters_.end(), [&](auto& p) { return p.name == name; });
    if (found == parameters_.end()) return {};
    return found->where;
}

std::optional<Token> Parameters::string(std::string_view name) {
    using Text = std::optional<Token>;
    return valueOr(name, {"string"}, Text(), [](const Parameter& p) -> Text { return stringValue(p); });
}

std::optional<std::string> Parameters::choice(std::string_view name, const Words& supported) {
    std::optional<Token> word = string(name);
    std::optional<std::string> chosen;
    if (word) attempt([&] { requireOneOf(*word, name, supported), chosen = word->text; });
    return chosen;
}

std::optional<dvec3> Parameters::rgb(std::string_view name, const Range& range) {
    using Triple = std::optional<dvec3>;
    return valueOr(name, {"rgb"}, Triple(), [&](const Parameter& p) -> Triple { return tripleValue(p, range); });
}

std::optional<dvec3> Parameters::point(std::string_view name) {
    using Triple = std::optional<dvec3>;
    return valueOr(name, {"point"}, Triple(), [](const Parameter& p) -> Triple { return tripleValue(p, kAnyNumber); });
}

std::optional<std::array<double, 4>> Parameters::fourNumbers(std::string_view name, const Range& range) {
    using Four = std::optional<std::array<double, 4>>;
    return valueOr(name, {"float"}, Four(), [&](const Parameter& p) -> Four {
        requireCount(p, 4);
        std::array<double, 4> numbers;
        for (std::size_t i = 0; i < 4; ++i) numbers[i] = numberIn(p.values[i], p, range);
        return numbers;
    });
}

void Parameters::note(const Parameter& parameter) {
    report_->note(parameter.where, fmt::format("parameter {} of {}", inQuotes(parameter.name), owner_),
                  "changes nothing here");
}

void Parameters::ignore(std::string_view name, const Words& types) {
    ignoreIf(name, types, [](const Parameter&) {});
}

void Parameters::ignoreWithin(std::string_view name, const Range& range, std::string_view why) {
    ignoreIf(name, {"float"}, [&](const Parameter& parameter) {
        const double value = numberValue(parameter, kAnyNumber);
        if (!range.holds(value))
            failAt(parameter.values[0].where, "parameter {} of {} is {}; supported: {}", inQuotes(name), owner_, value,
                   why);
    });
}

void Parameters::ignoreFlag(std::string_view name, bool expected, std::string_view why) {
    ignoreIf(name, {"bool"}, [&](const Parameter& parameter) {
        if (flagValue(parameter) != expected)
            failAt(parameter.values[0].where, "parameter {} of {} is {}; supported: {}, {}", inQuotes(name), owner_,
                   !expected, expected, why);
    });
}

void Parameters::ignoreWord(std::string_view name, const Words& supported) {
    ignoreIf(name, {"string"},
             [&](const Parameter& parameter) { requireOneOf(stringValue(parameter), name, supported); });
}

void Parameters::refuse(std::string_view name, std::string_view why) {
    for (Parameter& parameter : parameters_) {
        if (parameter.name != name || parameter.used) continue;
        parameter.used = true;
        if (!parameter.optional)
            attempt([&] { failAt(parameter.where, "parameter {} of {}: {}", inQuotes(name), owner_, why); });
    }
}

void Parameters::requireSound() const {
    if (failed_) throw AlreadyReported{};
}

void Parameters::finish() {
    for (const Parameter& parameter : parameters_)
        if (!parameter.used && !parameter.optional)
            attempt([&] {
                failAt(parameter.where, "unknown parameter {} of {}; supported: {}", inQuotes(parameter.name), owner_,
                       fmt::join(supported_, ", "));
            });
    requireSound();
}

double numberValue(const Parameter& parameter, const Range& range) {
    requireCount(parameter, 1);
    return numberIn(parameter.values[0], parameter, range);
}

dvec3 tripleValue(const Parameter& parameter, const Range& range) {
    requireCount(parameter, 3);
    dvec3 triple;
    for (int i = 0; i < 3; ++i) triple[i] = numberIn(parameter.values[i], parameter, range);
    return triple;
}

std::vector<double> listValue(const Parameter& parameter, std::size_t per_item, std::string_view what,
                              std::size_t most) {
    const std::size_t count = parameter.values.size();
    if (count == 0 || count % per_item != 0 || count / per_item > most)
        failAt(parameter.where, "parameter {} has {} numbers; supported: {} for each of 1 to {} {}",
               inQuotes(parameter.name), count, per_item, most, what);
    std::vector<double> numbers;
    for (const Token& token : parameter.values) numbers.push_back(numberOf(token));
    return numbers;
}

const Token& stringValue(const Parameter& parameter) {
    requireCount(parameter, 1);
    const Token& value = parameter.values[0];
    if (!value.is(Token::Kind::String))
        failAt(value.where, "parameter {} takes a word in double quotes, found {}", inQuotes(parameter.name),
               described(value));
    return value;
}

}  // namespace dsphere
