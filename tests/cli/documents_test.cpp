// The programs that the documents show.

#include "tests/cli/fixture.h"

#include <cstdio>
#include <sstream>

namespace dsphere::test {
namespace {

std::string outputOf(const std::string& command) {
    std::string all;
    std::FILE* pipe = popen(command.c_str(), "r");
    char part[4096];
    for (std::size_t n; pipe && (n = std::fread(part, 1, sizeof part, pipe)) > 0;) all.append(part, n);
    if (pipe) pclose(pipe);
    return all;
}

TEST_F(CliTest, ThePythonExampleReadsOurPictures) {
    const std::string python = "/usr/bin/python3";  // Debian's, where its packages are
    if (outputOf(python + " -c 'import OpenImageIO; print(1)' 2>&1") != "1\n")
        GTEST_SKIP() << "no OpenImageIO for " << python << ": install python3-openimageio";
    std::istringstream document(readBytes(DSPHERE_SOURCE_DIR "/docs/rendering.md"));
    std::string script;
    for (std::string line; std::getline(document, line);)
        if (line.starts_with("    import") || (!script.empty() && line.starts_with("    ")))
            script += line.substr(4) + "\n";
        else if (!script.empty())
            break;
    ASSERT_FALSE(script.empty());
    folder_.write("example.py", script);
    ASSERT_EQ(run({"render", "planet.pbrt", "-o", "planet.exr", "--aov", "t,id"}).code, 0);
    const std::string said = outputOf("cd " + folder_.path().string() + " && " + python + " example.py 2>&1");
    EXPECT_TRUE(holds(said, "samples a pixel: 4\n"));
    EXPECT_TRUE(holds(said, "its nearest point: 2.9") || holds(said, "its nearest point: 3.0")) << said;
}

}  // namespace
}  // namespace dsphere::test
