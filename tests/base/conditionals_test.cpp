// Variants of a shader are choices of folders: no file of shaders/ but the layouts, which C++ reads too, may have
// conditionals of the preprocessor.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>

namespace {

namespace fs = std::filesystem;

TEST(Shaders, HaveNoPreprocessorConditionals) {
    const std::regex conditional("^\\s*#\\s*(if|el)");
    int files = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(DSPHERE_SOURCE_DIR "/shaders")) {
        if (!entry.is_regular_file() || entry.path().extension() == ".h") continue;
        ++files;
        std::ifstream in(entry.path());
        std::string line;
        for (int number = 1; std::getline(in, line); ++number)
            if (std::regex_search(line, conditional)) ADD_FAILURE() << entry.path() << ":" << number << ": " << line;
    }
    EXPECT_GT(files, 30);
}

}  // namespace
