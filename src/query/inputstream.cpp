#include "query/inputstream.h"

#include "base/error.h"

#include <algorithm>
#include <filesystem>

namespace dsphere::query {

namespace {

constexpr std::size_t kAhead = 1 << 18;
constexpr std::size_t kMostLine = 1 << 20;

}  // namespace

InputStream::InputStream(const std::string& name) : name_(name == "-" ? "standard input" : name) {
    std::error_code error;
    if (name != "-" && std::filesystem::is_directory(name, error)) throwFailure("{}: is a folder", name);
    file_.reset(name == "-" ? stdin : std::fopen(name.c_str(), "rb"));
    if (!file_) throwFailure("{}: {}", name_, lastSystemError());
    if (name != "-" && std::filesystem::is_regular_file(name, error)) size_ = std::filesystem::file_size(name, error);
}

bool InputStream::fill() {
    buffer_.erase(0, begin_);
    begin_ = 0;
    const std::size_t held = buffer_.size();
    buffer_.resize(held + kAhead);
    const std::size_t count = std::fread(buffer_.data() + held, 1, kAhead, file_.get());
    if (count < kAhead && std::ferror(file_.get())) throwFailure("{}: {}", name_, lastSystemError());
    buffer_.resize(held + count);
    return count > 0;
}

std::size_t InputStream::read(void* target, std::size_t count) {
    if (count == 0) return 0;  // `target` may be null then, which fread must not be given
    const std::size_t held = buffer_.copy(static_cast<char*>(target), count, begin_);
    begin_ += held;
    if (held == count) return held;
    const std::size_t more = std::fread(static_cast<char*>(target) + held, 1, count - held, file_.get());
    if (held + more < count && std::ferror(file_.get())) throwFailure("{}: {}", name_, lastSystemError());
    return held + more;
}

std::string InputStream::peek(std::size_t count) {
    while (buffer_.size() - begin_ < count && fill()) {
    }
    return buffer_.substr(begin_, count);
}

bool InputStream::line(std::string& text) {
    std::size_t end;
    while ((end = buffer_.find('\n', begin_)) == std::string::npos) {
        if (buffer_.size() - begin_ > kMostLine)
            throwInvalid("{}: has a line of more than {} bytes, which no table of rays has", name_, kMostLine);
        if (fill()) continue;
        if (begin_ == buffer_.size()) return false;
        end = buffer_.size();
        break;
    }
    text.assign(buffer_, begin_, end - begin_);
    begin_ = std::min(end + 1, buffer_.size());
    if (!text.empty() && text.back() == '\r') text.pop_back();
    return true;
}

}  // namespace dsphere::query
