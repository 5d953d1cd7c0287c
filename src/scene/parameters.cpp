#include "scene/parameters.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace dsphere {

namespace {

const Words kTypes = {"float",  "integer", "string",  "bool",   "rgb",     "color",   "point",   "point3",
                      "point2", "vector",  "vector3", "normal", "normal3", "texture", "spectrum"};

std::string_view plainType(std::string_view type) {
    if (type == "color") return "rgb";
    if (type == "point3" || type == "vector3" || type == "normal3") return type.substr(0, type.size() - 1);
    return type;
}

// Splits "type name".
Parameter declaration(const Token& token) {
    std::istringstream words(token.text);
    std::string type, name, rest;
    if (!(words >> type >> name) || words >> rest)
        failAt(token.where, "expected a parameter declared as \"type name\", found {}", described(token));
    if (std::find(kTypes.begin(), kTypes.end(), type) == kTypes.end())
        failAt(token.where, "unknown parameter type {}; supported: {}", quoted(type), listed(kTypes));
    return {std::string(plainType(type)), name, {}, token.where};
}

bool isValue(const Token& token) {
    return token.is(Token::Kind::Word) || token.is(Token::Kind::String);
}

// One value, or any number of them in brackets.
std::vector<Token> readValues(Lexer& input, const Parameter& owner) {
    if (isValue(input.peek())) return {input.next()};
    Token open = input.next();
    if (!open.is(Token::Kind::Open))
        failAt(open.where, "expected a value of parameter {}, found {}", quoted(owner.name), described(open));
    std::vector<Token> values;
    while (isValue(input.peek())) values.push_back(input.next());
    Token close = input.next();
    if (!close.is(Token::Kind::Close))
        failAt(close.where, "expected ']' after the values of parameter {}, found {}", quoted(owner.name),
               described(close));
    return values;
}

void requireCount(const Parameter& parameter, std::size_t count) {
    if (parameter.values.size() == count) return;
    failAt(parameter.where, "parameter {} takes {} value{}{}, found {}", quoted(parameter.name), count,
           count == 1 ? "" : "s", count == 1 ? "" : " in [ ]", parameter.values.size());
}

double numberIn(const Token& token, const Parameter& parameter, const Range& range) {
    double value = numberOf(token);
    if (!range.holds(value))
        failAt(token.where, "parameter {} is {}; supported: {}", quoted(parameter.name), value, range.text());
    return value;
}

}  // namespace

std::string Range::text() const {
    if (std::isinf(greatest)) return fmt::format("{} {}", open ? "greater than" : "at least", least);
    return fmt::format("{}{}, {}{}", open ? "in (" : "in [", least, greatest, open ? ")" : "]");
}

Parameters::Parameters(Lexer& input, std::string owner) : owner_(std::move(owner)) {
    while (input.peek().is(Token::Kind::String)) {
        Parameter parameter = declaration(input.next());
        parameter.values = readValues(input, parameter);
        add(std::move(parameter));
    }
}

void Parameters::add(Parameter parameter) {
    for (const Parameter& earlier : parameters_)
        if (earlier.name == parameter.name)
            failAt(parameter.where, "parameter {} of {} is given twice, first at {}", quoted(parameter.name), owner_,
                   earlier.where.text());
    parameters_.push_back(std::move(parameter));
}

const Parameter* Parameters::take(std::string_view name, const Words& types) {
    supported_.push_back(fmt::format("{} {}", fmt::join(types, "|"), name));
    auto found = std::find_if(parameters_.begin(), parameters_.end(), [&](auto& p) { return p.name == name; });
    if (found == parameters_.end()) return nullptr;
    if (std::find(types.begin(), types.end(), found->type) == types.end())
        failAt(found->where, "parameter {} of {} has type {}; supported: {}", quoted(name), owner_, found->type,
               listed(types));
    found->used = true;
    return &*found;
}

std::optional<double> Parameters::number(std::string_view name, const Range& range) {
    const Parameter* parameter = take(name, {"float"});
    if (!parameter) return {};
    return numberValue(*parameter, range);
}

std::optional<double> Parameters::numberOrNan(std::string_view name, const Range& range) {
    const Parameter* parameter = take(name, {"float"});
    if (!parameter) return {};
    if (parameter->values.size() == 1 && isNan(parameter->values[0])) return std::numeric_limits<double>::quiet_NaN();
    return numberValue(*parameter, range);
}

std::optional<int> Parameters::integer(std::string_view name, int least, int greatest) {
    const Parameter* parameter = take(name, {"integer"});
    if (!parameter) return {};
    requireCount(*parameter, 1);
    int value = integerOf(parameter->values[0]);
    if (value < least || value > greatest)
        failAt(parameter->values[0].where, "parameter {} is {}; supported: in [{}, {}]", quoted(name), value, least,
               greatest);
    return value;
}

std::optional<bool> Parameters::boolean(std::string_view name) {
    const Parameter* parameter = take(name, {"bool"});
    if (!parameter) return {};
    requireCount(*parameter, 1);
    const Token& value = parameter->values[0];
    if (value.text != "true" && value.text != "false")
        failAt(value.where, "parameter {} is {}; supported: true, false", quoted(name), described(value));
    return value.text == "true";
}

std::optional<SourceLocation> Parameters::placeOf(std::string_view name) const {
    auto found = std::find_if(parameters_.begin(), parameters_.end(), [&](auto& p) { return p.name == name; });
    if (found == parameters_.end()) return {};
    return found->where;
}

std::optional<Token> Parameters::string(std::string_view name) {
    const Parameter* parameter = take(name, {"string"});
    if (!parameter) return {};
    return stringValue(*parameter);
}

std::optional<std::string> Parameters::choice(std::string_view name, const Words& supported) {
    std::optional<Token> word = string(name);
    if (!word) return {};
    requireOneOf(*word, name, supported);
    return word->text;
}

std::optional<dvec3> Parameters::rgb(std::string_view name, const Range& range) {
    const Parameter* parameter = take(name, {"rgb"});
    if (!parameter) return {};
    return tripleValue(*parameter, range);
}

std::optional<dvec3> Parameters::point(std::string_view name) {
    const Parameter* parameter = take(name, {"point"});
    if (!parameter) return {};
    return tripleValue(*parameter, kAnyNumber);
}

std::optional<std::array<double, 4>> Parameters::fourNumbers(std::string_view name, const Range& range) {
    const Parameter* parameter = take(name, {"float"});
    if (!parameter) return {};
    requireCount(*parameter, 4);
    std::array<double, 4> numbers;
    for (int i = 0; i < 4; ++i) numbers[i] = numberIn(parameter->values[i], *parameter, range);
    return numbers;
}

void Parameters::finish() const {
    for (const Parameter& parameter : parameters_)
        if (!parameter.used)
            failAt(parameter.where, "unknown parameter {} of {}; supported: {}", quoted(parameter.name), owner_,
                   fmt::join(supported_, ", "));
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
               quoted(parameter.name), count, per_item, most, what);
    std::vector<double> numbers;
    for (const Token& token : parameter.values) numbers.push_back(numberOf(token));
    return numbers;
}

const Token& stringValue(const Parameter& parameter) {
    requireCount(parameter, 1);
    const Token& value = parameter.values[0];
    if (!value.is(Token::Kind::String))
        failAt(value.where, "parameter {} takes a word in double quotes, found {}", quoted(parameter.name),
               described(value));
    return value;
}

}  // namespace dsphere
