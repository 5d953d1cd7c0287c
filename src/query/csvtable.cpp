#include "query/csvtable.h"

#include "base/error.h"

#include <charconv>

namespace dsphere::query {

namespace {

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t"), end = text.find_last_not_of(" \t");
    return begin == std::string_view::npos ? std::string_view() : text.substr(begin, end - begin + 1);
}

void split(std::string_view line, std::vector<std::string_view>& words) {
    words.clear();
    for (std::size_t begin = 0;;) {
        const std::size_t comma = line.find(',', begin);
        words.push_back(trimmed(line.substr(begin, comma - begin)));
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
    split(line_, words_);
    names_.assign(words_.begin(), words_.end());
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
    if (word.size() > 1 && word[0] == '+') word.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
        throwInvalid("{}: the value of '{}' is '{}', expected a number", where(), names_[column], words_[column]);
    return value;
}

std::string CsvTable::where() const {
    return fmt::format("{}:{}", stream_.name(), line_number_);
}

}  // namespace dsphere::query
