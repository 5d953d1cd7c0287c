// The files of tests/hostile, which nobody should have written: tests/hostile/cases.txt has a command for each, its
// exit code and what its message says. None crashes, hangs or takes memory that its file's length does not justify.

#include "tests/cli/fixture.h"

#include <atomic>
#include <mutex>
#include <sstream>
#include <thread>

namespace dsphere::test {
namespace {

const std::filesystem::path kHostile = DSPHERE_SOURCE_DIR "/tests/hostile";
#ifdef __SANITIZE_ADDRESS__
constexpr int kSanitizer = 4;  // so many times what the program takes without
#else
constexpr int kSanitizer = 1;
#endif
constexpr long kMostKib = kSanitizer * 200 << 10;  // a Vulkan driver, which `query` opens, is half of that
constexpr rlim_t kMostSeconds = kSanitizer * 10;   // of the processor: for a hang, a hundred times what a case takes

struct Case {
    int line = 0, code = 0;
    std::vector<std::string> arguments;
    std::string words;
};

/// Lines "CODE | ARGUMENTS | WORDS", "-" for no words; OUT in an argument is the folder for what is written.
std::vector<Case> readCases(const std::filesystem::path& out) {
    std::vector<Case> cases;
    std::ifstream file(kHostile / "cases.txt");
    std::string line;
    for (int number = 1; std::getline(file, line); ++number) {
        if (line.empty() || line[0] == '#') continue;
        const std::size_t first = line.find(" | "), second = line.find(" | ", first + 1);
        if (second == std::string::npos) {
            ADD_FAILURE() << "cases.txt:" << number << ": expected CODE | ARGUMENTS | WORDS";
            continue;
        }
        Case one{number, std::stoi(line), {}, line.substr(second + 3)};
        if (one.words == "-") one.words.clear();
        std::istringstream words(line.substr(first + 3, second - first - 3));
        for (std::string word; words >> word;) {
            if (const std::size_t at = word.find("OUT"); at != std::string::npos) word.replace(at, 3, out.string());
            one.arguments.push_back(word);
        }
        cases.push_back(std::move(one));
    }
    return cases;
}

TEST(Hostile, EveryFileEndsAsItShould) {
    const TempFolder out, cache;
    const std::vector<Case> cases = readCases(out.path());
    EXPECT_GT(cases.size(), 200u);
    std::vector<Outcome> outcomes(cases.size());
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t k; (k = next++) < cases.size();)
            outcomes[k] = launch({.arguments = cases[k].arguments,
                                  .folder = kHostile,
                                  .environment = {"XDG_CACHE_HOME=" + cache.path().string()},
                                  .limits = {{RLIMIT_CPU, kMostSeconds}}});
    };
    {
        const std::jthread other(work);
        work();
    }
    for (std::size_t k = 0; k < cases.size(); ++k) {
        const Outcome& outcome = outcomes[k];
        const std::string where = "cases.txt:" + std::to_string(cases[k].line) + ": ";
        EXPECT_EQ(outcome.code, cases[k].code) << where << outcome.err;
        EXPECT_NE(outcome.err.find(cases[k].words), std::string::npos) << where << outcome.err;
        EXPECT_LT(outcome.peak_kib, kMostKib) << where;
        for (const char c : outcome.err) EXPECT_TRUE(c == '\n' || c < 0 || c >= ' ') << where << "steers the terminal";
    }
    EXPECT_EQ(out.entries(), 0u) << "something was written";
}

/// Files that scenes of tests/hostile name.
bool isRead(const std::string& path) {
    return path.starts_with("scenes/include-") || path == "maps/overflow.img" || path.ends_with(".jpg");
}

TEST(Hostile, EveryFileHasACase) {
    const std::string cases = readBytes(kHostile / "cases.txt");
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kHostile)) {
        const std::string name = entry.path().filename().string();
        if (!entry.is_regular_file() || name == "cases.txt" || name.starts_with("good.")) continue;
        const std::string path = entry.path().lexically_relative(kHostile).string();
        EXPECT_TRUE(cases.find(path) != std::string::npos || isRead(path)) << path;
    }
}

}  // namespace
}  // namespace dsphere::test
