// What keys and buttons ask for.

#include <imgui.h>

#include "viewer/app.h"

namespace dsphere::viewer {

void App::cameraMoved(bool moving) {
    camera_is_new_ = true;
    viewChanged(moving);
}

// What is open in the window goes first. A list that the next frame closes counts as closed.
void App::escape() {
    if (!ui_.let_go && ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
        ui_.let_go = true;
    else if (ui_.leaving.asked || screenshot_ || save_waits_)
        dropWaiting();
    else if (ui_.path.open || ui_.go_to.open)
        ui_.path.open = ui_.go_to.open = false;
    else if (ui_.keys_open)
        ui_.keys_open = false;
    else if (ui_.message.stays() && !ui_.message.text.empty())
        ui_.message.text.clear();
    else if (ui_.panel_open)
        ui_.panel_open = false;
    else
        leave({});
}

void App::undo(int by) {
    if (!stage_) return;
    history_.add(state());
    const State* wanted = history_.step(by);
    if (!wanted) return say(by < 0 ? "Nothing is left to undo." : "Nothing is left to redo.");
    const State before = *wanted;
    try {
        adopt(before);
    } catch (const Error& error) {  // of the path's file, which is not as it was left: its keys stay as they are
        say(error.what(), Message::Kind::Error);
        history_.amend([&](State& one) { one.recorded = chosen_.recorded; });
        State rest = before;
        rest.recorded = chosen_.recorded;
        adopt(rest);
    }
}

// What needs no file. False: another kind of command.
bool App::runForWindow(Command command) {
    switch (command) {
        case Command::Panel:
            ui_.panel_open = !ui_.panel_open;
            return true;
        case Command::Keys:
            ui_.keys_open = !ui_.keys_open;
            return true;
        case Command::OpenFile:
            ui_.path.open = !ui_.path.open && !ui_.starting;
            return true;
        case Command::FullScreen:
            window_.switchFullScreen();
            return true;
        case Command::Escape:
            escape();
            return true;
        case Command::Quit:
            leave({});
            return true;
        case Command::Stay:
            ui_.leaving = {};
            return true;
        default:
            return false;
    }
}

bool App::runForFiles(Command command) {
    switch (command) {
        case Command::SaveAndLeave:
            leaves_then_ = true;
            wantSaved();
            return true;
        case Command::LeaveUnsaved:
            leaveNow();
            return true;
        case Command::CopyCamera:
            copyCamera();
            return true;
        case Command::SaveScene:
            wantSaved();
            return true;
        case Command::AddKey:
            addKey();
            return true;
        case Command::PlayPath:
            play();
            return true;
        case Command::Reload:
            open(stage_->document().path);
            return true;
        case Command::Screenshot:
            wantScreenshot();
            return true;
        default:
            return false;
    }
}

// False: another kind of command.
bool App::runForCamera(Command command) {
    const int sides = int(Command::Corner) - int(Command::Front) + 1, side = int(command) - int(Command::Front);
    const dvec2 middle = 0.5 * dvec2(area()[0], area()[1]);
    switch (command) {
        case Command::ResetView:
            control_->reset();
            break;
        case Command::NorthUp:
            control_->northUp();
            break;
        case Command::Frame:
            control_->frame();
            break;
        case Command::MoveLeft:
        case Command::MoveRight:
            control_->moveOver({command == Command::MoveRight ? 1.0 : -1.0, 0.0});
            break;
        case Command::MoveUp:
        case Command::MoveDown:
            control_->moveOver({0.0, command == Command::MoveUp ? 1.0 : -1.0});
            break;
        case Command::ZoomIn:
        case Command::ZoomOut:
            zoomAt(middle, command == Command::ZoomIn ? 1.0 : -1.0);
            break;
        default:
            if (side < 0 || side >= sides) return false;
            control_->axisView(Side(side));
    }
    cameraMoved(repeats(command));
    return true;
}

// Typed in degrees, and as high as the gauges have it.
void App::openGoTo() {
    const Globe& globe = control_->globe();
    const dvec3 eye = control_->pose().eye;
    if (!globe.round() || eye == globe.centre()) return say("Only spheres have latitudes and longitudes.");
    const Place place = globe.placeOf(eye);
    const double unit = lengthUnitOf(stage_->document(), globe, control_->target()).per_world;
    ui_.go_to = {true, false, place.latitude, place.longitude, unit * globe.altitude(eye)};
}

void App::runForView(Command command) {
    if (runForCamera(command)) return;
    State wanted = state();
    const auto next = [](int value, int by, int count) { return (value + by + count) % count; };
    switch (command) {
        case Command::Undo:
            return undo(-1);
        case Command::Redo:
            return undo(1);
        case Command::GoTo:
            if (!ui_.go_to.open) return openGoTo();
            ui_.go_to.open = false;
            return;
        case Command::ResetAll:
            wanted.view = ui_.untouched.view;
            wanted.tone = ui_.untouched.tone;
            wanted.edits = noEdits(stage_->document().original, options_.exaggeration);
            break;
        case Command::NextMarcher:
            wanted.view.method.marcher = Marcher(next(int(wanted.view.method.marcher), 1, kMarcherCount));
            // The left half of a split view is the naive one already.
            if (wanted.view.split && wanted.view.method.marcher == Marcher::Naive)
                wanted.view.method.marcher = Marcher::NaiveShell;
            break;
        case Command::Split:
            wanted.view.split = !wanted.view.split;
            break;
        case Command::NextValue:
        case Command::PreviousValue:
            wanted.view.show = Show(next(int(wanted.view.show), command == Command::NextValue ? 1 : -1, kShowCount));
            break;
        default:
            return;
    }
    adopt(wanted);
}

void App::runCommand(Command command) {
    try {
        if (!runForWindow(command) && stage_ && !runForFiles(command)) runForView(command);
    } catch (const Error& error) {
        say(error.what(), Message::Kind::Error);
    }
}

}  // namespace dsphere::viewer
