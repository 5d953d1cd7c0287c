#pragma once

#include <string>
#include <vector>

namespace dsphere::viewer {

struct Event;

/// What a click or a key asks for, once.
enum class Command {
    None,
    Undo,
    Redo,
    ResetAll,
    ResetView,
    Front,  // Front to Corner: in the order of Side
    Back,
    Right,
    Left,
    North,
    South,
    Corner,
    NorthUp,
    Frame,
    MoveLeft,  // MoveLeft to ZoomOut: again and again while the key is held
    MoveRight,
    MoveUp,
    MoveDown,
    ZoomIn,
    ZoomOut,
    GoTo,
    OpenFile,
    Panel,
    Keys,
    NextMarcher,
    Split,
    NextValue,
    PreviousValue,
    Reload,
    FullScreen,
    Screenshot,
    CopyCamera,
    SaveScene,
    AddKey,
    PlayPath,
    Escape,
    Quit,
    LeaveUnsaved,  // what ui.h's Leaving asks about
    SaveAndLeave,
    Stay,
};

/// A line of the keys: the window's help, the manual and the keyboard itself go by this table.
struct KeyLine {
    const char* section;
    /// As people write them: alternatives with ", " between, each a key with "Ctrl + " or "Shift + " before it.
    const char* keys;
    const char* does;
    /// What the alternatives ask for, in order, the last of these for all that are left. Empty: a gesture, or keys that
    /// are held.
    std::vector<Command> commands = {};
};

const std::vector<KeyLine>& keyLines();

/// What a key that went down asks for.
Command commandOf(const Event& key);
/// Whether a held key asks for it again and again.
inline bool repeats(Command command) {
    return command >= Command::MoveLeft && command <= Command::ZoomOut;
}

/// The table as docs/viewer.md has it.
std::string keysInMarkdown();

}  // namespace dsphere::viewer
