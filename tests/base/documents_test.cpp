// What the documents name exists: tests, files and links.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = DSPHERE_SOURCE_DIR;

std::string textOf(const fs::path& path) {
    std::ifstream input(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(input), {}};
}

/// Everything that the first group of `pattern` matches in a text.
std::set<std::string> allOf(const std::string& text, const std::regex& pattern) {
    std::set<std::string> found;
    for (auto at = std::sregex_iterator(text.begin(), text.end(), pattern); at != std::sregex_iterator(); ++at)
        found.insert((*at)[1]);
    return found;
}

std::vector<fs::path> documents() {
    std::vector<fs::path> paths = {kRoot / "README.md", kRoot / "CONTRIBUTING.md"};
    for (const auto& entry : fs::directory_iterator(kRoot / "docs"))
        if (entry.path().extension() == ".md") paths.push_back(entry.path());
    return paths;
}

/// "Suite.Name" of every test that is written in tests/, whose lines begin with TEST(Suite, Name), TEST_F or TEST_P.
std::set<std::string> testNames() {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / "tests")) {
        if (entry.path().extension() != ".cpp") continue;
        std::ifstream file(entry.path());
        for (std::string line; std::getline(file, line);) {
            if (line.rfind("TEST", 0) != 0) continue;
            const std::size_t open = line.find('('), comma = line.find(", "), close = line.find(')');
            if (open < comma && comma < close && close != std::string::npos)
                names.insert(line.substr(open + 1, comma - open - 1) + '.' + line.substr(comma + 2, close - comma - 2));
        }
    }
    return names;
}

TEST(Documents, TheTestsThatHoldTheClaimsExist) {
    static const std::regex named(R"(`([A-Z]\w+\.[A-Z]\w+)`)");
    const std::set<std::string> tests = testNames(), cited = allOf(textOf(kRoot / "docs/claims.md"), named);
    EXPECT_GT(cited.size(), 50u) << "docs/claims.md was not read";
    for (const std::string& name : cited) EXPECT_TRUE(tests.contains(name)) << name;
}

TEST(Documents, LinksLeadToFiles) {
    static const std::regex link(R"(\]\(([^)#:]+)(?:#[^)]*)?\))");
    std::size_t links = 0;
    for (const fs::path& document : documents())
        for (const std::string& target : allOf(textOf(document), link)) {
            ++links;
            EXPECT_TRUE(fs::exists(document.parent_path() / target)) << document.filename() << ": " << target;
        }
    EXPECT_GT(links, 30u) << "the documents were not read";
}

TEST(Documents, FilesThatAreNamedExist) {
    static const std::regex named(R"(`((?:src|shaders|tests|docs|scripts|cmake|assets)/[\w./-]+)`)");
    for (const fs::path& document : documents())
        for (const std::string& target : allOf(textOf(document), named)) {
            if (document.filename() == "README.md" && target.rfind("assets/", 0) == 0) continue;  // some are made first
            EXPECT_TRUE(fs::exists(kRoot / target)) << document.filename() << ": " << target;
        }
}

// A rule that code cites stands in docs/design.md.
TEST(Documents, RulesForDriversAreThere) {
    static const std::regex cited(R"(\b[Rr]ule ([LNG]\d+)\b)"), written(R"(\n\| ([LNG]\d+)\. )");
    const std::set<std::string> rules = allOf(textOf(kRoot / "docs/design.md"), written);
    EXPECT_GT(rules.size(), 10u);
    std::set<std::string> used;
    for (const char* top : {"src", "shaders", "cmake"})
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / top))
            if (const std::string text = entry.is_regular_file() ? textOf(entry.path()) : "";
                text.find("ule ") != std::string::npos)
                used.merge(allOf(text, cited));
    for (const std::string& rule : used) EXPECT_TRUE(rules.contains(rule)) << rule;
    for (const std::string& rule : rules) EXPECT_TRUE(used.contains(rule)) << rule << " is cited nowhere";
}

}  // namespace
