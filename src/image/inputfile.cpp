#include "image/inputfile.h"

#include <system_error>

namespace dsphere {

InputFile::InputFile(const std::filesystem::path& path) : name_(path.string()) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (error) invalid("cannot be read: {}", error.message());
    if (std::filesystem::is_directory(status)) invalid("cannot be read: it is a folder, expected a map file");
    if (!std::filesystem::is_regular_file(status)) invalid("cannot be read: it is not a regular file");
    size_ = std::filesystem::file_size(path, error);
    if (error) invalid("cannot be read: {}", error.message());
    if (!buffer_.open(path, std::ios::in | std::ios::binary)) invalid("cannot be read: {}", lastSystemError());
}

void InputFile::read(void* to, std::size_t count) {
    const std::streamsize got = buffer_.sgetn(static_cast<char*>(to), std::streamsize(count));
    position_ += std::uint64_t(got);
    if (got != std::streamsize(count))
        invalid("ends after {} bytes, where {} more were expected", position_, count - std::size_t(got));
}

int InputFile::get() {
    const int byte = buffer_.sbumpc();
    if (byte == std::filebuf::traits_type::eof()) return -1;
    ++position_;
    return byte;
}

void InputFile::seek(std::uint64_t position) {
    if (position == position_) return;
    if (position > size_) invalid("has {} bytes, where {} were expected", size_, position);
    const std::streampos wanted(static_cast<std::streamoff>(position));
    if (buffer_.pubseekpos(wanted, std::ios::in) != wanted) invalid("cannot be read: {}", lastSystemError());
    position_ = position;
}

}  // namespace dsphere
