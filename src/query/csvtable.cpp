#include "query/csvtable.h"

#include "base/error.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace dsphere::query {

namespace {

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t"), end = text.find_last_not_of(" \t");
    return begin == std::string_view::npos ? std::string_view() : text.substr(begin, end - begin + 1);
}

// Spreadsheets and pandas put words into quotes.
std::string_view unquoted(std::string_view word) {
    const bool quoted = word.size() >= 2 && word.front() == '"' && word.back() == '"';
    return quoted ? trimmed(word.substr(1, word.size() - 2)) : word;
}

bool isText(std::string_view line) {
    return std::ranges::none_of(line, [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) && c != '\t'; });
}

bool isNumber(std::string_view word) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size();
}

void split(std::string_view line, std::vector<std::string_view>& words) {
    words.clear();
    for (std::size_t begin = 0;;) {
        const std::size_t comma = line.find(',', begin);
        words.push_back(unquoted(trimmed(line.substr(begin, comma - begin))));
        if (comma == std::string_view::npos) return;
        begin = comma + 1;
    }
}

}  // namespace

CsvTable::CsvTable(InputStream stream, const std::string& expected) : stream_(std::move(stream)) {
    if (stream_.peek(3) == "\xef\xbb\xbf") {
        char mark[3];
        stream_.read(mark, 3);
    }
    if (!nextLine()) throwInvalid("{}: is empty; its first line names the columns: {}", stream_.name(), expected);
    if (line_.starts_with("PK"))
        throwInvalid(
            "{}: is an archive, as numpy.savez writes; expected one array, as numpy.save writes, or a CSV text",
            stream_.name());
    if (line_.find('\r') != std::string::npos)
        throwInvalid("{}: its lines end in carriage returns alone, expected line feeds", stream_.name());
    if (!isText(line_)) throwInvalid("{}: is neither a NumPy array nor a CSV text of ASCII or UTF-8", stream_.name());
    split(line_, words_);
    names_.assign(words_.begin(), words_.end());
    if (std::ranges::all_of(names_, isNumber))
        throwInvalid("{}: begins with numbers; the first line names the columns: {}", where(), expected);
    if (names_.size() == 1 && line_.find_first_of("; \t", line_.find_first_not_of(" \t")) != std::string::npos)
        throwInvalid("{}: has no commas: '{}'; commas separate columns, and a point the decimals", where(), line_);
    if (std::ranges::find(names_, "") != names_.end())
        throwInvalid("{}: a column has no name (a comma too many?): '{}'", where(), line_);
}

bool CsvTable::nextLine() {
    while (stream_.line(line_)) {
        ++line_number_;
        bytes_ += line_.size() + 1;
        const std::string_view text = trimmed(line_);
        if (!text.empty() && text[0] != '#') return true;
    }
    return false;
}

bool CsvTable::next() {
    if (!nextLine()) return false;
    split(line_, words_);
    if (words_.size() != names_.size())
        throwInvalid("{}: {} values, expected {}, one for each column", where(), words_.size(), names_.size());
    return true;
}

double CsvTable::number(std::size_t column) const {
    std::string_view word = words_[column];
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error == std::errc::result_out_of_range)
        throwInvalid("{}: the value of '{}' is '{}', which a double cannot hold", where(), names_[column],
                     words_[column]);
    if (error != std::errc() || end != word.data() + word.size())
        throwInvalid("{}: the value of '{}' is '{}', expected a number", where(), names_[column], words_[column]);
    return value;
}

std::string CsvTable::where() const {
    return fmt::format("{}:{}", stream_.name(), line_number_);
}

}  // namespace dsphere::query
