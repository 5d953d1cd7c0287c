#include "viewer/watcher.h"
#include "tests/support/tempfolder.h"

#include <gtest/gtest.h>

namespace dsphere::viewer {
namespace {

TEST(Watcher, TellsOfAChangeOnceItHasSettled) {
    test::TempFolder folder;
    auto file = folder.write("a.pgm", "one");
    Watcher watcher;
    watcher.watch({file});
    double now = 0.0;
    auto look = [&] { return watcher.changed(now += Watcher::kInterval); };
    EXPECT_FALSE(look());
    std::filesystem::last_write_time(file, std::filesystem::last_write_time(file) + std::chrono::seconds(5));
    EXPECT_FALSE(look()) << "it may still be written to";
    EXPECT_TRUE(look());
    EXPECT_FALSE(look()) << "once";
    std::filesystem::remove(file);
    EXPECT_FALSE(look());
    EXPECT_FALSE(look()) << "a file that is gone is about to come back";
    folder.write("a.pgm", "two");
    std::filesystem::last_write_time(file, std::filesystem::last_write_time(file) + std::chrono::seconds(9));
    EXPECT_FALSE(look());
    EXPECT_TRUE(look());
}

}  // namespace
}  // namespace dsphere::viewer
