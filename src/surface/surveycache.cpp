#include "surface/surveycache.h"

#include "base/atomicfile.h"
#include "base/cachefolder.h"
#include "base/error.h"
#include "base/hash.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <type_traits>
#include <vector>

namespace dsphere {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMagic = 0x3230767275736364u;  // "dcsurv02", little-endian

fs::path folder() {
    const fs::path cache = cacheFolder();
    return cache.empty() ? cache : cache / "maps";
}

fs::path pathOf(std::uint64_t key) {
    return folder() / fmt::format("{:016x}.survey", key);
}

/// All members of a survey, in one order for both directions. `io` takes numbers and lists of numbers.
template <typename IO, typename S>
void exchange(IO& io, S& survey) {
    io(survey.north_pole);
    io(survey.south_pole);
    io(survey.least);
    io(survey.greatest);
    io(survey.second_least);
    io(survey.at_least);
    io(survey.cells.side);
    io(survey.cells.least);
    io(survey.cells.greatest);
    io(survey.blocks.shift);
    io(survey.blocks.columns);
    io(survey.blocks.rows);
    io(survey.blocks.least);
    io(survey.blocks.greatest);
    io(survey.blocks.steepest);
    io(survey.reduction);
    io(survey.reduced);
    io(survey.reduced_error);
}

class Writer {
  public:
    explicit Writer(AtomicFile& file) : file_(file) {}

    template <typename T>
    void operator()(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        put(&value, sizeof(value));
    }
    template <typename T>
    void operator()(const std::vector<T>& list) {
        (*this)(std::uint64_t(list.size()));
        put(list.data(), list.size() * sizeof(T));
    }
    std::uint64_t checksum() const { return hash_.value(); }

  private:
    void put(const void* data, std::size_t bytes) {
        hash_.bytes(data, bytes);
        file_.write(data, bytes);
    }

    AtomicFile& file_;
    Hash hash_;
};

/// Of a file whose length is known: nothing longer is ever allocated.
class Reader {
  public:
    explicit Reader(const fs::path& path) : file_(path, std::ios::binary) {
        std::error_code error;
        const std::uintmax_t size = fs::file_size(path, error);
        left_ = error ? 0 : std::uint64_t(size);
    }

    template <typename T>
    void operator()(T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        take(&value, sizeof(value));
    }
    template <typename T>
    void operator()(std::vector<T>& list) {
        std::uint64_t count = 0;
        (*this)(count);
        if (!good_ || count > left_ / sizeof(T)) {
            good_ = false;
            return;
        }
        list.resize(std::size_t(count));
        take(list.data(), list.size() * sizeof(T));
    }
    std::uint64_t checksum() const { return hash_.value(); }
    bool good() const { return good_; }
    bool atEnd() const { return left_ == 0; }

  private:
    void take(void* to, std::size_t bytes) {
        good_ = good_ && bytes <= left_ && file_.read(static_cast<char*>(to), std::streamsize(bytes));
        if (!good_) return;
        left_ -= bytes;
        hash_.bytes(to, bytes);
    }

    std::ifstream file_;
    std::uint64_t left_ = 0;
    Hash hash_;
    bool good_ = true;
};

/// The sizes that the lists' users count on.
bool fits(const Survey& survey) {
    const auto cells = std::size_t(6) * std::size_t(survey.cells.side) * std::size_t(survey.cells.side);
    const auto blocks = std::size_t(survey.blocks.columns) * std::size_t(survey.blocks.rows);
    return survey.cells.least.size() == cells && survey.cells.greatest.size() == cells &&
           survey.blocks.least.size() == blocks && survey.blocks.greatest.size() == blocks &&
           survey.blocks.steepest.size() == blocks;
}

void removeOldest() {
    struct Kept {
        fs::path path;
        std::uint64_t bytes;
        fs::file_time_type used;
    };
    std::error_code error;
    std::vector<Kept> files;
    std::uint64_t bytes = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder(), error)) {
        if (entry.path().extension() != ".survey") continue;
        files.push_back({entry.path(), std::uint64_t(entry.file_size(error)), entry.last_write_time(error)});
        bytes += files.back().bytes;
    }
    std::ranges::sort(files, {}, &Kept::used);
    for (const Kept& file : files) {
        if (bytes <= SurveyCache::kMostBytes) return;
        fs::remove(file.path, error);
        bytes -= file.bytes;
    }
}

}  // namespace

bool SurveyCache::has(std::uint64_t key) {
    std::error_code error;
    return !folder().empty() && fs::exists(pathOf(key), error);
}

std::optional<std::pair<Gaps, Survey>> SurveyCache::load(std::uint64_t key) try {
    if (folder().empty()) return {};
    Reader read(pathOf(key));
    std::uint64_t magic = 0, named = 0, unknown = 0, checksum = 0;
    std::vector<GapRun> runs;
    std::vector<int> row_source;
    Survey survey;
    read(magic);
    if (magic != kMagic) return {};
    read(named);
    read(unknown);
    read(runs);
    read(row_source);
    exchange(read, survey);
    const std::uint64_t expected = read.checksum();
    read(checksum);
    if (!read.good() || !read.atEnd() || checksum != expected || named != key || !fits(survey)) return {};
    std::error_code error;
    fs::last_write_time(pathOf(key), fs::file_time_type::clock::now(), error);  // the last use
    return std::pair(Gaps(std::move(runs), std::move(row_source), unknown), std::move(survey));
} catch (const std::bad_alloc&) {
    return {};
}

void SurveyCache::keep(std::uint64_t key, const Gaps& gaps, const Survey& survey) try {
    if (folder().empty()) return;
    std::error_code error;
    fs::create_directories(folder(), error);
    AtomicFile file(pathOf(key));
    Writer write(file);
    write(kMagic);
    write(key);
    write(gaps.unknown());
    write(gaps.runs());
    write(gaps.rowSources());
    exchange(write, survey);
    const std::uint64_t checksum = write.checksum();
    write(checksum);
    file.commit();
    removeOldest();
} catch (const Error&) {
    return;
}

}  // namespace dsphere
