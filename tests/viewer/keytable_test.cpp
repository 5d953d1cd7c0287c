#include "viewer/keytable.h"

#include "tests/support/tempfolder.h"
#include "viewer/window.h"

#include <gtest/gtest.h>

namespace dsphere::viewer {
namespace {

// GLFW's codes of letters and digits are those of ASCII.
Command asked(char key, bool control = false, bool shift = false) {
    Event event{};
    event.kind = Event::KeyDown;
    event.code = key;
    event.control = control;
    event.shift = shift;
    return commandOf(event);
}

TEST(KeyTable, KeysAskForThem) {
    EXPECT_EQ(asked('Z', true), Command::Undo);
    EXPECT_EQ(asked('Z', true, true), Command::Redo);
    EXPECT_EQ(asked('Y', true), Command::Redo);
    EXPECT_EQ(asked('S', true), Command::SaveScene);
    EXPECT_EQ(asked('S'), Command::None) << "it flies";
    EXPECT_EQ(asked('V'), Command::NextValue);
    EXPECT_EQ(asked('V', false, true), Command::PreviousValue);
    EXPECT_EQ(asked('K'), Command::AddKey);
    EXPECT_EQ(asked('K', false, true), Command::PlayPath);
    EXPECT_EQ(asked('1'), Command::Front);
    EXPECT_EQ(asked('1', true), Command::Back);
    EXPECT_EQ(asked('9', true), Command::None);
    EXPECT_EQ(asked('/'), Command::Keys) << "the question mark";
    EXPECT_EQ(asked('/', false, true), Command::Keys);
    EXPECT_EQ(asked('='), Command::ZoomIn) << "the plus sign, with Shift and without";
    EXPECT_EQ(asked('=', false, true), Command::ZoomIn);
    EXPECT_EQ(asked('-'), Command::ZoomOut);
    EXPECT_EQ(asked('N'), Command::NorthUp);
    EXPECT_EQ(asked('O', true), Command::OpenFile);
    EXPECT_TRUE(repeats(Command::MoveDown));
    EXPECT_FALSE(repeats(Command::GoTo));
}

TEST(KeyTable, TheManualHasTheTable) {
    const std::string manual = test::readBytes(DSPHERE_SOURCE_DIR "/docs/viewer.md");
    EXPECT_NE(manual.find(keysInMarkdown()), std::string::npos) << "docs/viewer.md should hold:\n" << keysInMarkdown();
}

}  // namespace
}  // namespace dsphere::viewer
