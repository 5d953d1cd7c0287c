#include "viewer/viewer.h"

#include <fmt/ranges.h>

#include <optional>

#include "base/error.h"
#include "viewer/app.h"

namespace dsphere::viewer {

namespace {

void requireSilence(const gpu::Device& device) {
    const auto& messages = device.validationMessages();
    if (!messages.empty()) throwFailure("the validation layers object:\n{}", fmt::join(messages, "\n"));
}

}  // namespace

void runViewer(const ViewerOptions& options) {
    // Mistakes in the scene are told before a window comes up; its maps are read behind one.
    const Film film = options.path.empty() ? Film{} : options.open(options.path).film;
    Window window(film.width, film.height, "dsphere", statusHeight(1.0), !options.exact_size);
    const gpu::Presentation here = window.presentation(false), anywhere = window.presentation(true);
    gpu::Device renders({options.device, options.validation, options.apart ? nullptr : &here});
    // A device that cannot present gets a second one beside it, and the pictures go through the host.
    std::optional<gpu::Device> other;
    if (!renders.presentation()) other.emplace(gpu::DeviceOptions{"", options.validation, &anywhere});
    gpu::Device& presents = other ? *other : renders;
    {
        App app(options, window, renders, presents);
        app.run();
    }
    requireSilence(renders);
    requireSilence(presents);
}

}  // namespace dsphere::viewer
