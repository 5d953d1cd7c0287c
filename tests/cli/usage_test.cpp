// --help, --version, and everything that is exit code 2.

#include "tests/cli/fixture.h"

namespace dsphere::test {
namespace {

using Words = std::vector<std::string>;

TEST_F(CliTest, Version) {
    Outcome outcome = run({"--version"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.out, "dsphere " DSPHERE_VERSION "\n");
    EXPECT_EQ(outcome.err, "");
}

TEST_F(CliTest, HelpOfEachCommand) {
    const std::vector<std::pair<Words, std::string>> cases = {{{"--help"}, "Subcommands:"},
                                                              {{"render", "--help"}, "--outfile"},
                                                              {{"verify", "-h"}, "--sample"},
                                                              {{"bench", "--help"}, "--baseline"},
                                                              {{"devices", "--help"}, "--json"}};
    for (const auto& [words, part] : cases) {
        Outcome outcome = run(words);
        EXPECT_EQ(outcome.code, 0) << words[0];
        EXPECT_TRUE(holds(outcome.out, part));
        EXPECT_TRUE(holds(outcome.out, "Exit codes:"));
        EXPECT_EQ(outcome.err, "");
    }
}

TEST_F(CliTest, HelpShowsTheWordsOfAChoiceAndNoNumbers) {
    std::string help = run({"render", "--help"}).out;
    EXPECT_TRUE(holds(help, "--marcher exact|naive|naive-shell|lipschitz\n"));
    EXPECT_TRUE(holds(help, "--progress auto|always|never|lines\n"));
}

/// A command line after the program's name, and what its complaint must hold.
struct UsageCase {
    Words words;
    std::string part;
};

void PrintTo(const UsageCase& c, std::ostream* out) {
    *out << "dsphere";
    for (const std::string& word : c.words) *out << ' ' << word;
}

class UsageTest : public CliTest, public testing::WithParamInterface<UsageCase> {};

TEST_P(UsageTest, IsExitCode2) {
    std::size_t entries = folder_.entries();
    expectFailure(run(GetParam().words), 2, GetParam().part);
    EXPECT_EQ(folder_.entries(), entries) << "a file was made";
}

Words render(Words more) {
    Words words = {"render", "planet.pbrt"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

INSTANTIATE_TEST_SUITE_P(
    CommandLines, UsageTest,
    testing::Values(
        UsageCase{{}, "subcommand is required"}, UsageCase{{"paint"}, "paint: no such command; there are view, render"},
        UsageCase{{"rendr", "planet.pbrt"}, "rendr: no such command; dsphere render?"},
        UsageCase{{"planet.pbrt"}, "planet.pbrt is a file, not a command: dsphere render planet.pbrt -o picture.png"},
        UsageCase{{"missing.pbrt"}, "dsphere view missing.pbrt shows it"},
        UsageCase{{"generate", "moon"}, "give it: dsphere generate KIND --outfile FILE"},
        UsageCase{{"--nonsense"}, "subcommand is required"}, UsageCase{{"render"}, "scene is required"},
        UsageCase{{"verify"}, "scene is required"}, UsageCase{render({"another.pbrt"}), "another.pbrt"},
        UsageCase{render({"--nonsense"}), "--nonsense"}, UsageCase{render({"-o"}), "outfile"},
        UsageCase{render({"-o", "a.jpg"}), ".png and .exr"}, UsageCase{render({"-o", "a"}), ".png and .exr"},
        UsageCase{render({"-o", "a.exr", "--aov", "depth"}), "'depth'"},
        UsageCase{render({"-o", "a.exr", "--aov", "t,,P"}), "''"},
        UsageCase{render({"-o", "a.png", "--aov", "t"}), "PNG"},
        UsageCase{render({"-o", "a.png", "--spp", "0"}), "--aov"}, UsageCase{render({"--spp", "-1"}), "--spp"},
        UsageCase{render({"--spp", "65537"}), "--spp"}, UsageCase{render({"--spp", "many"}), "--spp"},
        UsageCase{render({"--spp", "1.5"}), "--spp"}, UsageCase{render({"--seed", "x"}), "--seed"},
        UsageCase{render({"-o", ""}), "-o: its value is empty"},
        UsageCase{{"render", ""}, "render: its value is empty"},
        UsageCase{render({"--device", ""}), "--device: its value is empty"},
        UsageCase{render({"--device="}), "--device: its value is empty"},
        UsageCase{render({"--cropwindow", ""}), "--cropwindow: its value is empty"},
        UsageCase{render({"--aov", ""}), "--aov: its value is empty"},
        UsageCase{{"diff", "", "a.exr"}, "its value is empty"},
        UsageCase{render({"-o", "a.png", "--exposure", "nan"}), "--exposure: nan is not a finite number of stops"},
        UsageCase{render({"-o", "a.png", "--exposure", "-inf"}), "--exposure: -inf is not"},
        UsageCase{render({"-o", "a.exr", "--exposure", "0"}), "--exposure is for .png"},
        UsageCase{render({"-o", "a.EXR", "--exposure", "0"}), "--exposure is for .png"},
        UsageCase{render({"--exposure", "x"}), "--exposure"}, UsageCase{render({"--resolution", "64"}), "--resolution"},
        UsageCase{render({"--resolution", "64,0"}), "--resolution"},
        UsageCase{render({"--resolution", "64,1048577"}), "--resolution"},
        UsageCase{render({"--resolution", "64,x"}), "--resolution"},
        UsageCase{render({"--resolution", "64,48,3"}), "--resolution"},
        UsageCase{render({"--cropwindow", "0,1,0"}), "--cropwindow"},
        UsageCase{render({"--cropwindow", "0.5,0.5,0,1"}), "--cropwindow"},
        UsageCase{render({"--cropwindow", "0,1.1,0,1"}), "--cropwindow"},
        UsageCase{render({"--cropwindow", "0,1,0,nan"}), "--cropwindow"},
        UsageCase{render({"--marcher", "quick"}), "exact|naive|naive-shell|lipschitz"},
        UsageCase{render({"--marcher", "1"}), "--marcher"},
        UsageCase{render({"--detail", "fine"}), "expected exact or a number of pixels above 0, not fine"},
        UsageCase{render({"--detail", "0"}), "--detail"}, UsageCase{render({"--detail", "-1"}), "--detail"},
        UsageCase{render({"--detail", "nan"}), "--detail"},
        UsageCase{render({"--detail", "1", "--marcher", "naive"}), "--detail"},
        UsageCase{render({"--progress", "maybe"}), "auto|always|never"},
        UsageCase{{"verify", "planet.pbrt", "--sample", "-3"}, "--sample"},
        UsageCase{{"verify", "planet.pbrt", "--spp", "3"}, "--spp"}, UsageCase{{"devices", "extra"}, "extra"}));

TEST_F(CliTest, ChoicesAreReadInAnyCase) {
    EXPECT_EQ(run({"render", "planet.pbrt", "--quick", "--marcher", "EXACT", "--progress", "Never"}).code, 0);
}

}  // namespace
}  // namespace dsphere::test
