#include "query/fields.h"

#include "base/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <iterator>
#include <type_traits>

namespace dsphere::query {

namespace {

static_assert(std::endian::native == std::endian::little, "records are written as they lie in memory");

enum class Type { Byte, Word, Float, Double };

struct Field {
    const char* name;
    Type type;
    int count;
    std::size_t offset;  ///< in QueryHit, or from kCertified on in Truth
};

constexpr Field kFields[] = {
    {"status", Type::Byte, 1, offsetof(QueryHit, status)},   {"t", Type::Double, 1, offsetof(QueryHit, t)},
    {"P", Type::Double, 3, offsetof(QueryHit, position)},    {"N", Type::Float, 3, offsetof(QueryHit, normal)},
    {"u", Type::Double, 1, offsetof(QueryHit, u)},           {"v", Type::Double, 1, offsetof(QueryHit, v)},
    {"lat", Type::Double, 1, offsetof(QueryHit, latitude)},  {"lon", Type::Double, 1, offsetof(QueryHit, longitude)},
    {"height", Type::Double, 1, offsetof(QueryHit, height)}, {"metres", Type::Double, 1, offsetof(QueryHit, metres)},
    {"id", Type::Word, 1, offsetof(QueryHit, id)},           {"lit", Type::Word, 1, offsetof(QueryHit, lit)},
    {"t_low", Type::Double, 1, offsetof(Truth, t_low)},      {"t_high", Type::Double, 1, offsetof(Truth, t_high)},
    {"tangent", Type::Byte, 1, offsetof(Truth, tangent)},
};
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

void Record::put(std::byte* target, std::span<const Answer> answers, std::span<const Truth> truths) const {
    for (const int i : fields_) {
        const Field& field = kFields[i];
        const bool certified = i >= kCertified;
        const std::byte* source = certified ? std::as_bytes(truths).data() : std::as_bytes(answers).data();
        const std::size_t stride = certified ? sizeof(Truth) : sizeof(Answer);
        source += field.offset + (certified ? 0 : offsetof(Answer, hit));
        const auto copyAll = [&](auto bytes) {  // a constant: such copies need no call
            for (std::size_t k = 0; k < answers.size(); ++k)
                std::memcpy(target + k * bytes_, source + k * stride, bytes);
        };
        const std::size_t bytes = bytesOf(field.type) * std::size_t(field.count);
        if (bytes == 1) copyAll(std::integral_constant<std::size_t, 1>());
        if (bytes == 4) copyAll(std::integral_constant<std::size_t, 4>());
        if (bytes == 8) copyAll(std::integral_constant<std::size_t, 8>());
        if (bytes == 12) copyAll(std::integral_constant<std::size_t, 12>());
        if (bytes == 24) copyAll(std::integral_constant<std::size_t, 24>());
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
