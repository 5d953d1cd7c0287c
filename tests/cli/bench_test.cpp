#include "tests/cli/fixture.h"

#include <nlohmann/json.hpp>

#include <csignal>

namespace dsphere::test {
namespace {

using nlohmann::json;

class BenchTest : public CliTest {
  protected:
    /// Without --quiet a busy machine is told of on standard error.
    Outcome bench(std::vector<std::string> more) {
        std::vector<std::string> words = {"bench", "--repeats", "1", "--sample", "200"};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
};

TEST_F(BenchTest, AScene) {
    Outcome outcome = bench({"planet.pbrt", "--methods", "exact,naive,lipschitz,smooth", "--quiet"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    for (const char* part : {"planet.pbrt, 10 %, camera: 64x48 pixels", "exact", "naive 3e-6", "lipschitz", "smooth"})
        EXPECT_TRUE(holds(outcome.out, part));
    EXPECT_EQ(folder_.entries(), 2u) << "no file without being asked for";
}

TEST_F(BenchTest, EveryReport) {
    Outcome outcome = bench({"--methods", "exact,naive 3e-6", "planet.pbrt", "--csv", "a.csv", "--json-file", "a.json",
                             "--html", "a.html", "--markdown", "a.md", "--validation"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    for (const char* name : {"a.csv", "a.json", "a.html", "a.md", "a.svg"}) {
        EXPECT_TRUE(exists(name));
        EXPECT_TRUE(holds(outcome.err, std::string("wrote ") + name));
    }
    EXPECT_EQ(folder_.entries(), 7u);
    EXPECT_TRUE(holds(readBytes(path("a.md")), "](a.svg)"));
    EXPECT_TRUE(holds(readBytes(path("a.html")), "</html>"));
}

TEST_F(BenchTest, JsonAndBaseline) {
    Outcome first = bench({"planet.pbrt", "--methods", "exact", "--json"});
    EXPECT_EQ(first.code, 0) << first.err;
    json report = json::parse(first.out);
    const json& method = report.at("views").at(0).at("methods").at(0);
    EXPECT_EQ(method.at("method"), "exact");
    EXPECT_EQ(method.at("accuracy").at("wrong_verdicts"), 0);
    EXPECT_EQ(method.at("accuracy").at("rays"), 200);
    folder_.write("old.json", first.out);
    Outcome second = bench({"planet.pbrt", "--methods", "exact", "--baseline", "old.json"});
    EXPECT_EQ(second.code, 0) << second.err;
    EXPECT_TRUE(holds(second.out, "Change since 20"));
    EXPECT_TRUE(holds(second.out, "0 -> 0"));
}

TEST_F(BenchTest, TheSuite) {
    Outcome outcome = bench(
        {"--maps", "64", "--displacements", "5,50", "--views", "limb", "--methods", "exact", "--resolution", "64,36"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(holds(outcome.out, "fractal 64x32, 5 %, limb: 64x36 pixels"));
    EXPECT_TRUE(holds(outcome.out, "fractal 64x32, 50 %, limb: 64x36 pixels"));
}

TEST_F(BenchTest, Mistakes) {
    expectFailure(bench({"none.pbrt"}), 3, "none.pbrt");
    expectFailure(bench({"planet.pbrt", "none.pbrt"}), 3, "none.pbrt");
    expectFailure(bench({"--methods", "fast"}), 2, "'fast'");
    expectFailure(bench({"--views", "top"}), 2, "'top'");
    expectFailure(bench({"--maps", "63"}), 2, "63");
    expectFailure(bench({"planet.pbrt", "--views", "limb"}), 2, "--views");
    expectFailure(bench({"planet.pbrt", "--html", "nowhere/a.html"}), 1, "nowhere");
    expectFailure(bench({"planet.pbrt", "--baseline", "planet.pbrt"}), 3, "not JSON");
    expectFailure(bench({"planet.pbrt", "--baseline", "none.json"}), 3, "none.json");
    expectFailure(run({"bench", "--repeats", "0"}), 2, "--repeats");
    folder_.write("ball.pbrt", "WorldBegin\nShape \"sphere\"\n");
    expectFailure(bench({"planet.pbrt", "ball.pbrt"}), 3, "displacedsphere");
    EXPECT_EQ(folder_.entries(), 3u);
}

TEST_F(BenchTest, InterruptLeavesNoFile) {
    Launch launch{.arguments = {"bench", "--progress", "always", "--html", "a.html"}};
    launch.signal = SIGINT;
    Outcome outcome = run(launch);
    EXPECT_EQ(outcome.code, 130) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(exists("a.html"));
}

}  // namespace
}  // namespace dsphere::test
