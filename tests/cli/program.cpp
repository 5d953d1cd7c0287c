#include "tests/cli/program.h"

#include "base/error.h"

#include <fcntl.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <memory>

namespace dsphere::test {
namespace {

/// A file without a name, for what the program reads or writes.
class Spool {
  public:
    explicit Spool(const std::string& text = "") : file_(std::tmpfile(), &std::fclose) {
        if (!file_) throwFailure("no temporary file: {}", lastSystemError());
        std::fwrite(text.data(), 1, text.size(), file_.get());
        std::fflush(file_.get());
        std::rewind(file_.get());
    }
    int descriptor() const { return fileno(file_.get()); }
    std::string text() const {
        std::string all(std::size_t(lseek(descriptor(), 0, SEEK_END)), '\0');
        all.resize(std::size_t(std::max<ssize_t>(0, pread(descriptor(), all.data(), all.size(), 0))));
        return all;
    }

  private:
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

void redirect(int stream, const std::string& to) {
    if (to.empty()) return;
    close(stream);
    if (to == kClosed) return;
    const int file = open(to.c_str(), O_WRONLY);
    if (file < 0) std::_Exit(127);
    dup2(file, stream);
    if (file != stream) close(file);
}

[[noreturn]] void become(const Launch& launch, int in, int out, int err) {
    dup2(in, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    redirect(STDOUT_FILENO, launch.out_to);
    redirect(STDERR_FILENO, launch.err_to);
    for (const auto& [resource, most] : launch.limits) {
        const rlimit limit = {most, most};
        setrlimit(resource, &limit);
    }
    if (chdir(launch.folder.c_str()) != 0) std::_Exit(127);
    unsetenv("NO_COLOR");
    // Leaks of the driver, which the program cannot help; those of ours are the gpu tests' business.
    setenv("ASAN_OPTIONS", "detect_leaks=0", 1);
    for (const std::string& entry : launch.environment) putenv(strdup(entry.c_str()));
    std::vector<char*> arguments = {strdup("dsphere")};
    for (const std::string& word : launch.arguments) arguments.push_back(strdup(word.c_str()));
    arguments.push_back(nullptr);
    execv(DSPHERE_PROGRAM, arguments.data());
    std::_Exit(127);
}

// Until the program has gone, which a terminal tells by an error.
std::string readTerminal(int master) {
    std::string all;
    char part[4096];
    for (ssize_t n; (n = read(master, part, sizeof part)) > 0;) all.append(part, std::size_t(n));
    return all;
}

int codeOf(int status) {
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

}  // namespace

Outcome launch(const Launch& launch) {
    Spool in(launch.input), out, err;
    int master = -1, slave = -1;
    if (launch.terminal && openpty(&master, &slave, nullptr, nullptr, nullptr) != 0)
        throwFailure("no terminal: {}", lastSystemError());
    pid_t child = fork();
    if (child < 0) throwFailure("no process: {}", lastSystemError());
    if (child == 0) become(launch, in.descriptor(), out.descriptor(), launch.terminal ? slave : err.descriptor());

    Outcome outcome;
    int status = 0;
    if (launch.terminal) {
        close(slave);
        outcome.err = readTerminal(master);
        close(master);
    }
    if (launch.signal != 0) {
        if (launch.signal_after_ms >= 0) usleep(useconds_t(1000 * launch.signal_after_ms));
        while (launch.signal_after_ms < 0 && err.text().size() < 8 && waitpid(child, &status, WNOHANG) == 0)
            usleep(10000);
        kill(child, launch.signal);
    }
    rusage usage = {};
    wait4(child, &status, 0, &usage);
    outcome.code = codeOf(status);
    outcome.peak_kib = usage.ru_maxrss;
    outcome.out = out.text();
    if (!launch.terminal) outcome.err = err.text();
    return outcome;
}

}  // namespace dsphere::test
