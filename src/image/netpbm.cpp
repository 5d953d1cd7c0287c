#include "image/netpbm.h"

#include <charconv>

namespace dsphere {
namespace {

constexpr std::size_t kMaxWord = 64;  // no number is longer

bool isSpace(int c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

constexpr std::size_t kMaxComments = 65536;  // what is beyond is skipped

void readComment(InputFile& file, std::string* comments) {
    const auto keep = [&](int c) {
        if (comments && comments->size() < kMaxComments) *comments += char(c);
    };
    for (int c = file.get(); c != '\n' && c != '\r' && c != -1; c = file.get()) keep(c);
    keep('\n');
}

}  // namespace

std::string readWord(InputFile& file, std::string_view what, std::string* comments) {
    int c = file.get();
    while (isSpace(c) || c == '#') {
        if (c == '#') readComment(file, comments);
        c = file.get();
    }
    if (c == -1) file.invalid("truncated: the file ends where {} was expected", what);
    std::string word;
    for (; c != -1 && !isSpace(c) && c != '#'; c = file.get()) {
        word += char(c);
        if (word.size() > kMaxWord) file.invalid("found {:?}..., expected {}", word, what);
    }
    if (c == '#') readComment(file, comments);
    return word;
}

std::int64_t readNumber(InputFile& file, std::string_view what, std::string* comments) {
    const std::string word = readWord(file, what, comments);
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size() || number < 0)
        file.invalid("found {:?}, expected {}, a whole number", word, what);
    return number;
}

}  // namespace dsphere
