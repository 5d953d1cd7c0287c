#include "tests/viewer/desktop.h"

#include "tests/support/tempfolder.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <sstream>
#include <thread>

namespace dsphere::test {

namespace {

using nlohmann::json;

constexpr double kPatience = 60.0;  // seconds; machines that run many tests at once are slow

void pause(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

void redirect(const std::filesystem::path& file, int descriptor) {
    int opened = open(file.empty() ? "/dev/null" : file.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0644);
    dup2(opened, descriptor);
}

bool found(const char* program) {
    return std::system((std::string("command -v ") + program + " >/dev/null 2>&1").c_str()) == 0;
}

}  // namespace

Process::Process(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
                 const std::filesystem::path& folder, const std::filesystem::path& out,
                 const std::filesystem::path& err)
    : pid_(fork()) {
    if (pid_ != 0) return;
    if (chdir(folder.c_str()) != 0) _exit(126);
    redirect(out, STDOUT_FILENO);
    redirect(err, STDERR_FILENO);
    for (const std::string& entry : environment) putenv(strdup(entry.c_str()));
    std::vector<char*> words;
    for (const std::string& word : arguments) words.push_back(strdup(word.c_str()));
    words.push_back(nullptr);
    execvp(words[0], words.data());
    _exit(127);
}

Process::~Process() {
    if (!running()) return;
    kill(pid_, SIGTERM);
    if (finish(5.0) >= 0 || over_) return;
    kill(pid_, SIGKILL);
    finish(5.0);
}

bool Process::running() {
    int status = 0;
    if (!over_ && waitpid(pid_, &status, WNOHANG) == pid_) {
        over_ = true;
        code_ = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    }
    return !over_;
}

int Process::finish(double seconds) {
    for (double waited = 0.0; running() && waited < seconds; waited += 0.02) pause(0.02);
    return over_ ? code_ : -1;
}

bool desktopAvailable() {
    return found("Xvfb") && found("xdotool");
}

Desktop::Desktop(const std::filesystem::path& folder) : folder_(folder) {
    // The server chooses a free display and writes its number.
    server_ = std::make_unique<Process>(
        std::vector<std::string>{"Xvfb", "-displayfd", "1", "-screen", "0", "1024x768x24", "-nolisten", "tcp"},
        std::vector<std::string>{}, folder, folder / "display", std::filesystem::path());
    for (double waited = 0.0; waited < kPatience && display_.empty(); waited += 0.02) {
        std::string text = readBytes(folder / "display");
        if (text.find('\n') != std::string::npos) display_ = ":" + text.substr(0, text.find('\n'));
        pause(0.02);
    }
}

bool Desktop::hand(const std::string& arguments) const {
    return std::system(("DISPLAY=" + display_ + " xdotool " + arguments).c_str()) == 0;
}

void Desktop::drag(int x0, int y0, int x1, int y1, int button) const {
    std::ostringstream command;
    command << "mousemove " << x0 << ' ' << y0 << " sleep 0.05 mousedown " << button;
    for (int i = 1; i <= 10; ++i)
        command << " mousemove " << x0 + (x1 - x0) * i / 10 << ' ' << y0 + (y1 - y0) * i / 10 << " sleep 0.02";
    command << " mouseup " << button;
    EXPECT_TRUE(hand(command.str()));
}

bool Desktop::drop(const std::filesystem::path& file) const {
    return std::system(("DISPLAY=" + display_ + " " DSPHERE_DROPFILE " " + file.string()).c_str()) == 0;
}

Viewing::Viewing(const Desktop& desktop, const std::filesystem::path& folder, std::vector<std::string> arguments)
    : folder_(folder),
      process_(
          [&] {
              std::vector<std::string> words = {DSPHERE_PROGRAM, "view", "--validation", "--journal", "journal"};
              words.insert(words.end(), arguments.begin(), arguments.end());
              std::filesystem::remove(folder / "journal");  // another window's
              return words;
          }(),
          {"DISPLAY=" + desktop.display(), "XDG_CACHE_HOME=" + (folder / "cache").string(),
           "XDG_STATE_HOME=" + (folder / "state").string(), DSPHERE_SHADER_CACHE, "ASAN_OPTIONS=detect_leaks=0"},
          folder, folder / "output", folder / "errors") {}

std::vector<json> Viewing::lines() const {
    std::istringstream text(readBytes(folder_ / "journal"));
    std::vector<json> result;
    std::string line;
    while (std::getline(text, line) && !text.eof()) result.push_back(json::parse(line));
    return result;
}

json Viewing::last() const {
    std::string text = readBytes(folder_ / "journal");
    std::size_t end = text.rfind('\n');
    if (end == std::string::npos) return {};
    std::size_t start = end == 0 ? std::string::npos : text.rfind('\n', end - 1);
    start = start == std::string::npos ? 0 : start + 1;
    return json::parse(text.substr(start, end - start));
}

json Viewing::waitFor(const std::string& what, const std::function<bool(const json&)>& so) {
    json seen = json::object();
    for (double waited = 0.0; waited < kPatience; waited += 0.03) {
        seen = last();
        if (!seen.is_null() && so(seen)) return seen;
        if (!process_.running()) break;
        pause(0.03);
    }
    seen.erase("places");
    ADD_FAILURE() << "never: " << what << "\nlast: " << seen.dump() << "\n" << errors();
    return seen;
}

json Viewing::waitForStill() {
    return waitFor("a still view", [](const json& frame) {
        return !frame.at("busy") && !frame.at("draft") && frame.at("target") > 0 &&
               frame.at("samples") == frame.at("target");
    });
}

std::string Viewing::place(const std::string& label) {
    const json frame = waitFor("the control " + label, [&](const json& seen) {
        return seen.contains("places") && seen.at("places").contains(label);
    });
    if (!frame.contains("places") || !frame.at("places").contains(label)) return "0 0";
    const json& box = frame.at("places").at(label);
    const auto middle = [&](int low, int high) {
        return std::to_string(int(0.5 * (box[low].get<double>() + box[high].get<double>())));
    };
    return middle(0, 2) + " " + middle(1, 3);
}

std::string Viewing::output() const {
    return readBytes(folder_ / "output");
}

std::string Viewing::errors() const {
    return readBytes(folder_ / "errors");
}

}  // namespace dsphere::test
