// Parts of a picture, and merge: bit for bit the undivided render, or a message that says what is wrong.

#include "image/picture.h"
#include "tests/cli/fixture.h"
#include "tests/cli/pictures.h"

#include <csignal>

namespace dsphere::test {
namespace {

using Words = std::vector<std::string>;

class MergeTest : public CliTest {
  protected:
    Outcome renderWith(Words options) {
        options.insert(options.begin(), {"render", "planet.pbrt"});
        return run(options);
    }
    void render(Words options) {
        const Outcome outcome = renderWith(std::move(options));
        ASSERT_EQ(outcome.code, 0) << outcome.err;
    }
    Outcome merge(Words parts, const std::string& out = "merged.exr") {
        parts.insert(parts.begin(), {"merge", "-o", out});
        return run(parts);
    }
    void expectRefused(Words parts, const std::string& part) {
        expectFailure(merge(std::move(parts)), 3, part);
        EXPECT_FALSE(exists("merged.exr"));
    }
    /// All but the time that it took.
    void expectSamePicture(const std::string& a, const std::string& b) const {
        const Image one = readExr(path(a)), other = readExr(path(b));
        EXPECT_EQ(one.data, other.data);
        EXPECT_EQ(one.display, other.display);
        expectSameChannels(one, other);
        Metadata header = readExrMetadata(path(a)), other_header = readExrMetadata(path(b));
        EXPECT_EQ(header.erase("renderTimeSeconds"), other_header.erase("renderTimeSeconds"));
        EXPECT_EQ(header, other_header);
    }
};

TEST_F(MergeTest, TilesAndRangesOfSamplesAreTheUndividedRender) {
    const Words same = {"--spp", "21", "--aov", "t,id", "--cropwindow", "0.1,0.9,0,1", "--seed", "4"};
    const auto with = [&](Words more) {
        more.insert(more.end(), same.begin(), same.end());
        return more;
    };
    render(with({"-o", "whole.exr"}));
    Words parts;
    for (const char* samples : {"18:21", "0:7", "7:18"})  // in any order
        for (const char* tile : {"3/3", "1/3", "2/3"}) {
            const std::string name = std::string("p") + samples[0] + samples[1] + tile[0] + ".exr";
            render(with({"-o", name, "--tile", tile, "--samples", samples}));
            parts.push_back(name);
        }
    const Outcome outcome = merge(parts);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    expectSamePicture("whole.exr", "merged.exr");
    ASSERT_EQ(renderWith({"-o", "next.exr", "--resume", "merged.exr", "--spp", "22", "--cropwindow", "0.1,0.9,0,1",
                          "--seed", "4"})
                  .code,
              0)
        << "as an undivided render goes on";
}

TEST_F(MergeTest, ReproducibleFilesAreTheSameByteForByte) {
    render({"-o", "whole.exr", "--aov", "all", "--reproducible"});
    for (const char* tile : {"1/2", "2/2"})
        render({"-o", std::string("t") + tile[0] + ".exr", "--tile", tile, "--aov", "all"});
    const Outcome outcome = merge({"t1.exr", "t2.exr", "--reproducible"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(readBytes(path("whole.exr")), readBytes(path("merged.exr")));
}

TEST_F(MergeTest, APngIsTheUndividedOne) {
    render({"-o", "whole.png", "--exposure", "1", "--tone", "aces"});
    for (const char* tile : {"1/2", "2/2"}) render({"-o", std::string("t") + tile[0] + ".exr", "--tile", tile});
    const Outcome outcome = run({"merge", "t2.exr", "t1.exr", "-o", "merged.png", "--exposure", "1", "--tone", "aces"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(readBytes(path("whole.png")), readBytes(path("merged.png")));
}

TEST_F(MergeTest, OutputsWithoutSamplesMergeToo) {
    const Words outputs = {"--spp", "0", "--aov", "all"};
    const auto with = [&](Words more) {
        more.insert(more.end(), outputs.begin(), outputs.end());
        return more;
    };
    render(with({"-o", "whole.exr"}));
    for (const char* tile : {"1/2", "2/2"}) render(with({"-o", std::string("t") + tile[0] + ".exr", "--tile", tile}));
    ASSERT_EQ(merge({"t1.exr", "t2.exr"}).code, 0);
    expectSamePicture("whole.exr", "merged.exr");
    expectFailure(merge({"t1.exr", "t2.exr"}, "merged.png"), 3, "the parts have no colour");
    std::filesystem::remove(path("merged.exr"));
    expectRefused({"t1.exr", "t2.exr", "t1.exr"}, "t1.exr and t1.exr overlap: both hold the pixels 0-31 x 0-47");
}

TEST_F(MergeTest, APartThatIsInterruptedGoesOn) {
    Launch launch{.arguments = {"render", "planet.pbrt", "--resolution", "320,240", "--spp", "60000", "--samples",
                                "16:59000", "--progress", "always", "-o", "a.exr", "--write-partial"}};
    launch.signal = SIGINT;
    ASSERT_EQ(run(launch).code, 130);
    const int done = std::get<int>(readExrMetadata(path("a.exr")).at("samplesPerPixel"));
    const Words same = {"--resolution", "320,240",   "--spp",
                        "60000",        "--samples", "16:" + std::to_string(16 + done + 3)};
    const auto with = [&](Words more) {
        more.insert(more.end(), same.begin(), same.end());
        return more;
    };
    render(with({"-o", "b.exr", "--resume", "a.exr"}));
    render(with({"-o", "c.exr"}));
    expectSamePicture("b.exr", "c.exr");
    expectRefused({"a.exr"}, "samples 0-15 of the pixels");
}

TEST_F(MergeTest, RefusesPartsOfOtherPictures) {
    render({"-o", "a.exr", "--tile", "1/2"});
    const Words other = {"-o", "b.exr", "--tile", "2/2"};
    const auto refuses = [&](Words options, const std::string& part) {
        options.insert(options.begin(), other.begin(), other.end());
        render(options);
        expectRefused({"a.exr", "b.exr"}, part);
    };
    refuses({"--seed", "1"}, "a.exr and b.exr are no parts of one picture: other seeds");
    refuses({"--spp", "8"}, "pictures of 4 and of 8 samples a pixel");
    refuses({"--resolution", "32,24"}, "another scene");
    refuses({"--aov", "t"}, "other outputs");
    refuses({"--clamp", "1"}, "another scene, other maps or images, or other options");
    refuses({"--exaggeration", "2"}, "another scene");
    refuses({"--marcher", "naive"}, "another scene");
    writePgm16(path("map.pgm"), fractalMap(64, 32, 9));
    refuses({}, "another scene, other maps");
}

TEST_F(MergeTest, RefusesPartsOfOtherProgramsAndDamagedHeaders) {
    for (const char* tile : {"1/2", "2/2"}) render({"-o", std::string("t") + tile[0] + ".exr", "--tile", tile});
    const Image picture = readExr(path("t2.exr"));
    const Metadata header = readExrMetadata(path("t2.exr"));
    const auto refuses = [&](const char* name, const Metadata::mapped_type& value, const std::string& part) {
        Metadata changed = header;
        changed[name] = value;
        writeExr(path("t2.exr"), picture, changed);
        expectRefused({"t1.exr", "t2.exr"}, part);
    };
    refuses("partCommit", "0123abc", "t1.exr and t2.exr are no parts of one picture: other commits of the program: ");
    refuses("software", "dsphere 0.0.1",
            "other versions of the program: dsphere " DSPHERE_VERSION " and dsphere 0.0.1");
    refuses("fingerprint", 7, "one header lacks fingerprint");
    refuses("partOfPicture", "0 0 64", "t2.exr: partOfPicture is \"0 0 64\", expected the corners of a picture");
    refuses("partOfPicture", "0 0 32 48", "no part is like that");
    refuses("partOfPicture", "0 0 65 48", "other sizes or crops of the whole picture");
    refuses("partFirstSample", 1, "samples 1-4 of 4 samples");
    refuses("partFirstSample", -1, "its header counts -1 samples, expected 0 to 65536");
    refuses("partTurns", "many", "its header lacks partTurns");
    refuses("samplesPerPixel", 3, "sample 3 of the pixels 32-63 x 0-47 is in no part");
    render({"-o", "t1.exr", "--tile", "1/1", "--spp", "3"});
    Image sums = readExr(path("t1.exr"));
    std::erase_if(sums.channels, [](const Channel& channel) { return channel.name == "sum.0-3.G"; });
    writeExr(path("t2.exr"), sums, readExrMetadata(path("t1.exr")));
    expectRefused({"t2.exr"}, "t2.exr: it has no channel sum.0-3.G, which samples 0 to 2 take");
}

TEST_F(MergeTest, TellsWhereLastBitsMayDiffer) {
    for (const char* tile : {"1/2", "2/2"}) render({"-o", std::string("t") + tile[0] + ".exr", "--tile", tile});
    EXPECT_EQ(merge({"t1.exr", "t2.exr"}).err, "");
    const Image picture = readExr(path("t2.exr"));
    const Metadata header = readExrMetadata(path("t2.exr"));
    const auto tells = [&](const char* name, const Metadata::mapped_type& value, const std::string& part) {
        Metadata changed = header;
        changed[name] = value;
        writeExr(path("t2.exr"), picture, changed);
        const Outcome outcome = merge({"t1.exr", "t2.exr"});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_TRUE(holds(outcome.err, "dsphere: warning: " + part)) << outcome.err;
    };
    tells("device", "another", "the parts were rendered by more than one device: another, ");
    tells("driver", "another", "the parts were rendered by more than one driver: another, ");
    tells("partTurns", 8, "t2.exr: its invocations took other pixels together than those of the whole picture do");
}

TEST_F(MergeTest, RefusesOverlapsAndGapsAndNamesThem) {
    for (const char* tile : {"1/3", "2/3", "3/3", "1/2"})
        render({"-o", std::string("t") + tile[0] + tile[2] + ".exr", "--tile", tile, "--spp", "2"});
    render({"-o", "late.exr", "--tile", "2/3", "--spp", "2", "--samples", "1:2"});
    expectRefused({"t13.exr", "t33.exr"}, "are in no part");
    expectRefused({"t13.exr", "t23.exr", "t33.exr", "t13.exr"}, "t13.exr and t13.exr overlap: both hold samples 0-1");
    expectRefused({"t13.exr", "t23.exr", "t33.exr", "t12.exr"}, "overlap: both hold the pixels");
    expectRefused({"t13.exr", "t23.exr", "t33.exr", "late.exr"}, "t23.exr and late.exr overlap: both hold sample 1 of");
    expectRefused({"t13.exr", "late.exr", "t33.exr"}, "sample 0 of the pixels");
}

TEST_F(MergeTest, RefusesOtherFilesAndNames) {
    render({"-o", "whole.exr"});
    render({"-o", "t.exr", "--tile", "1/1"});
    folder_.write("text.exr", "no picture");
    expectRefused({"none.exr"}, "error: none.exr: cannot be read: No such file");
    expectRefused({"text.exr"}, "text.exr: cannot be read as EXR");
    expectRefused({"whole.exr"}, "whole.exr: is no part of a picture: its header lacks partOfPicture");
    expectFailure(merge({"t.exr"}, "t.exr"), 2, "t.exr");
    expectFailure(merge({"t.exr"}, "t.jpg"), 2, "the extension is \".jpg\", expected .exr or .png");
    expectFailure(merge({"t.exr", "--tone", "aces"}), 2, "--exposure, --tone and --alpha are for .png");
    expectFailure(merge({"t.exr", "--exposure", "inf"}, "t.png"), 2, "--exposure: inf is not a finite number");
    expectFailure(merge({"t.exr"}, "no/t.exr"), 1, "the folder no does not exist");
    std::string cut = readBytes(path("t.exr"));
    folder_.write("t.exr", cut.substr(0, cut.size() - 100));
    expectRefused({"t.exr"}, "t.exr: cannot be read as EXR");
    EXPECT_EQ(folder_.entries(), 5u) << "a temporary was left";
}

TEST_F(MergeTest, WrongPartsAreToldFirst) {
    const auto fails = [&](Words options, const std::string& part) { expectFailure(renderWith(options), 2, part); };
    for (const char* tile : {"0/4", "5/4", "1", "1/", "/2", "a/b", "1/2/3", "-1/2"})
        fails({"-o", "t.exr", "--tile=" + std::string(tile)}, "is not I/N with I from 1 to N");
    fails({"-o", "t.exr", "--tile", "1/9999"}, "3072 pixels are no 9999 tiles");
    for (const char* samples : {"4:4", "3:2", "1", ":2", "1:", "-1:2", "a:b"})
        fails({"-o", "t.exr", "--samples=" + std::string(samples)}, "is not A:B with A below B");
    fails({"-o", "t.exr", "--samples", "2:5"}, "2:5 is not within the picture's samples, 0:4");
    fails({"-o", "t.png", "--tile", "1/2"}, "t.png: a part of a picture must be an .exr");
    fails({"-o", "t%d.exr", "--tile", "1/2", "--turntable", "2"}, "--frames excludes --tile and --samples");
    expectFailure(renderWith({"-o", "t.png", "--resolution", "30000,30000"}), 1,
                  "t.png: 30000x30000 pixels of 3 channels are more than a PNG is packed from in memory");
    fails({"-o", "t.exr", "--resolution", "1048577,1"}, "is outside 1 to 1048576");
    expectFailure(renderWith({"-o", "t.exr", "--resolution", "100000,1"}), 1, "render it in parts: --tile I/N");
    EXPECT_EQ(folder_.entries(), 2u);
}

// Wider than a device's images, and more than a PNG is packed from.
TEST_F(MergeTest, PicturesBeyondADeviceComeInTiles) {
    Words parts;
    for (const char* tile : {"1/4", "2/4", "3/4", "4/4"}) {
        parts.push_back(std::string("t") + tile[0] + ".exr");
        render({"-o", parts.back(), "--resolution", "40000,2", "--spp", "1", "--tile", tile});
    }
    ASSERT_EQ(merge(parts).code, 0);
    EXPECT_EQ(readExrMetadata(path("merged.exr")).at("samplesPerPixel"), Metadata::mapped_type(1));
}

TEST_F(MergeTest, ProgressForPrograms) {
    const Outcome outcome = renderWith({"-o", "a.png", "--progress", "lines"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(holds(outcome.err, "Progress: 100%\n"));
}

}  // namespace
}  // namespace dsphere::test
