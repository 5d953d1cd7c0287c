#include "base/error.h"
#include "cli/commands.h"

namespace dsphere::cli {

// Of builds without GLFW or Dear ImGui.
void addView(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("view", "Show a scene in a window (this build cannot)");
    command->allow_extras();
    command->callback([&action] {
        action = []() -> int {
            throw Error(ExitCode::Usage,
                        "this dsphere was built without its viewer: install GLFW and Dear ImGui (Debian: libglfw3-dev "
                        "libimgui-dev) and build again; `dsphere render` makes pictures without them");
        };
    });
}

}  // namespace dsphere::cli
