#include "query/hitwriter.h"

#include "base/error.h"
#include "base/parallel.h"

#include <filesystem>

namespace dsphere::query {

namespace {

constexpr std::size_t kLinesAtOnce = 4096;

}  // namespace

FileFormat formatOfName(const std::string& name) {
    const std::string ending = std::filesystem::path(name).extension().string();
    if (ending == ".npy") return FileFormat::Npy;
    if (ending == ".csv") return FileFormat::Csv;
    throw Error(ExitCode::Usage, fmt::format("{}: expected a name that ends in .npy or .csv", name));
}

HitWriter::HitWriter(const std::string& name, FileFormat format, const Record& record,
                     std::optional<std::uint64_t> count)
    : format_(format), record_(record) {
    if (name != "-") file_.emplace(name);
    if (format == FileFormat::Npy && !file_ && !count)
        throw Error(ExitCode::Usage,
                    "-o -: a NumPy array begins with its length, which a CSV file does not tell: write a file, or CSV");
    if (format == FileFormat::Npy) putHeader(count.value_or(0));
    if (format == FileFormat::Csv) {
        const std::string header = record.csvHeader();
        put(header.data(), header.size());
    }
}

void HitWriter::put(const void* data, std::size_t bytes) {
    if (bytes == 0) return;  // `data` may be null then, which fwrite must not be given
    if (file_)
        file_->write(data, bytes);
    else if (std::fwrite(data, 1, bytes, stdout) != bytes)
        throwFailure("standard output: {}", lastSystemError());
}

// Version 1.0. As long for every count, so that it can be written again once the count is known.
void HitWriter::putHeader(std::uint64_t count) {
    const std::string shape = fmt::format("({},)", count);
    std::string header = fmt::format("{{'descr': {}, 'fortran_order': False, 'shape': {}, }}{:{}}", record_.numpyType(),
                                     shape, "", 24 - shape.size());
    header.resize((10 + header.size() + 1 + 63) / 64 * 64 - 11, ' ');
    header += '\n';
    const char lead[] = {'\x93', 'N', 'U', 'M', 'P', 'Y', 1, 0, char(header.size() & 255), char(header.size() >> 8)};
    put(lead, sizeof(lead));
    put(header.data(), header.size());
}

void HitWriter::write(std::span<const std::byte> records) {
    written_ += records.size() / record_.bytes();
    if (format_ == FileFormat::Npy)
        put(records.data(), records.size());
    else
        writeCsv(records);
}

void HitWriter::writeCsv(std::span<const std::byte> records) {
    const std::size_t count = records.size() / record_.bytes();
    std::vector<std::string> parts((count + kLinesAtOnce - 1) / kLinesAtOnce);
    parallelFor(parts.size(), [&](std::size_t part) {
        for (std::size_t i = part * kLinesAtOnce; i < std::min(count, (part + 1) * kLinesAtOnce); ++i)
            record_.appendCsv(parts[part], records.data() + i * record_.bytes());
    });
    for (const std::string& part : parts) put(part.data(), part.size());
}

void HitWriter::finish() {
    if (!file_) {
        if (std::fflush(stdout) != 0) throwFailure("standard output: {}", lastSystemError());
        return;
    }
    if (format_ == FileFormat::Npy) {
        file_->seek(0);
        putHeader(written_);
    }
    file_->commit();
}

}  // namespace dsphere::query
