// Scenes in files: Include, relative paths, standard input.

#include "tests/scene/support.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <sstream>

namespace dsphere {
namespace {

std::string errorOfFile(const std::filesystem::path& path) {
    try {
        parseSceneFile(path);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::InvalidInput);
        return error.what();
    }
    ADD_FAILURE() << "accepted " << path;
    return "";
}

TEST(SceneFiles, PathsStartAtTheFileTheyStandIn) {
    Folder folder;
    folder.write("parts/planet.pbrt", "Shape \"displacedsphere\" \"string displacementmap\" \"maps/a.png\"\n");
    auto path = folder.write("scene.pbrt",
                             "Film \"rgb\" \"string filename\" \"out.exr\" WorldBegin\n"
                             "Include \"parts/planet.pbrt\"\n"
                             "Shape \"displacedsphere\" \"string displacementmap\" \"b.png\"\n");
    Scene scene = parseSceneFile(path);
    ASSERT_EQ(scene.shapes.size(), 2u);
    auto map = [&](int i) { return std::get<DisplacedSphere>(scene.shapes[i].geometry).map_path; };
    EXPECT_EQ(map(0), (folder.path() / "parts/maps/a.png").string());
    EXPECT_EQ(map(1), (folder.path() / "b.png").string());
    EXPECT_EQ(scene.name, path.string());
    EXPECT_EQ(scene.film.filename, "out.exr") << "the film's name stays as written";
    EXPECT_EQ(scene.shapes[0].where.text(), (folder.path() / "parts/planet.pbrt").string() + ":1:1");
}

TEST(SceneFiles, IncludesCarryTheStateOn) {
    Folder folder;
    folder.write("open.pbrt", "AttributeBegin Translate 1 0 0");
    folder.write("close.pbrt", "AttributeEnd");
    auto path = folder.write(
        "scene.pbrt", "WorldBegin Include \"open.pbrt\" Shape \"sphere\" Include \"close.pbrt\" Shape \"sphere\"");
    Scene scene = parseSceneFile(path);
    EXPECT_EQ(scene.shapes[0].world_from_object[3], dvec4(1, 0, 0, 1));
    EXPECT_EQ(scene.shapes[1].world_from_object, dmat4(1.0));
}

TEST(SceneFiles, ErrorsNameTheIncludedFile) {
    Folder folder;
    auto part = folder.write("part.pbrt", "\n  Shpae \"sphere\"");
    auto path = folder.write("scene.pbrt", "WorldBegin Include \"part.pbrt\"");
    EXPECT_EQ(errorOfFile(path).find(part.string() + ":2:3: unknown directive \"Shpae\""), 0u) << errorOfFile(path);
}

TEST(SceneFiles, SixteenIncludesNestAndSeventeenDoNot) {
    Folder folder;
    for (int i = 1; i < 17; ++i) folder.write(std::to_string(i), "Include \"" + std::to_string(i + 1) + "\"");
    auto path = folder.write("0", "WorldBegin Include \"1\"");
    folder.write("16", "Shape \"sphere\"");
    EXPECT_EQ(parseSceneFile(path).shapes.size(), 1u);
    folder.write("16", "Include \"17\"");
    std::string error = errorOfFile(path);
    EXPECT_EQ(error.find((folder.path() / "16").string() + ":1:1: "), 0u) << error;
    EXPECT_NE(error.find("deeper than 16"), std::string::npos) << error;
}

TEST(SceneFiles, EndlessIncludesEnd) {
    Folder folder;
    auto self = folder.write("self.pbrt", "Include \"self.pbrt\"");
    EXPECT_NE(errorOfFile(self).find("deeper than 16"), std::string::npos);
    for (int i = 1; i < 12; ++i) {
        std::string next = "Include \"" + std::to_string(i + 1) + "\" ";
        folder.write(std::to_string(i), next + next + next + next);
    }
    folder.write("12", "");
    auto path = folder.write("0", "Include \"1\"");
    EXPECT_NE(errorOfFile(path).find("more than 4096 Includes"), std::string::npos);
}

TEST(SceneFiles, UnreadableFiles) {
    Folder folder;
    std::string missing = errorOfFile(folder.path() / "none.pbrt");
    EXPECT_NE(missing.find("none.pbrt: No such file or directory"), std::string::npos) << missing;
    EXPECT_NE(errorOfFile(folder.path()).find("is a directory"), std::string::npos);
    auto path = folder.write("scene.pbrt", "WorldBegin\n Include \"none.pbrt\"");
    EXPECT_EQ(errorOfFile(path).find(path.string() + ":2:10: cannot open "), 0u) << errorOfFile(path);
    path = folder.write("folder.pbrt", "Include \".\"");
    EXPECT_NE(errorOfFile(path).find(path.string() + ":1:9: "), std::string::npos);
    EXPECT_NE(errorOfFile(path).find("is a directory"), std::string::npos);
}

TEST(SceneFiles, DirectivesDoNotReachIntoAnInclude) {
    Folder folder;
    auto part = folder.write("part.pbrt", "Translate 1 2");
    auto path = folder.write("scene.pbrt", "Include \"part.pbrt\" 3 WorldBegin Shape \"sphere\"");
    EXPECT_EQ(errorOfFile(path),
              part.string() + ":1:14: expected a number, found the end of the file\n" + path.string() +
                  ":1:21: unknown directive \"3\"; supported: " + errorOf("3").substr(errorOf("3").find("Include")));
}

TEST(SceneFiles, PathsAreSoughtBesideTheFirstFileToo) {
    Folder folder;
    folder.write("parts/planet.pbrt",
                 "# get: make maps\nShape \"displacedsphere\" \"string displacementmap\" \"maps/a.png\"\n");
    const auto path = folder.write("scene.pbrt", "WorldBegin Include \"parts/planet.pbrt\"");
    const auto map = [&] { return std::get<DisplacedSphere>(parseSceneFile(path).shapes[0].geometry).map_path; };
    const std::string beside = (folder.path() / "parts/maps/a.png").string();
    EXPECT_EQ(map(), beside);
    EXPECT_EQ(parseSceneFile(path).missing.at(beside),
              "; sought at " + (folder.path() / "maps/a.png").string() + " too; to get it: make maps");
    folder.write("maps/a.png", "");
    EXPECT_EQ(map(), (folder.path() / "maps/a.png").string());
    folder.write("parts/maps/a.png", "");
    EXPECT_EQ(map(), beside) << "beside the file that names it goes first";
    EXPECT_TRUE(parseSceneFile(path).missing.empty());
}

TEST(SceneFiles, FifosAreRefusedAtOnce) {
    Folder folder;
    const std::filesystem::path fifo = folder.path() / "fifo";
    ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
    EXPECT_NE(errorOfFile(fifo).find("is a FIFO; supported: regular files"), std::string::npos);
    const auto path = folder.write("scene.pbrt", "\nInclude \"fifo\"");
    EXPECT_EQ(errorOfFile(path).find(path.string() + ":2:9: "), 0u);
    EXPECT_NE(errorOfFile("/dev/null").find("is a device"), std::string::npos);
}

TEST(SceneFiles, TheDocumentedExampleIsAScene) {
    std::ifstream page(DSPHERE_SOURCE_DIR "/docs/scene-format.md");
    std::stringstream text;
    text << page.rdbuf();
    std::string all = text.str(), fence = "```pbrt\n";
    std::size_t begin = all.find(fence), end = all.find("```\n", begin + fence.size());
    ASSERT_TRUE(begin != std::string::npos && end != std::string::npos);
    Scene scene = parse(all.substr(begin + fence.size(), end - begin - fence.size()));
    EXPECT_EQ(scene.shapes.size(), 3u);
    EXPECT_EQ(scene.lights.size(), 3u);
    EXPECT_EQ(std::get<AreaLight>(scene.lights[2]).shape, 1) << "the lamp";
}

TEST(SceneFiles, ThePagesErrorIsTheParsersOwn) {
    EXPECT_NE(errorOf("WorldBegin Shape \"cone\"")
                  .find("unknown shape \"cone\"; supported: displacedsphere, sphere, disk, trianglemesh, bilinearmesh"),
              std::string::npos);
}

TEST(SceneFiles, TheAssetsAreScenes) {
    for (const auto& entry : std::filesystem::directory_iterator(DSPHERE_SOURCE_DIR "/assets/scenes")) {
        if (entry.path().extension() != ".pbrt") continue;
        EXPECT_NO_THROW(parseSceneFile(entry.path())) << entry.path();
    }
}

/// Standard input is a file of that text for its lifetime.
class StandardInput {
  public:
    explicit StandardInput(const std::filesystem::path& file) : before_(dup(STDIN_FILENO)) {
        const int input = open(file.c_str(), O_RDONLY);
        dup2(input, STDIN_FILENO);
        close(input);
    }
    ~StandardInput() {
        dup2(before_, STDIN_FILENO);
        close(before_);
    }

  private:
    int before_;
};

TEST(SceneFiles, DashIsStandardInput) {
    Folder folder;
    {
        StandardInput input(
            folder.write("a", "WorldBegin Shape \"displacedsphere\" \"string displacementmap\" \"a.png\""));
        Scene scene = parseSceneFile("-");
        EXPECT_EQ(scene.name, "-");
        EXPECT_EQ(std::get<DisplacedSphere>(scene.shapes[0].geometry).map_path, "a.png");
    }
    StandardInput input(folder.write("b", "WorldBegin\nNonsense"));
    EXPECT_EQ(errorOfFile("-").find("-:2:1: unknown directive \"Nonsense\""), 0u);
}

}  // namespace
}  // namespace dsphere
