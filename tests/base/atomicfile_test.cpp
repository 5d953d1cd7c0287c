#include "base/atomicfile.h"

#include "base/error.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace dsphere::test {
namespace {

namespace fs = std::filesystem;

class AtomicFileTest : public testing::Test {
  protected:
    fs::path path(const std::string& name) const { return folder_.path() / name; }
    void write(const std::string& name, const std::string& text) const {
        AtomicFile file(path(name));
        file.write(text.data(), text.size());
        file.commit();
    }
    TempFolder folder_;
};

TEST_F(AtomicFileTest, AppearsWholeAtCommit) {
    AtomicFile file(path("new"));
    file.write("abcd", 4);
    file.seek(1);
    file.write("XY", 2);
    EXPECT_EQ(file.tell(), 3u);
    EXPECT_FALSE(fs::exists(path("new")));
    file.commit();
    EXPECT_EQ(readBytes(path("new")), "aXYd");
    EXPECT_EQ(folder_.entries(), 1u);
}

// Lists without elements have no address; what fwrite says of null is undefined.
TEST_F(AtomicFileTest, NothingMayBeWritten) {
    AtomicFile file(path("empty"));
    file.write(nullptr, 0);
    EXPECT_EQ(file.tell(), 0u);
    file.commit();
    EXPECT_EQ(readBytes(path("empty")), "");
}

TEST_F(AtomicFileTest, WithoutCommitNothingChanges) {
    folder_.write("old", "old");
    { AtomicFile(path("old")).write("new", 3); }
    { AtomicFile(path("never")).write("new", 3); }
    EXPECT_EQ(readBytes(path("old")), "old");
    EXPECT_EQ(folder_.entries(), 1u);
}

TEST_F(AtomicFileTest, NewFilesHaveTheUsualPermissions) {
    const mode_t mask = umask(0027);
    write("new", "x");
    umask(mask);
    EXPECT_EQ(int(fs::status(path("new")).permissions()), 0640);
}

TEST_F(AtomicFileTest, AReplacedFilePassesItsPermissionsOn) {
    folder_.write("old", "old");
    fs::permissions(path("old"), fs::perms(0604));
    write("old", "new");
    EXPECT_EQ(int(fs::status(path("old")).permissions()), 0604);
    EXPECT_EQ(readBytes(path("old")), "new");
    EXPECT_EQ(folder_.entries(), 1u);
}

TEST_F(AtomicFileTest, ReadOnlyFilesAndFoldersAreNotReplaced) {
    folder_.write("old", "old");
    fs::permissions(path("old"), fs::perms(0444));
    expectError(ExitCode::Failure, "exists and is read-only", [&] { write("old", "new"); });
    fs::create_directory(path("folder"));
    expectError(ExitCode::Failure, "not a regular file", [&] { write("folder", "new"); });
    EXPECT_EQ(readBytes(path("old")), "old");
}

TEST_F(AtomicFileTest, LinksAreFollowed) {
    fs::create_directory(path("a"));
    fs::create_symlink("a/second", path("first"));
    fs::create_symlink("../end", path("a/second"));
    EXPECT_EQ(resolveLinks(path("first")), path("a/../end"));
    write("first", "new");
    EXPECT_TRUE(fs::is_symlink(path("first")) && fs::is_symlink(path("a/second")));
    EXPECT_EQ(readBytes(path("end")), "new");
    fs::create_symlink("circle", path("circle"));
    expectError(ExitCode::Failure, "circle: cannot be written", [&] { write("circle", "new"); });
}

TEST_F(AtomicFileTest, AMissingFolderIsAnError) {
    expectError(ExitCode::Failure, "nowhere/new: cannot be written: No such file", [&] { write("nowhere/new", "x"); });
}

// A lock tells the living from the dead, whatever machine they are on.
TEST_F(AtomicFileTest, LeftoversGoWithTheirProcesses) {
    const fs::path dead = folder_.write(".dsphere-00112233445566aa.tmp", "dead");
    const fs::path living = folder_.write(".dsphere-00112233445566bb.tmp", "living");
    const fs::path other = folder_.write(".dsphere-settings.tmp", "a user's own");
    const int lock = open(living.c_str(), O_RDONLY);
    ASSERT_EQ(flock(lock, LOCK_EX), 0);
    write("new", "x");
    EXPECT_FALSE(fs::exists(dead));
    EXPECT_TRUE(fs::exists(living));
    EXPECT_TRUE(fs::exists(other));
    close(lock);
}

TEST_F(AtomicFileTest, AFailureOfAnyWriteIsToldAtCommit) {
    folder_.write("old", "old");
    AtomicFile file(path("old"));
    file.write("new", 3);
    file.seek(std::uint64_t(1) << 63);  // no file is that long
    file.write("x", 1);
    expectError(ExitCode::Failure, "old: cannot be written: ", [&] { file.commit(); });
    EXPECT_EQ(readBytes(path("old")), "old");
    EXPECT_EQ(folder_.entries(), 1u);
}

}  // namespace
}  // namespace dsphere::test
