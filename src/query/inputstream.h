#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

namespace dsphere::query {

/// A file, or standard input (the name "-"), read from its beginning to its end.
class InputStream {
  public:
    /// Error (Failure) with the system's reason.
    explicit InputStream(const std::string& name);

    const std::string& name() const { return name_; }  ///< for messages: "standard input" for "-"
    /// Bytes of a regular file; nothing for others.
    std::optional<std::uint64_t> size() const { return size_; }

    /// Up to `count` bytes; fewer only at the end. Error (Failure) when reading fails.
    std::size_t read(void* target, std::size_t count);
    /// The first bytes, which are read again later; fewer than `count` only if there are no more. At most 4096.
    std::string peek(std::size_t count);
    /// The next line without its end; false at the end. Error (InvalidInput) where it is longer than a MiB.
    bool line(std::string& text);

  private:
    struct Close {
        void operator()(std::FILE* file) const {
            if (file != stdin) std::fclose(file);
        }
    };
    bool fill();

    std::string name_;
    std::unique_ptr<std::FILE, Close> file_;
    std::optional<std::uint64_t> size_;
    std::string buffer_;  ///< read ahead
    std::size_t begin_ = 0;
};

}  // namespace dsphere::query
