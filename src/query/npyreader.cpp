#include "query/rayreader.h"

#include "base/error.h"

#include <cmath>
#include <cstring>
#include <regex>

namespace dsphere::query {

namespace {

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::size_t kMostHeader = 1 << 20;
constexpr const char* kExpected =
    "expected a float64 array of the shape (N, 6): origin and direction, or (N, 8): tmin "
    "and tmax too";

[[noreturn]] void refuse(const InputStream& stream, const std::string& found) {
    throwInvalid("{}: {}; {}", stream.name(), found, kExpected);
}

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
    if (length > kMostHeader) throwInvalid("{}: its NumPy header claims {} bytes", stream.name(), length);
    std::string header(length, '\0');
    fetch(header.data(), length);
    return header;
}

std::string describeType(const std::string& type) {
    if (type == ">f8") return "holds big-endian float64 ('>f8')";
    if (type == "<f4") return "holds float32 ('<f4')";
    return "holds the type '" + type + "'";
}

/// What of a header is needed: rows and columns.
struct Shape {
    std::uint64_t rows = 0;
    int columns = 0;
};

Shape parseHeader(const InputStream& stream, const std::string& header) {
    std::smatch match;
    if (!std::regex_search(header, match, std::regex(R"('descr'\s*:\s*(\[|'([^']*)'))")))
        refuse(stream, "its NumPy header has no 'descr'");
    if (match[1] == "[") refuse(stream, "holds records of several fields");
    if (match[2] != "<f8") refuse(stream, describeType(match[2]));
    if (std::regex_search(header, std::regex(R"('fortran_order'\s*:\s*True)")))
        refuse(stream, "is stored column by column (fortran_order; numpy.ascontiguousarray turns it)");
    if (!std::regex_search(header, match, std::regex(R"('shape'\s*:\s*(\([^)]*\)))")))
        refuse(stream, "its NumPy header has no 'shape'");
    const std::string shape = match[1];
    if (!std::regex_match(shape, match, std::regex(R"(\(\s*(\d{1,15})\s*,\s*([68])\s*,?\s*\))")))
        refuse(stream, "has the shape " + shape);
    return {std::stoull(match[1]), std::stoi(match[2])};
}

class NpyReader : public RayReader {
  public:
    explicit NpyReader(InputStream stream) : stream_(std::move(stream)) {
        const std::string header = readHeader(stream_);
        shape_ = parseHeader(stream_, header);
        if (!stream_.size()) return;
        const std::uint64_t lead = header.size() + 10, wanted = lead + shape_.rows * rowBytes();
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
