#pragma once

#include "base/atomicfile.h"
#include "query/fields.h"
#include "query/rayreader.h"

#include <optional>
#include <span>
#include <string>

namespace dsphere::query {

/// Writes records to a NumPy or CSV file, which comes into being whole or not at all, or to standard output ("-").
class HitWriter {
  public:
    /// `count`: of the records to come, if that is known. Error (Usage) for a NumPy stream to standard output without
    /// it; Error (Failure) where the file cannot be made.
    HitWriter(const std::string& name, FileFormat format, const Record& record, std::optional<std::uint64_t> count);

    /// Whole records, one after the other.
    void write(std::span<const std::byte> records);
    /// All has been written.
    void finish();

  private:
    void put(const void* data, std::size_t bytes);
    void putHeader(std::uint64_t count);
    void writeCsv(std::span<const std::byte> records);

    FileFormat format_;
    const Record& record_;
    std::optional<AtomicFile> file_;  ///< without: standard output
    std::uint64_t written_ = 0;
};

/// The format that a name's ending says: .npy or .csv. Error (Usage) for others.
FileFormat formatOfName(const std::string& name);

}  // namespace dsphere::query
