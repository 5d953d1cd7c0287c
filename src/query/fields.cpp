#include "query/fields.h"

#include "base/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <functional>
#include <iterator>

namespace dsphere::query {

namespace {

static_assert(std::endian::native == std::endian::little, "records are written as they lie in memory");

enum class Type { Byte, Word, Float, Double };

struct Field {
    const char* name;
    Type type;
    int count;
    const void* (*from)(const QueryHit&, const Truth&);
};

// NOLINTBEGIN: one line a field
constexpr Field kFields[] = {
    {"status", Type::Byte, 1, [](const QueryHit& hit, const Truth&) -> const void* { return &hit.status; }},
    {"t", Type::Double, 1, [](const QueryHit& hit, const Truth&) -> const void* { return &hit.t; }},
    {"P", Type::Double, 3, [](const QueryHit& hit, const Truth&) -> const void* { return hit.position.data(); }},
    {"N", Type::Float, 3, [](const QueryHit& hit, const Truth&) -> const void* { return hit.normal.data(); }},
    {"u", Type::Double, 1, [](const QueryHit& hit, const Truth&) -> const void* { return &hit.u; }},
    {"v", Type::Double, 1, [](const QueryHit& hit, const Truth&) -> const void* { return &hit.v; }},
    {"lat", Type::Double, 1, [](const QueryHit& hit, const Truth&) -> const void* { return &hit.latitude; }},
    {"lon", Type::Double, 1, [](const QueryHit& hit, const Truth&) -> const void* { return &hit.longitude; }},
    {"height", Type::Double, 1, [](const QueryHit& hit, const Truth&) -> const void* { return &hit.height; }},
    {"metres", Type::Double, 1, [](const QueryHit& hit, const Truth&) -> const void* { return &hit.metres; }},
    {"id", Type::Word, 1, [](const QueryHit& hit, const Truth&) -> const void* { return &hit.id; }},
    {"lit", Type::Word, 1, [](const QueryHit& hit, const Truth&) -> const void* { return &hit.lit; }},
    {"t_low", Type::Double, 1, [](const QueryHit&, const Truth& truth) -> const void* { return &truth.t_low; }},
    {"t_high", Type::Double, 1, [](const QueryHit&, const Truth& truth) -> const void* { return &truth.t_high; }},
    {"tangent", Type::Byte, 1, [](const QueryHit&, const Truth& truth) -> const void* { return &truth.tangent; }},
};
// NOLINTEND
constexpr int kCertified = 12;  // where those of --certify begin

std::size_t bytesOf(Type type) {
    constexpr std::size_t kBytes[] = {1, 4, 4, 8};
    return kBytes[std::size_t(type)];
}

const char* numpyName(Type type) {
    constexpr const char* kNames[] = {"|u1", "<u4", "<f4", "<f8"};
    return kNames[std::size_t(type)];
}

template <typename T>
T readAs(const std::byte* from) {
    T value;
    std::memcpy(&value, from, sizeof(T));
    return value;
}

void appendValue(std::string& text, Type type, const std::byte* from) {
    const auto out = std::back_inserter(text);
    if (type == Type::Byte) fmt::format_to(out, "{}", readAs<std::uint8_t>(from));
    if (type == Type::Word) fmt::format_to(out, "{}", readAs<std::uint32_t>(from));
    if (type == Type::Float) fmt::format_to(out, "{}", readAs<float>(from));
    if (type == Type::Double) fmt::format_to(out, "{}", readAs<double>(from));
}

}  // namespace

std::vector<std::string> Record::everyName(bool certified) {
    std::vector<std::string> names;
    for (int i = 0; i < (certified ? int(std::size(kFields)) : kCertified); ++i) names.push_back(kFields[i].name);
    return names;
}

Record::Record(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        const auto* found = std::ranges::find_if(kFields, [&](const Field& field) { return name == field.name; });
        if (found == std::end(kFields))
            throw Error(ExitCode::Usage, fmt::format("--fields: unknown field '{}', expected some of {}", name,
                                                     fmt::join(everyName(true), ",")));
        if (has(name)) throw Error(ExitCode::Usage, fmt::format("--fields: '{}' stands twice", name));
        fields_.push_back(int(found - kFields));
        bytes_ += bytesOf(found->type) * std::size_t(found->count);
    }
}

bool Record::has(const std::string& name) const {
    return std::ranges::any_of(fields_, [&](int i) { return name == kFields[i].name; });
}

void Record::put(std::byte* target, const QueryHit& hit, const Truth& truth) const {
    for (const int i : fields_) {
        const Field& field = kFields[i];
        const std::size_t bytes = bytesOf(field.type) * std::size_t(field.count);
        std::memcpy(target, field.from(hit, truth), bytes);
        target += bytes;
    }
}

std::string Record::numpyType() const {
    std::string text = "[";
    for (const int i : fields_) {
        const Field& field = kFields[i];
        text += fmt::format("('{}', '{}'", field.name, numpyName(field.type));
        if (field.count > 1) text += fmt::format(", ({},)", field.count);
        text += i == fields_.back() ? ")" : "), ";
    }
    return text + "]";
}

std::string Record::csvHeader() const {
    std::vector<std::string> names;
    for (const int i : fields_) {
        const Field& field = kFields[i];
        if (field.count == 1) names.push_back(field.name);
        for (int c = 0; field.count == 3 && c < 3; ++c) names.push_back(fmt::format("{}_{}", field.name, "xyz"[c]));
    }
    return fmt::format("{}\n", fmt::join(names, ","));
}

void Record::appendCsv(std::string& text, const std::byte* record) const {
    for (const int i : fields_)
        for (int c = 0; c < kFields[i].count; ++c) {
            appendValue(text, kFields[i].type, record);
            record += bytesOf(kFields[i].type);
            text += ',';
        }
    text.back() = '\n';
}

}  // namespace dsphere::query
