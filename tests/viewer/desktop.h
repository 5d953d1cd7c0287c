#pragma once

// An X server, the viewer in it, and a hand.

#include <nlohmann/json.hpp>

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace dsphere::test {

/// A process of the test's own, ended with the object.
class Process {
  public:
    /// `environment` is NAME=value, besides the test's own. Standard output goes to `out`, errors to `err`; unset:
    /// away.
    Process(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
            const std::filesystem::path& folder, const std::filesystem::path& out, const std::filesystem::path& err);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    bool running();
    /// Waits up to `seconds` for its end; the exit code, or -1 if it goes on, or minus the signal that ended it.
    int finish(double seconds);

  private:
    pid_t pid_;
    int code_ = -1;
    bool over_ = false;
};

/// Whether the programs that the test drives are here.
bool desktopAvailable();

class Desktop {
  public:
    explicit Desktop(const std::filesystem::path& folder);

    const std::string& display() const { return display_; }
    /// Runs xdotool; false if it fails.
    bool hand(const std::string& arguments) const;
    /// Moves the pressed pointer in steps.
    void drag(int x0, int y0, int x1, int y1, int button = 1) const;
    /// Drops a file on the window.
    bool drop(const std::filesystem::path& file) const;

  private:
    std::filesystem::path folder_;
    std::unique_ptr<Process> server_;
    std::string display_;
};

/// `dsphere view`, whose journal tells what the window shows.
class Viewing {
  public:
    Viewing(const Desktop& desktop, const std::filesystem::path& folder, std::vector<std::string> arguments);

    std::vector<nlohmann::json> lines() const;
    nlohmann::json last() const;
    /// Waits until the newest frame is so, or fails the test with what it was.
    nlohmann::json waitFor(const std::string& what, const std::function<bool(const nlohmann::json&)>& so);
    /// Until the still view has all its samples.
    nlohmann::json waitForStill();

    /// The middle of a control that the last frame showed, by its label: "x y" for xdotool.
    std::string place(const std::string& label);

    int finish() { return process_.finish(20.0); }
    std::string errors() const;
    std::string output() const;

  private:
    std::filesystem::path folder_;
    Process process_;
};

}  // namespace dsphere::test
