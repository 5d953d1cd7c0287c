#include "geo/netcdfcheck.h"

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "image/inputfile.h"

// The header's grammar is in the NetCDF user's guide, appendix "File format specifications".

namespace dsphere::geo {
namespace {

class Header {
  public:
    explicit Header(InputFile& file) : file_(file) {
        std::array<char, 4> magic{};
        file.read(magic.data(), magic.size());
        count_bytes_ = magic[3] == 5 ? 8 : 4;
        offset_bytes_ = magic[3] == 1 ? 4 : 8;
    }

    std::uint64_t count() { return number(count_bytes_); }
    std::uint64_t offset() { return number(offset_bytes_); }
    std::uint64_t word() { return number(4); }
    void skip(std::uint64_t bytes) {
        if (bytes > file_.remaining()) file_.invalid("netCDF: truncated or damaged: its header is cut off");
        file_.seek(file_.size() - file_.remaining() + bytes);
    }
    void skipName() { skip(padded(count())); }
    void skipAttributes() {
        // BYTE CHAR SHORT INT FLOAT DOUBLE UBYTE USHORT UINT INT64 UINT64
        constexpr std::array<std::uint64_t, 12> kBytes{0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
        word();
        for (std::uint64_t left = count(); left > 0; --left) {
            skipName();
            const std::uint64_t type = word(), values = count();
            if (type >= kBytes.size() || values > file_.size())
                file_.invalid("netCDF: damaged: an attribute has {} values of type {}", values, type);
            skip(padded(values * kBytes[std::size_t(type)]));
        }
    }

  private:
    static std::uint64_t padded(std::uint64_t bytes) {
        constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max() - 3;
        return bytes > kMost ? bytes : (bytes + 3) / 4 * 4;
    }
    std::uint64_t number(std::size_t bytes) {
        std::uint64_t value = 0;
        for (; bytes > 0; --bytes) {
            const int byte = file_.get();
            if (byte < 0) file_.invalid("netCDF: truncated or damaged: its header is cut off");
            value = value << 8 | std::uint64_t(byte);
        }
        return value;
    }

    InputFile& file_;
    std::size_t count_bytes_ = 4, offset_bytes_ = 4;
};

}  // namespace

void checkClassicNetCdf(const std::filesystem::path& path) {
    InputFile file(path);
    if (file.get() != 'C') return;
    file.rewind();
    Header header(file);
    header.count();  // of records
    header.word();
    for (std::uint64_t dimensions = header.count(); dimensions > 0; --dimensions) {
        header.skipName();
        header.count();
    }
    header.skipAttributes();
    header.word();
    for (std::uint64_t variables = header.count(); variables > 0; --variables) {
        header.skipName();
        for (std::uint64_t dimensions = header.count(); dimensions > 0; --dimensions) header.count();
        header.skipAttributes();
        header.word();
        // A size is counted in whole words, the last of which need not be there.
        const std::uint64_t bytes = header.count(), begin = header.offset();
        if (begin > file.size() || bytes > file.size() - begin + 3)
            file.invalid("netCDF: truncated: a variable has {} bytes at byte {}, the file {} bytes", bytes, begin,
                         file.size());
    }
}

}  // namespace dsphere::geo
