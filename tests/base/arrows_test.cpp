// Holds the include arrows between the folders of src/, the homes of the outside libraries, and the length of files.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct SourceFile {
    std::string path;  // from the project's root, with '/': "src/gpu/device.h"
    std::string text;
};

using Folders = std::set<std::string, std::less<>>;

using Arrows = std::map<std::string, Folders, std::less<>>;

/// The cells of a Markdown table's row, without the spaces about them.
std::vector<std::string> cellsOf(const std::string& row) {
    std::vector<std::string> cells;
    std::istringstream rest(row.substr(1));
    for (std::string cell; std::getline(rest, cell, '|');) {
        const std::size_t begin = cell.find_first_not_of(' '), end = cell.find_last_not_of(' ');
        cells.push_back(begin == std::string::npos ? "" : cell.substr(begin, end - begin + 1));
    }
    return cells;
}

/// What each folder of src/ may include besides itself, as the table of docs/design.md says: rows of the form
/// "| `src/NAME` | what it holds | folder, folder |", the last cell "everything" for a folder without limits.
Arrows readArrows() {
    Arrows arrows;
    std::vector<std::string> unlimited;
    std::ifstream document(fs::path(DSPHERE_SOURCE_DIR) / "docs/design.md");
    for (std::string line; std::getline(document, line);) {
        if (line.rfind("| `src/", 0) != 0) continue;
        const std::vector<std::string> cells = cellsOf(line);
        const std::string folder = cells.at(0).substr(5, cells[0].size() - 6);
        Folders& allowed = arrows[folder];
        std::istringstream names(cells.at(2));
        for (std::string name; std::getline(names >> std::ws, name, ',');) allowed.insert(name);
        if (allowed.contains("everything")) unlimited.push_back(folder);
    }
    for (const std::string& folder : unlimited)
        for (const auto& [name, ignored] : arrows) arrows[folder].insert(name);
    return arrows;
}

const Arrows kArrows = readArrows();

// Outside libraries by the start of their headers' names in lower case, and the folders of src/ that may know them.
struct Library {
    std::string_view header_start;
    Folders homes;
};
const std::vector<Library> kLibraries = {
    {"vulkan/", {"gpu", "render", "viewer"}},
    {"volk", {"gpu", "render", "viewer"}},
    {"glfw/", {"viewer"}},
    {"imgui", {"viewer"}},
    {"backends/imgui", {"viewer"}},
    {"openexr/", {"image"}},
    {"imf", {"image"}},
    {"imath", {"image"}},
    {"iex", {"image"}},
    {"stb", {"image"}},
    {"png", {"image"}},
    {"zlib", {"image"}},
    {"tiff", {"image"}},
    {"jpeg", {"image"}},
    {"embree", {"bench"}},
    {"gdal", {"geo"}},
    {"cpl_", {"geo"}},
    {"ogr", {"geo"}},
};

constexpr int kMaxLines = 400;

struct Include {
    int line;
    bool quoted;
    std::string name;
};

// `#include "x"` or `#include <x>` on a line, with any spacing.
std::optional<Include> includeOn(std::string line, int number) {
    line.erase(std::remove_if(line.begin(), line.end(), [](unsigned char c) { return std::isspace(c); }), line.end());
    constexpr std::string_view kDirective = "#include";
    if (line.rfind(kDirective, 0) != 0 || line.size() <= kDirective.size()) return {};
    char open = line[kDirective.size()], close = open == '<' ? '>' : '"';
    std::size_t begin = kDirective.size() + 1, end = line.find(close, begin);
    if ((open != '<' && open != '"') || end == std::string::npos) return Include{number, true, line};
    return Include{number, open == '"', line.substr(begin, end - begin)};
}

std::vector<Include> includesOf(const SourceFile& file) {
    std::vector<Include> includes;
    std::istringstream lines(file.text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number)
        if (auto include = includeOn(line, number)) includes.push_back(*include);
    return includes;
}

std::string firstFolder(const std::string& path) {
    return path.substr(0, path.find('/'));
}

bool endsWith(std::string_view text, std::string_view end) {
    return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

// Why a file of src/`folder` may not include this; empty when it may.
std::string projectFault(const std::string& folder, const std::string& name) {
    std::string target = firstFolder(name);
    if (target == "shaders")
        return folder == "render" || folder == "host" || folder == "viewer"
                   ? ""
                   : "only render, host and viewer include shaders/";
    if (!kArrows.contains(target) || name.find('/') == std::string::npos)
        return "a project header is named \"folder/file.h\", its folder one of src/";
    if (target == folder || kArrows.at(folder).contains(target)) return "";
    return folder + " may not include " + target;
}

std::string libraryFault(const std::string& folder, std::string name) {
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
    for (const Library& library : kLibraries)
        if (name.rfind(library.header_start, 0) == 0 && !library.homes.contains(folder))
            return "this library is not for src/" + folder;
    return "";
}

bool isCode(std::string_view path) {
    return endsWith(path, ".h") || endsWith(path, ".cpp");
}

// "path:line: what is wrong" for each breach in one file.
std::vector<std::string> faultsOf(const SourceFile& file) {
    std::vector<std::string> faults;
    auto lines = std::count(file.text.begin(), file.text.end(), '\n');
    if (lines > kMaxLines) faults.push_back(file.path + ":" + std::to_string(lines) + ": over 400 lines");
    if (file.path.rfind("src/", 0) != 0 || !isCode(file.path)) return faults;
    std::string folder = firstFolder(file.path.substr(4));
    if (!kArrows.contains(folder)) return {file.path + ":1: src/" + folder + " is not in the table of docs/design.md"};
    for (const Include& include : includesOf(file)) {
        // <gpu/device.h> reaches the same file as "gpu/device.h".
        bool ours =
            include.quoted || kArrows.contains(firstFolder(include.name)) || firstFolder(include.name) == "shaders";
        std::string fault = ours ? projectFault(folder, include.name) : libraryFault(folder, include.name);
        if (!fault.empty())
            faults.push_back(file.path + ":" + std::to_string(include.line) + ": " + include.name + ": " + fault);
    }
    return faults;
}

std::vector<SourceFile> readTree() {
    std::vector<SourceFile> files;
    fs::path root = DSPHERE_SOURCE_DIR;
    const std::set<std::string> text_types = {".h", ".cpp", ".glsl", ".comp", ".txt", ".cmake", ".py", ".sh"};
    for (const char* top : {"src", "shaders", "tests"})
        for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
            if (!entry.is_regular_file() || !text_types.contains(entry.path().extension().string())) continue;
            std::ifstream input(entry.path(), std::ios::binary);
            std::string text{std::istreambuf_iterator<char>(input), {}};
            files.push_back({fs::relative(entry.path(), root).generic_string(), std::move(text)});
        }
    return files;
}

TEST(Arrows, HoldInTheTree) {
    Folders seen;
    for (const SourceFile& file : readTree()) {
        seen.insert(file.path);
        for (const std::string& fault : faultsOf(file)) ADD_FAILURE() << fault;
    }
    EXPECT_TRUE(seen.contains("src/scene/parser.cpp") && seen.contains("tests/base/arrows_test.cpp"));
    EXPECT_GT(seen.size(), 20u) << "the tree was not read";
}

// The includes of the real tree are found at all: parser.cpp's own header is one.
TEST(Arrows, SeeTheIncludesOfTheTree) {
    for (const SourceFile& file : readTree()) {
        if (file.path != "src/scene/parser.cpp") continue;
        auto includes = includesOf(file);
        EXPECT_TRUE(std::any_of(includes.begin(), includes.end(), [](auto& i) { return i.name == "scene/parser.h"; }));
    }
}

std::size_t faultCount(const std::string& path, const std::string& text) {
    return faultsOf({path, text}).size();
}

TEST(ArrowsSelfTest, AcceptWhatIsAllowed) {
    EXPECT_EQ(faultCount("src/gpu/x.cpp", "#include \"gpu/x.h\"\n#include \"base/error.h\"\n#include <volk.h>\n"), 0u);
    EXPECT_EQ(faultCount("src/render/x.cpp", "#include \"shaders/layout.h\"\n#include \"shaders/render.spv.h\"\n"), 0u);
    EXPECT_EQ(faultCount("src/image/x.cpp", "#include <OpenEXR/ImfHeader.h>\n#include <stb/stb_image.h>\n"), 0u);
    EXPECT_EQ(faultCount("src/viewer/x.cpp", "#include <GLFW/glfw3.h>\n#include <vulkan/vulkan.h>\n"), 0u);
    EXPECT_EQ(faultCount("src/cli/x.cpp", "#include \"reference/x.h\"\n#include \"gpu/device.h\"\n"), 0u);
    EXPECT_EQ(faultCount("src/base/x.cpp", "#include <string>\n// \"gpu/device.h\" is not included\n"), 0u);
    EXPECT_EQ(faultCount("tests/gpu/x.cpp", "#include \"gpu/x.h\"\n#include \"shaders/layout.h\"\n#include <volk.h>\n"),
              0u);
}

// The table was read: some of its rows, and nothing but folders that exist.
TEST(Arrows, AreReadFromTheTable) {
    EXPECT_EQ(kArrows.at("base"), Folders{});
    EXPECT_EQ(kArrows.at("reference"), (Folders{"base", "scene", "surface"}));
    EXPECT_TRUE(kArrows.at("cli").contains("viewer"));
    for (const auto& [folder, allowed] : kArrows) {
        EXPECT_TRUE(fs::is_directory(fs::path(DSPHERE_SOURCE_DIR) / "src" / folder)) << folder;
        for (const std::string& target : allowed)
            EXPECT_TRUE(kArrows.contains(target) || target == "everything") << folder << " -> " << target;
    }
}

TEST(Arrows, RunOneWayOnly) {
    for (const auto& [folder, allowed] : kArrows)
        for (const std::string& target : allowed)
            if (target != folder && kArrows.contains(target)) {
                EXPECT_FALSE(kArrows.at(target).contains(folder)) << folder << " and " << target;
            }
}

TEST(ArrowsSelfTest, RefuseEveryArrowThatIsNotDrawn) {
    for (const auto& [folder, allowed] : kArrows)
        for (const auto& [target, ignored] : kArrows) {
            bool fine = target == folder || allowed.contains(target);
            EXPECT_EQ(faultCount("src/" + folder + "/x.h", "#include \"" + target + "/y.h\"\n"), fine ? 0u : 1u)
                << folder << " -> " << target;
        }
    EXPECT_FALSE(kArrows.at("gpu").contains("reference") || kArrows.at("reference").contains("gpu"));
}

TEST(ArrowsSelfTest, NameTheFileAndTheLine) {
    std::vector<std::string> faults =
        faultsOf({"src/gpu/fake.cpp", "#include \"gpu/fake.h\"\n\n  #  include  \"reference/hit.h\" // why\n"});
    EXPECT_EQ(faults, (std::vector<std::string>{"src/gpu/fake.cpp:3: reference/hit.h: gpu may not include reference"}));
}

TEST(ArrowsSelfTest, RefuseWaysAround) {
    EXPECT_EQ(faultCount("src/gpu/x.cpp", "#include <reference/hit.h>\n"), 1u);
    EXPECT_EQ(faultCount("src/gpu/x.cpp", "#include \"../reference/hit.h\"\n"), 1u);
    EXPECT_EQ(faultCount("src/gpu/x.cpp", "#include \"device.h\"\n"), 1u);
    EXPECT_EQ(faultCount("src/gpu/deep/x.cpp", "#include \"reference/hit.h\"\n"), 1u);
    EXPECT_EQ(faultCount("src/gpu/x.cpp", "#include HEADER\n"), 1u);
    EXPECT_EQ(faultCount("src/new/x.cpp", ""), 1u) << "a folder that the test does not know";
}

TEST(ArrowsSelfTest, KeepLibrariesAtHome) {
    for (std::string header :
         {"vulkan/vulkan.h", "volk.h", "GLFW/glfw3.h", "OpenEXR/ImfHeader.h", "ImfHeader.h", "Imath/ImathBox.h",
          "ImathBox.h", "imgui.h", "backends/imgui_impl_glfw.h", "stb_image.h", "stb/stb_image_write.h"})
        EXPECT_EQ(faultCount("src/surface/x.cpp", "#include <" + header + ">\n"), 1u) << header;
    EXPECT_EQ(faultCount("src/render/x.cpp", "#include <GLFW/glfw3.h>\n"), 1u);
    EXPECT_EQ(faultCount("src/gpu/x.cpp", "#include \"shaders/layout.h\"\n"), 1u);
    EXPECT_EQ(faultCount("src/cli/x.cpp", "#include \"shaders/layout.h\"\n"), 1u);
}

TEST(ArrowsSelfTest, CountLines) {
    for (std::string path : {"src/base/x.cpp", "shaders/x.glsl", "tests/x.cpp"}) {
        EXPECT_EQ(faultCount(path, std::string(400, '\n')), 0u) << path;
        EXPECT_EQ(faultCount(path, std::string(401, '\n')), 1u) << path;
    }
}

}  // namespace
