#include "viewer/window.h"

#include "base/error.h"

#define GLFW_INCLUDE_NONE
#include <volk.h>

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

namespace dsphere::viewer {

namespace {

constexpr double kLeastScale = 0.5, kGreatestScale = 4.0;  // of a display

std::string lastGlfwError() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "GLFW gives no reason";
}

[[noreturn]] void throwNoWindow(const std::string& reason) {
    throw Error(ExitCode::NoDevice,
                fmt::format("no window can be opened: {}; `dsphere render` makes pictures without one", reason));
}

VkSurfaceKHR makeSurface(VkInstance instance, GLFWwindow* window) {
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    if (glfwCreateWindowSurface(instance, window, nullptr, &surface) != VK_SUCCESS) throwNoWindow(lastGlfwError());
    return surface;
}

}  // namespace

struct Callbacks {
    static Window& of(GLFWwindow* window) { return *static_cast<Window*>(glfwGetWindowUserPointer(window)); }

    static void add(Window& window, Event event, int mods) {
        event.cursor = window.cursor_;
        event.shift = mods & GLFW_MOD_SHIFT;
        event.control = mods & GLFW_MOD_CONTROL;
        window.events_.push_back(std::move(event));
    }
    static void button(GLFWwindow* handle, int button, int action, int mods) {
        add(of(handle), {.kind = action == GLFW_PRESS ? Event::Press : Event::Release, .code = button}, mods);
    }
    static void move(GLFWwindow* handle, double x, double y) {
        Window& window = of(handle);
        window.cursor_ = dvec2(x, y) * window.pixels_per_unit_;
        add(window, {.kind = Event::Move}, 0);
    }
    static void enter(GLFWwindow* handle, int entered) {
        of(handle).cursor_within_ = entered;
        add(of(handle), {.kind = entered ? Event::Move : Event::Leave}, 0);
    }
    static void character(GLFWwindow* handle, unsigned int code) {
        add(of(handle), {.kind = Event::Character, .code = int(code)}, 0);
    }
    static void scroll(GLFWwindow* handle, double, double y) {
        add(of(handle), {.kind = Event::Scroll, .steps = y}, 0);
    }
    static void key(GLFWwindow* handle, int key, int, int action, int mods) {
        // Repeats are for what is typed into; held keys are counted by time.
        Event event{.kind = action == GLFW_RELEASE ? Event::KeyUp : Event::KeyDown, .code = key};
        event.repeated = action == GLFW_REPEAT;
        add(of(handle), event, mods);
    }
    static void drop(GLFWwindow* handle, int count, const char** paths) {
        if (count > 0) add(of(handle), {.kind = Event::Drop, .path = paths[0]}, 0);
    }
    static void resize(GLFWwindow* handle, int, int) {
        of(handle).readSize();
        add(of(handle), {.kind = Event::Resize}, 0);
    }
    static void refresh(GLFWwindow* handle) { add(of(handle), {.kind = Event::Resize}, 0); }
    static void focus(GLFWwindow* handle, int focused) {
        if (!focused) add(of(handle), {.kind = Event::LoseFocus}, 0);
    }
};

Window::Window(int width, int height, const std::string& title, int below, bool grows) {
    if (!glfwInit()) throwNoWindow(lastGlfwError());
    if (!glfwVulkanSupported()) {
        std::string reason = lastGlfwError();
        glfwTerminate();
        throwNoWindow(reason);
    }
    int x = 0, y = 0, most_width = width, most_height = height;
    if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) {
        float x_scale = 1.0f, y_scale = 1.0f;
        glfwGetMonitorWorkarea(monitor, &x, &y, &most_width, &most_height);
        glfwGetMonitorContentScale(monitor, &x_scale, &y_scale);
        const double scale = std::clamp(double(x_scale), kLeastScale, kGreatestScale);
        const int bar = int(std::round(below * scale));
        const auto scaled = [&](int side) { return int(std::round(side * scale)); };
        if (grows && scaled(width) <= most_width && scaled(height) + bar <= most_height)
            width = scaled(width), height = scaled(height);
        height += bar;
    }
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    window_ = glfwCreateWindow(std::clamp(width, 320, std::max(320, most_width)),
                               std::clamp(height, 240, std::max(240, most_height)), title.c_str(), nullptr, nullptr);
    if (!window_) {
        std::string reason = lastGlfwError();
        glfwTerminate();
        throwNoWindow(reason);
    }
    glfwSetWindowUserPointer(window_, this);
    glfwSetMouseButtonCallback(window_, Callbacks::button);
    glfwSetCursorPosCallback(window_, Callbacks::move);
    glfwSetCursorEnterCallback(window_, Callbacks::enter);
    glfwSetCharCallback(window_, Callbacks::character);
    glfwSetScrollCallback(window_, Callbacks::scroll);
    glfwSetKeyCallback(window_, Callbacks::key);
    glfwSetDropCallback(window_, Callbacks::drop);
    glfwSetFramebufferSizeCallback(window_, Callbacks::resize);
    glfwSetWindowRefreshCallback(window_, Callbacks::refresh);
    glfwSetWindowFocusCallback(window_, Callbacks::focus);
    readSize();
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

void Window::readSize() {
    int units_x = 0, units_y = 0;
    glfwGetFramebufferSize(window_, &width_, &height_);
    glfwGetWindowSize(window_, &units_x, &units_y);
    if (units_x > 0 && units_y > 0 && visible())
        pixels_per_unit_ = dvec2(double(width_) / units_x, double(height_) / units_y);
}

gpu::Presentation Window::presentation(bool required) const {
    std::uint32_t count = 0;
    const char** names = glfwGetRequiredInstanceExtensions(&count);
    gpu::Presentation result;
    if (names) result.instance_extensions.assign(names, names + count);
    result.make_surface = [window = window_](VkInstance instance) { return makeSurface(instance, window); };
    result.required = required;
    return result;
}

std::vector<Event> Window::poll(double seconds) {
    if (seconds > 0.0)
        glfwWaitEventsTimeout(seconds);
    else
        glfwPollEvents();
    return std::exchange(events_, {});
}

bool Window::closing() const {
    return glfwWindowShouldClose(window_);
}

void Window::close(bool really) {
    glfwSetWindowShouldClose(window_, really);
}

void Window::switchFullScreen() {
    if (glfwGetWindowMonitor(window_)) {
        glfwSetWindowMonitor(window_, nullptr, windowed_[0], windowed_[1], windowed_[2], windowed_[3], 0);
        return;
    }
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    if (!monitor) return;
    const GLFWvidmode* mode = glfwGetVideoMode(monitor);
    glfwGetWindowPos(window_, &windowed_[0], &windowed_[1]);
    glfwGetWindowSize(window_, &windowed_[2], &windowed_[3]);
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

double Window::now() const {
    return glfwGetTime();
}

double Window::scale() const {
    float x = 1.0f, y = 1.0f;
    glfwGetWindowContentScale(window_, &x, &y);
    return std::clamp(double(x), kLeastScale, kGreatestScale);
}

bool Window::isDown(int key) const {
    return glfwGetKey(window_, key) == GLFW_PRESS;
}

void Window::setTitle(const std::string& title) {
    glfwSetWindowTitle(window_, title.c_str());
}

void Window::copyText(const std::string& text) {
    glfwSetClipboardString(window_, text.c_str());
}

}  // namespace dsphere::viewer
