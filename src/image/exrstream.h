#pragma once

// EXR files row by row, for pictures that memory does not hold.

#include "image/picture.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace dsphere {

/// A channel of a file.
struct ChannelKind {
    std::string name;
    bool is_float = true;  ///< else 32-bit unsigned

    bool operator==(const ChannelKind&) const = default;
};

/// Writes what writeExr() writes, byte for byte, without holding more than some rows.
class ExrWriter {
  public:
    /// Error (Failure).
    ExrWriter(const std::filesystem::path& path, const Box& data, const Box& display,
              const std::vector<ChannelKind>& channels, const Metadata& metadata);
    ~ExrWriter();

    /// The next rows, as wide as the picture, with its channels. Error (Failure).
    void write(const Image& rows);
    void write(const Box& rows, const std::vector<const Channel*>& channels);
    /// After the last rows. Error (Failure).
    void commit();

  private:
    struct State;
    std::filesystem::path path_;
    std::unique_ptr<State> state_;
};

/// Reads a file of one part.
class ExrReader {
  public:
    /// Reads and checks the header. Error (InvalidInput).
    explicit ExrReader(const std::filesystem::path& path);
    ~ExrReader();
    ExrReader(ExrReader&&) noexcept;
    ExrReader& operator=(ExrReader&&) noexcept;

    const Box& data() const { return data_; }
    const Box& display() const { return display_; }
    const std::vector<ChannelKind>& channels() const { return channels_; }
    const Metadata& metadata() const { return metadata_; }

    /// Rows y0 to y1 - 1 of the data window, all channels. Error (InvalidInput).
    Image read(int y0, int y1);

  private:
    struct State;
    std::filesystem::path path_;
    std::unique_ptr<State> state_;
    Box data_, display_;
    std::vector<ChannelKind> channels_;
    Metadata metadata_;
};

}  // namespace dsphere
