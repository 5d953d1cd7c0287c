#pragma once

#include "query/inputstream.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace dsphere::query {

/// A CSV file whose first line names its columns, read line by line. Empty lines and those that begin with # are
/// skipped, and spaces and quotes around values too.
class CsvTable {
  public:
    /// `expected`: which columns there may be, for messages. Error (InvalidInput) if there is no first line, or it has
    /// no names.
    CsvTable(InputStream stream, const std::string& expected);
    CsvTable(const CsvTable&) = delete;
    CsvTable& operator=(const CsvTable&) = delete;

    const std::vector<std::string>& names() const { return names_; }
    /// The next line's values, one for each column; false at the end. Error (InvalidInput) where there are more or
    /// fewer.
    bool next();
    /// Of the line that next() came to. Error (InvalidInput) where it is no number.
    double number(std::size_t column) const;
    std::string_view word(std::size_t column) const { return words_[column]; }

    /// "rays.csv:7"
    std::string where() const;
    const InputStream& stream() const { return stream_; }
    /// Bytes read so far.
    std::uint64_t bytes() const { return bytes_; }

  private:
    bool nextLine();

    InputStream stream_;
    std::string line_;
    std::uint64_t line_number_ = 0, bytes_ = 0;
    std::vector<std::string> names_;
    std::vector<std::string_view> words_;  ///< parts of line_
};

}  // namespace dsphere::query
