#include "image/netpbm.h"

#include <charconv>

namespace dsphere {
namespace {

constexpr std::size_t kMaxWord = 64;  // no number is longer

bool isSpace(int c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

void skipComment(InputFile& file) {
    for (int c = file.get(); c != '\n' && c != '\r' && c != -1;) c = file.get();
}

}  // namespace

std::string readWord(InputFile& file, std::string_view what) {
    int c = file.get();
    while (isSpace(c) || c == '#') {
        if (c == '#') skipComment(file);
        c = file.get();
    }
    if (c == -1) file.invalid("truncated: the file ends where {} was expected", what);
    std::string word;
    for (; c != -1 && !isSpace(c) && c != '#'; c = file.get()) {
        word += char(c);
        if (word.size() > kMaxWord) file.invalid("found {:?}..., expected {}", word, what);
    }
    if (c == '#') skipComment(file);
    return word;
}

std::int64_t readNumber(InputFile& file, std::string_view what) {
    const std::string word = readWord(file, what);
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size() || number < 0)
        file.invalid("found {:?}, expected {}, a whole number", word, what);
    return number;
}

}  // namespace dsphere
