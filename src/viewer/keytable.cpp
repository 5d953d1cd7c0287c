#include "viewer/keytable.h"

#include <fmt/format.h>

#define GLFW_INCLUDE_NONE
#include <volk.h>

#include <GLFW/glfw3.h>

#include <algorithm>
#include <string_view>

#include "viewer/window.h"

namespace dsphere::viewer {

namespace {

/// A key with what is held beside it.
struct Chord {
    int code = 0, other_code = 0;  ///< the other: of the number pad
    bool control = false, shift = false;
};

constexpr struct {
    std::string_view name;
    int code, other_code;
} kNamed[] = {
    {"Enter", GLFW_KEY_ENTER, GLFW_KEY_KP_ENTER},
    {"Home", GLFW_KEY_HOME, 0},
    {"Tab", GLFW_KEY_TAB, 0},
    {"Esc", GLFW_KEY_ESCAPE, 0},
    {"?", GLFW_KEY_SLASH, 0},
    {"Left", GLFW_KEY_LEFT, 0},
    {"Right", GLFW_KEY_RIGHT, 0},
    {"Up", GLFW_KEY_UP, 0},
    {"Down", GLFW_KEY_DOWN, 0},
    {"+", GLFW_KEY_EQUAL, GLFW_KEY_KP_ADD},
    {"-", GLFW_KEY_MINUS, GLFW_KEY_KP_SUBTRACT},
};

bool take(std::string_view& text, std::string_view prefix) {
    if (!text.starts_with(prefix)) return false;
    text.remove_prefix(prefix.size());
    return true;
}

Chord chordOf(std::string_view text) {
    Chord chord;
    chord.control = take(text, "Ctrl + ");
    chord.shift = take(text, "Shift + ");
    for (const auto& [name, code, other_code] : kNamed)
        if (text == name) chord.code = code, chord.other_code = other_code;
    if (text.size() == 1 && text[0] >= 'A' && text[0] <= 'Z') chord.code = GLFW_KEY_A + text[0] - 'A';
    if (text.size() == 1 && text[0] >= '0' && text[0] <= '9')
        chord.code = GLFW_KEY_0 + text[0] - '0', chord.other_code = GLFW_KEY_KP_0 + text[0] - '0';
    if (text.size() > 1 && text[0] == 'F' && text[1] >= '1' && text[1] <= '9')
        chord.code = GLFW_KEY_F1 - 1 + std::stoi(std::string(text.substr(1)));
    return chord;
}

// "?" and "+" are typed with Shift on many keyboards and without on others.
bool isSign(int code) {
    return code == GLFW_KEY_SLASH || code == GLFW_KEY_EQUAL;
}

bool matches(const Chord& chord, const Event& key) {
    return key.code != 0 && (key.code == chord.code || key.code == chord.other_code) && key.control == chord.control &&
           (key.shift == chord.shift || isSign(chord.code));
}

}  // namespace

const std::vector<KeyLine>& keyLines() {
    static const std::vector<KeyLine> lines = {
        {"Mouse", "drag",
         "turns the planet under the cursor: what you grabbed stays there, north stays as far up as it was; on the sky "
         "near the ground, looks around"},
        {"Mouse", "right drag, Shift + drag", "moves sideways"},
        {"Mouse", "middle drag, Ctrl + drag",
         "turns and tilts about the point under the cursor, from straight down to the horizon"},
        {"Mouse", "wheel, two fingers", "zooms to what is under the cursor, down to the ground, never through it"},
        {"Mouse", "double click", "flies there: straight down on the place, north up"},
        {"Mouse", "click", "chooses the object that the panel changes and that turns"},
        {"Mouse", "L + drag", "moves the sun"},
        {"Mouse", "pointing", "tells latitude, longitude, height in the map's units and distance, in the bar below"},
        {"Mouse", "dropping a file",
         "opens a scene or a heightmap, after a question if changes are unsaved; a file that changes on disk is read "
         "again"},
        {"Move", "W A S D, Q E",
         "flies ahead, left, back, right, down, up, as fast as the eye is high; Shift: five times faster"},
        {"Move",
         "Left, Right, Up, Down",
         "over the ground to that side",
         {Command::MoveLeft, Command::MoveRight, Command::MoveUp, Command::MoveDown}},
        {"Move", "+, -", "nearer, farther", {Command::ZoomIn, Command::ZoomOut}},
        {"Move", "N", "north up; near the ground level, looking north", {Command::NorthUp}},
        {"Move", "F", "all of the object, from where the eye is", {Command::Frame}},
        {"Move", "G", "goes to a latitude, longitude and height that are typed", {Command::GoTo}},
        {"Move", "R, Enter, Home", "the first view", {Command::ResetView}},
        {"Move", "1, Ctrl + 1", "latitude 0 and longitude 0; the far side", {Command::Front, Command::Back}},
        {"Move", "3, Ctrl + 3", "longitude 90; longitude -90", {Command::Right, Command::Left}},
        {"Move", "7, Ctrl + 7", "the north pole; the south pole", {Command::North, Command::South}},
        {"Move", "9", "the corner between 1, 3 and 7", {Command::Corner}},
        {"Change", "Tab", "the panel", {Command::Panel}},
        {"Change", "Ctrl + Z", "takes the last change of view, settings or path back", {Command::Undo}},
        {"Change", "Ctrl + Shift + Z, Ctrl + Y", "does it again", {Command::Redo}},
        {"Change",
         "V, Shift + V",
         "the next, the previous value in place of the picture: contours, slope, graticule, distance ...",
         {Command::NextValue, Command::PreviousValue}},
        {"Change", "M", "the next marcher: exact, naive ...", {Command::NextMarcher}},
        {"Change",
         "X",
         "the split view: the naive marcher on the left of a divider that can be dragged",
         {Command::Split}},
        {"Keep",
         "F12",
         "a screenshot, as `dsphere render` makes it, once all samples are there; again: at once",
         {Command::Screenshot}},
        {"Keep", "Ctrl + S", "saves the scene with this camera and these settings", {Command::SaveScene}},
        {"Keep",
         "K, Shift + K",
         "adds this view as a key of a path, which `dsphere render --path` films; plays the path",
         {Command::AddKey, Command::PlayPath}},
        {"Keep", "Ctrl + C", "copies the camera as pbrt text", {Command::CopyCamera}},
        {"Window",
         "Ctrl + O",
         "opens another file, whose path is typed: Tab completes it; unsaved changes are asked about",
         {Command::OpenFile}},
        {"Window", "F5", "reads the file again", {Command::Reload}},
        {"Window", "F11", "the full screen, and back", {Command::FullScreen}},
        {"Window", "H, ?, F1", "these keys", {Command::Keys}},
        {"Window",
         "Esc",
         "ends what is under way: a film, a screenshot that waits; closes what is open: a list, the keys, the panel; "
         "at last the window",
         {Command::Escape}},
        {"Window", "Ctrl + Q", "closes the window; unsaved changes are asked about", {Command::Quit}},
    };
    return lines;
}

Command commandOf(const Event& key) {
    for (const KeyLine& line : keyLines()) {
        std::string_view rest = line.keys;
        for (std::size_t i = 0; !rest.empty() && !line.commands.empty(); ++i) {
            const std::size_t end = std::min(rest.find(", "), rest.size());
            if (matches(chordOf(rest.substr(0, end)), key)) return line.commands[std::min(i, line.commands.size() - 1)];
            rest.remove_prefix(std::min(end + 2, rest.size()));
        }
    }
    return Command::None;
}

std::string keysInMarkdown() {
    std::string text = "| | |\n| --- | --- |\n";
    for (const KeyLine& line : keyLines()) text += fmt::format("| {} | {} |\n", line.keys, line.does);
    return text;
}

}  // namespace dsphere::viewer
