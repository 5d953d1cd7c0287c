// Progress and colour: for people, and never in the way of scripts.

#include "tests/cli/fixture.h"

#include <algorithm>

namespace dsphere::test {
namespace {

class TerminalTest : public CliTest {
  protected:
    /// Renders long enough for a progress line to be due.
    Outcome render(bool terminal, std::vector<std::string> options) {
        options.insert(options.begin(),
                       {"render", "planet.pbrt", "--device", "cpu", "--resolution", "640,480", "--spp", "12"});
        Outcome outcome = run(Launch{.arguments = options, .terminal = terminal});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(outcome.out, "");
        return outcome;
    }
    static bool shown(const Outcome& outcome) { return outcome.err.find(" s left") != std::string::npos; }

    std::string complaint(bool terminal, std::vector<std::string> environment) {
        Outcome outcome =
            run(Launch{.arguments = {"render", "none.pbrt"}, .environment = environment, .terminal = terminal});
        EXPECT_EQ(outcome.code, 3);
        EXPECT_TRUE(holds(outcome.err, "none.pbrt"));
        return outcome.err;
    }
};

TEST_F(TerminalTest, ProgressIsForTerminals) {
    EXPECT_TRUE(shown(render(true, {})));
    EXPECT_FALSE(shown(render(false, {})));
}

TEST_F(TerminalTest, ProgressAsAskedFor) {
    EXPECT_TRUE(shown(render(false, {"--progress", "always"})));
    EXPECT_FALSE(shown(render(true, {"--progress", "never"})));
    EXPECT_FALSE(shown(render(true, {"--quiet"})));
}

TEST_F(TerminalTest, BarsAreForTerminals) {
    EXPECT_TRUE(holds(render(true, {}).err, "\rrender: [############"));
    Outcome outcome = render(false, {"--progress", "always"});
    EXPECT_EQ(outcome.err.find('\r'), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find('#'), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("render: ", 0), 0u) << "lines, the first of progress: " << outcome.err;
    EXPECT_TRUE(holds(outcome.err, "render: 100 %  "));
    const auto lines = std::count(outcome.err.begin(), outcome.err.end(), '%');
    EXPECT_LE(lines, 12) << "one at every tenth: " << outcome.err;
}

TEST_F(TerminalTest, ColourIsForTerminals) {
    EXPECT_TRUE(holds(complaint(true, {}), "\033["));
    EXPECT_EQ(complaint(false, {}).find('\033'), std::string::npos);
}

TEST_F(TerminalTest, NoColorIsHonoured) {
    EXPECT_EQ(complaint(true, {"NO_COLOR=1"}).find('\033'), std::string::npos);
    EXPECT_TRUE(holds(complaint(true, {"NO_COLOR="}), "\033[")) << "empty means unset";
}

}  // namespace
}  // namespace dsphere::test
