#include "query/rayreader.h"

#include "base/error.h"

#include <charconv>
#include <string_view>

namespace dsphere::query {

namespace {

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::string_view kSpaces = " \t\r\n";
constexpr std::size_t kMostHeader = 1 << 20;
constexpr std::uint64_t kMostRows = 999'999'999'999'999;
constexpr std::size_t kMostShown = 80;  // characters of a header that a message repeats
constexpr const char* kExpectedOfNpy =
    "expected a float64 array of the shape (N, 6): origin and direction, or (N, 8): tmin "
    "and tmax too";

[[noreturn]] void refuse(const InputStream& stream, const std::string& found) {
    throwInvalid("{}: {}; {}", stream.name(), found, kExpectedOfNpy);
}

/// All bytes before the array.
std::string readHeader(InputStream& stream) {
    unsigned char lead[12] = {};
    const auto fetch = [&](void* target, std::size_t count) {
        if (stream.read(target, count) < count) throwInvalid("{}: ends within its NumPy header", stream.name());
    };
    fetch(lead, 8);
    const int version = lead[6];
    if (version < 1 || version > 3)
        throwInvalid("{}: is of version {}.{} of NumPy's format, expected 1.0, 2.0 or 3.0", stream.name(), version,
                     int(lead[7]));
    const std::size_t wide = version == 1 ? 2 : 4;
    fetch(lead + 8, wide);
    std::size_t length = 0;
    for (std::size_t k = wide; k-- > 0;) length = length << 8 | lead[8 + k];
    if (length > kMostHeader)
        throwInvalid("{}: its NumPy header claims {} bytes, expected at most {}", stream.name(), length, kMostHeader);
    std::string header(reinterpret_cast<const char*>(lead), 8 + wide);
    header.resize(header.size() + length);
    fetch(header.data() + 8 + wide, length);
    return header;
}

std::string describeType(std::string_view type) {
    if (type == ">f8") return "holds big-endian float64 ('>f8')";
    if (type == "<f4") return "holds float32 ('<f4')";
    return fmt::format("holds the type '{}'", type.substr(0, kMostShown));
}

/// What of a header is needed: rows and columns.
struct Shape {
    std::uint64_t rows = 0;
    int columns = 0;
};

/// What stands behind the key in a header, which is a Python dictionary; unset without the key.
std::optional<std::string_view> valueOf(std::string_view header, std::string_view key) {
    const std::size_t at = header.find(key);
    if (at == std::string_view::npos) return {};
    header.remove_prefix(at + key.size());
    const std::size_t colon = header.find_first_not_of(kSpaces);
    if (colon == std::string_view::npos || header[colon] != ':') return {};
    const std::size_t value = header.find_first_not_of(kSpaces, colon + 1);
    return value == std::string_view::npos ? std::string_view() : header.substr(value);
}

/// "(N, 6)" or "(N, 8)", with a comma at the end or without; unset for others.
std::optional<Shape> shapeOf(std::string_view text) {
    std::string plain;
    for (const char c : text)
        if (kSpaces.find(c) == std::string_view::npos) plain += c;
    if (plain.ends_with(",)")) plain.erase(plain.size() - 2, 1);
    Shape shape;
    const char* const end = plain.data() + plain.size();
    const auto rows = std::from_chars(plain.data() + 1, end, shape.rows);
    if (rows.ec != std::errc() || shape.rows > kMostRows || rows.ptr == end || *rows.ptr != ',') return {};
    const auto columns = std::from_chars(rows.ptr + 1, end, shape.columns);
    if (columns.ec != std::errc() || columns.ptr + 1 != end || (shape.columns != 6 && shape.columns != 8)) return {};
    return shape;
}

Shape parseHeader(const InputStream& stream, std::string_view header) {
    const auto type = valueOf(header, "'descr'");
    if (type && type->starts_with('[')) refuse(stream, "holds records of several fields");
    const std::size_t type_end = type && type->starts_with('\'') ? type->find('\'', 1) : std::string_view::npos;
    if (type_end == std::string_view::npos) refuse(stream, "its NumPy header has no 'descr'");
    const std::string_view name = type->substr(1, type_end - 1);
    if (name != "<f8") refuse(stream, describeType(name));
    if (valueOf(header, "'fortran_order'").value_or("").starts_with("True"))
        refuse(stream, "is stored column by column (fortran_order; numpy.ascontiguousarray turns it)");
    const auto shape = valueOf(header, "'shape'");
    const std::size_t shape_end = shape && shape->starts_with('(') ? shape->find(')') : std::string_view::npos;
    if (shape_end == std::string_view::npos) refuse(stream, "its NumPy header has no 'shape'");
    const std::string_view text = shape->substr(0, shape_end + 1);
    const std::optional<Shape> found = shapeOf(text);
    if (!found) refuse(stream, fmt::format("has the shape {}", text.substr(0, kMostShown)));
    return *found;
}

class NpyReader : public RayReader {
  public:
    explicit NpyReader(InputStream stream) : stream_(std::move(stream)) {
        const std::string header = readHeader(stream_);
        shape_ = parseHeader(stream_, header);
        if (!stream_.size()) return;
        const std::uint64_t wanted = header.size() + shape_.rows * rowBytes();
        if (*stream_.size() < wanted)
            throwInvalid("{}: has {} bytes, but its {} rays of {} values take {}", stream_.name(), *stream_.size(),
                         shape_.rows, shape_.columns, wanted);
    }

    RayRows read(std::vector<double>& room, std::size_t most) override {
        const std::size_t rows = std::size_t(std::min<std::uint64_t>(most, shape_.rows - read_));
        room.resize(rows * std::size_t(shape_.columns));
        const std::size_t bytes = rows * rowBytes(), found = stream_.read(room.data(), bytes);
        if (found < bytes)
            throwInvalid("{}: ends after {} of {} rays", stream_.name(), read_ + found / rowBytes(), shape_.rows);
        read_ += rows;
        return {room.data(), shape_.columns, rows};
    }

    std::optional<std::uint64_t> count() const override { return shape_.rows; }
    std::optional<double> share() const override { return shape_.rows > 0 ? double(read_) / double(shape_.rows) : 1.0; }

  private:
    std::size_t rowBytes() const { return std::size_t(shape_.columns) * sizeof(double); }

    InputStream stream_;
    Shape shape_;
    std::uint64_t read_ = 0;
};

}  // namespace

std::unique_ptr<RayReader> openNpy(InputStream stream) {
    if (stream.peek(kMagic.size()) != kMagic)
        throwInvalid("{}: is no NumPy file, which begins with \\x93NUMPY", stream.name());
    return std::make_unique<NpyReader>(std::move(stream));
}

std::unique_ptr<RayReader> openRays(const std::string& name, std::optional<FileFormat> format,
                                    const Geography& geography) {
    InputStream stream(name);
    const bool npy = stream.peek(kMagic.size()) == kMagic;
    if (format.value_or(npy ? FileFormat::Npy : FileFormat::Csv) == FileFormat::Npy) return openNpy(std::move(stream));
    return openCsv(std::move(stream), geography);
}

}  // namespace dsphere::query
