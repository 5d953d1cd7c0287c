// dsphere query, and the recipes of docs/query.md.

#include "image/picture.h"
#include "tests/cli/fixture.h"

#include <nlohmann/json.hpp>

#include <csignal>
#include <cstdlib>

namespace dsphere::test {
namespace {

class QueryCli : public CliTest {
  protected:
    QueryCli() {
        folder_.write("rays.csv",
                      "ox,oy,oz,dx,dy,dz\n0,0,4,0,0,-1\n0,0,4,0,0,1\n0,0,4,0,0,0\n0.5,0,0,1,0,0\n1.5,0.1,4,0,0,-2\n");
    }

    Outcome query(std::vector<std::string> more) {
        std::vector<std::string> arguments = {"query", "planet.pbrt"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(std::move(arguments));
    }
};

TEST_F(QueryCli, AnswersComeInTheRaysOrder) {
    Outcome outcome = query({"rays.csv", "-o", "-", "--fields", "status,id,u,lit", "--quiet"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out, "status,id,u,lit\n1,1,0.5,1\n0,0,nan,0\n255,0,nan,0\n2,1,0.75,0\n1,2,0.25,1\n");
    outcome = query({"rays.csv", "-o", "-", "--any", "--quiet"});
    EXPECT_EQ(outcome.out, "status\n1\n0\n255\n2\n1\n");
}

TEST_F(QueryCli, StandardInputAndOutput) {
    const Outcome outcome = run(Launch{.arguments = {"query", "planet.pbrt", "-", "-o", "-", "--fields", "status"},
                                       .input = "from_lat,from_lon,from_alt,to_lat,to_lon,to_alt\n0,0,1,0,180,1\n"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "status\n1\n");
    EXPECT_TRUE(holds(outcome.err, "1 rays on "));
}

TEST_F(QueryCli, AnArrayIsWrittenWhole) {
    const Outcome outcome = query({"rays.csv", "-o", "hits.npy", "--json"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json["rays"], 5);
    EXPECT_EQ(json["hits"], 2);
    EXPECT_EQ(json["inside"], 1);
    EXPECT_EQ(json["invalid"], 1);
    EXPECT_TRUE(
        holds(readBytes(path("hits.npy")),
              "{'descr': [('status', '|u1'), ('t', '<f8'), ('P', '<f8', (3,)), ('N', '<f4', (3,)), ('u', '<f8'), "
              "('v', '<f8'), ('lat', '<f8'), ('lon', '<f8'), ('height', '<f8'), ('metres', '<f8'), ('id', "
              "'<u4'), ('lit', '<u4')], 'fortran_order': False, 'shape': (5,), }"));
}

TEST_F(QueryCli, AMapsOptionsAreThoseOfRender) {
    folder_.write("flat.pgm", "P2 2 1 255\n7 7\n");
    const std::vector<std::string> arguments = {"query", "flat.pgm", "rays.csv", "-o",
                                                "-",     "--fields", "status,t", "--quiet"};
    std::vector<std::string> with = arguments;
    for (const char* option : {"--radius=2", "--heightmin=0", "--heightmax=14", "--maxdispl=50"})
        with.push_back(option);
    EXPECT_EQ(run(with).out, "status,t\n1,1.5\n0,nan\n255,nan\n2,0\n1,1.0012507822280912\n");
    with[1] = "planet.pbrt";
    EXPECT_EQ(run(with).code, 2);
}

TEST_F(QueryCli, CertifyAddsTheProof) {
    const Outcome outcome = query({"rays.csv", "-o", "hits.csv", "--certify"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(holds(outcome.out, "wrong verdicts"));
    const std::string hits = readBytes(path("hits.csv"));
    EXPECT_TRUE(holds(hits, ",t_low,t_high,tangent\n"));
}

TEST_F(QueryCli, MistakesAreNamed) {
    folder_.write("wrong.csv", "ox,oy\n1,2\n");
    folder_.write("short.npy", "\x93NUMPY\x01");
    expectFailure(query({"wrong.csv", "-o", "hits.csv"}), 3, "lack 'oz'");
    expectFailure(query({"short.npy", "-o", "hits.csv"}), 3, "ends within its NumPy header");
    expectFailure(query({"none.npy", "-o", "hits.csv"}), 1, "none.npy");
    expectFailure(query({"rays.csv", "-o", "hits.txt"}), 2, ".npy or .csv");
    expectFailure(query({"rays.csv", "-o", "rays.csv"}), 2, "would replace");
    expectFailure(query({"rays.csv", "-o", "hits.csv", "--fields", "x"}), 2, "unknown field 'x'");
    expectFailure(query({"rays.csv", "-o", "hits.csv", "--fields", "t_low"}), 2, "needs --certify");
    expectFailure(query({"rays.csv", "-o", "hits.csv", "--any", "--fields", "t"}), 2, "the status alone");
    expectFailure(query({"rays.csv", "-o", "-", "--output-format", "npy"}), 2, "begins with its length");
    expectFailure(query({"rays.csv"}), 2, "--outfile");
    expectFailure(run({"query", "-", "-", "-o", "hits.csv"}), 2, "standard input");
    EXPECT_FALSE(exists("hits.csv"));
    EXPECT_EQ(folder_.entries(), 5u);
}

TEST_F(QueryCli, CtrlCLeavesTheOldAnswers) {
    std::string many = "ox,oy,oz,dx,dy,dz\n";
    for (int i = 0; i < 2'000'000; ++i) many += "0,0,4,0,0,-1\n";
    folder_.write("many.csv", many);
    folder_.write("hits.csv", "old");
    Launch launch{.arguments = {"query", "planet.pbrt", "many.csv", "-o", "hits.csv", "--progress", "always"}};
    launch.signal = SIGINT;
    EXPECT_EQ(run(launch).code, 130);
    EXPECT_EQ(readBytes(path("hits.csv")), "old");
    EXPECT_EQ(folder_.entries(), 5u);
}

TEST_F(QueryCli, BakeWritesPlanesByName) {
    const Outcome outcome = run({"bake", "planet.pbrt", "-o", "maps.exr", "--quantities", "height,lit,normal,sky",
                                 "--sun", "0,0", "--sun=90,10,2", "--samples", "8", "--resolution", "32,16"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const Image image = readExr(path("maps.exr"));
    EXPECT_EQ(image.data.width(), 32);
    for (const char* name : {"height", "lit.0", "lit.1", "normal.X", "normal.Y", "normal.Z", "sky"})
        EXPECT_TRUE(image.find(name)) << name;
    EXPECT_GT(image.at("lit.0").floats()[8 * 32 + 16], 0.0f) << "the sun stands above it";
    EXPECT_EQ(run({"bake", "map.pgm", "-o", "slope.png", "--quantities", "slope", "--quiet"}).code, 0);
    EXPECT_TRUE(exists("slope.png"));
}

TEST_F(QueryCli, BakeTakesSunsFromAFile) {
    folder_.write("suns.csv", "lon,lat,radius,name\n0,1.5,0.27,dawn\n90,1.5,0.27,noon\n");
    const Outcome outcome = run({"bake", "planet.pbrt", "-o", "lit.exr", "--quantities", "lit,colour", "--suns",
                                 "suns.csv", "--samples", "4", "--resolution", "16,8", "--quiet"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const Image image = readExr(path("lit.exr"));
    for (const char* name : {"lit.dawn", "lit.noon", "R", "G", "B"}) EXPECT_TRUE(image.find(name)) << name;
    expectFailure(run({"bake", "planet.pbrt", "-o", "suns.csv.exr", "--quantities", "lit", "--suns", "none.csv"}), 1,
                  "none.csv");
    expectFailure(
        run({"bake", "planet.pbrt", "-o", "a.exr", "--quantities", "lit", "--suns", "suns.csv", "--sun", "1,2"}), 2,
        "goes without --sun");
    expectFailure(run({"bake", "planet.pbrt", "-o", "a.exr", "--quantities", "slope", "--suns", "suns.csv"}), 2,
                  "for --quantities lit");
}

TEST_F(QueryCli, BakesMistakesAreNamed) {
    const auto bake = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"bake", "planet.pbrt"});
        return run(std::move(more));
    };
    expectFailure(bake({"-o", "a.exr", "--quantities", "shade"}), 2, "unknown 'shade', expected some of lit,normal");
    expectFailure(bake({"-o", "a.exr", "--quantities", "lit"}), 2, "needs a --sun");
    expectFailure(bake({"-o", "a.exr", "--quantities", "lit", "--sun", "1"}), 2, "expected LON,LAT");
    expectFailure(bake({"-o", "a.exr", "--quantities", "lit", "--sun", "1,x"}), 2, "'x' is no number");
    expectFailure(bake({"-o", "a.exr", "--quantities", "lit", "--sun", "1,91"}), 2, "a latitude");
    expectFailure(bake({"-o", "a.png", "--quantities", "normal"}), 2, "a PNG holds one plane");
    expectFailure(bake({"-o", "a.jpg", "--quantities", "slope"}), 2, "ends in .exr, .tif or .png");
    expectFailure(bake({"-o", "a.exr", "--quantities", "slope", "--bounds", "10,0,0,10"}), 2, "expected W < E");
    EXPECT_FALSE(exists("a.exr"));
}

// The blocks ```python of a page, one after the other.
std::string pythonBlocks(const std::string& page) {
    std::string code;
    for (std::size_t at = 0; (at = page.find("```python\n", at)) != std::string::npos;) {
        at += 10;
        const std::size_t end = page.find("```", at);
        code += page.substr(at, end - at) + "\n";
        at = end;
    }
    return code;
}

TEST_F(QueryCli, TheRecipesRun) {
    folder_.write("moon.pbrt",
                  "WorldBegin Shape \"displacedsphere\" \"string displacementmap\" \"map.pgm\" \"float maxdispl\" 1");
    const std::string script =
        "import os\nos.environ['PATH'] = '" + std::filesystem::path(DSPHERE_PROGRAM).parent_path().string() +
        ":' + os.environ['PATH']\nos.environ['XDG_CACHE_HOME'] = '" + cache_.path().string() + "'\n";
    const std::string blocks = pythonBlocks(readBytes(std::filesystem::path(DSPHERE_SOURCE_DIR) / "docs/query.md"));
    ASSERT_GT(blocks.size(), 1000u);
    folder_.write("recipes.py", script + blocks);
    // Debian's own Python, which Debian's NumPy belongs to.
    const std::string command = "cd '" + folder_.path().string() + "' && /usr/bin/python3 recipes.py >log 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << readBytes(path("log"));
    const std::string log = readBytes(path("log"));
    EXPECT_TRUE(holds(log, "hidden: ["));
    EXPECT_TRUE(holds(log, "share of the month"));
}

}  // namespace
}  // namespace dsphere::test
