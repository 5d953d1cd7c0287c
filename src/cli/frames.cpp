#include "cli/frames.h"

#include "base/error.h"
#include "base/jobqueue.h"

#include <charconv>
#include <chrono>

namespace dsphere::cli {

namespace {

// A picture that waits for its encoder holds its memory.
constexpr std::size_t kMostWaiting = 2;
constexpr int kMostFrames = 10'000'000;

using Clock = std::chrono::steady_clock;

double elapsedSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

void addFrameOptions(CLI::App& command, FrameOptions& options) {
    command
        .add_option(
            "--frames", options.frames,
            "Render these frames into files that are named by -o with the frame's number in place of %d or %04d")
        ->type_name("A-B[:STEP]");
    command.add_option("--path", options.path, "What moves in --frames: a table of keys, see docs/farm.md")
        ->type_name("FILE.csv");
    command
        .add_option("--turntable", options.turntable,
                    "The shapes turn once around in N frames, before camera and lights that stay; --frames 0-(N-1) "
                    "unless given")
        ->type_name("N");
    command.add_flag("--skip-existing", options.skip_existing, "With --frames: leave out frames whose file is there");
}

FrameName::FrameName(const std::string& pattern) {
    const auto fail = [&pattern](const char* what) {
        throwUsage(
            "--frames: the outfile {} {}; expected one %d, or %04d for four digits, in the file's name: frame-%04d.png",
            pattern, what);
    };
    const std::size_t percent = pattern.find('%');
    if (percent == std::string::npos) fail("has no place for the frame's number");
    std::size_t end = percent + 1;
    while (end < pattern.size() && pattern[end] >= '0' && pattern[end] <= '9') ++end;
    if (end == pattern.size() || pattern[end] != 'd' || end - percent > 3) fail("has a % without its d");
    if (end > percent + 1) std::from_chars(pattern.data() + percent + 1, pattern.data() + end, digits_);
    before_ = pattern.substr(0, percent);
    after_ = pattern.substr(end + 1);
    if (after_.find('%') != std::string::npos) fail("has more than one %");
    if (after_.find('/') != std::string::npos) fail("has the number in a folder's name");
}

std::filesystem::path FrameName::of(int frame) const {
    return fmt::format("{}{:0{}}{}", before_, frame, digits_, after_);
}

FrameRange FrameRange::parse(const std::string& text) {
    FrameRange range;
    const char *at = text.data(), *end = text.data() + text.size();
    const auto takeNumber = [&](int& value) {
        if (at == end || *at == '-') return false;
        const auto [next, error] = std::from_chars(at, end, value);
        at = next;
        return error == std::errc() && value <= kMostFrames;
    };
    const auto takeMark = [&](char mark) {
        if (at == end || *at != mark) return false;
        ++at;
        return true;
    };
    bool good = takeNumber(range.first);
    range.last = range.first;
    if (good && takeMark('-')) good = takeNumber(range.last);
    if (good && takeMark(':')) good = takeNumber(range.step);
    if (!good || at != end || range.step < 1)
        throwUsage("--frames: {:?} is not A-B or A-B:STEP with numbers from 0 to {}", text, kMostFrames);
    if (range.last < range.first) throwUsage("--frames: {} comes before {}", range.last, range.first);
    return range;
}

FramePlan::FramePlan(const FrameOptions& options, const std::string& outfile)
    : name(outfile), turntable(options.turntable), skip_existing(options.skip_existing) {
    if (turntable < 0 || turntable > kMostFrames)
        throwUsage("--turntable: {} is outside 1 to {}", turntable, kMostFrames);
    if (turntable > 0 && !options.path.empty()) throwUsage("--turntable and --path exclude each other");
    if (options.frames.empty() && turntable == 0) throwUsage("--path needs --frames A-B");
    range = options.frames.empty() ? FrameRange{0, turntable - 1} : FrameRange::parse(options.frames);
    if (!options.path.empty()) motion = Motion::read(options.path);
}

Scene FramePlan::sceneAt(const Scene& scene, int frame) const {
    if (motion) return motion->at(scene, frame);
    Scene turned = scene;
    if (turntable > 0) turnTable(turned, 360.0 * (frame % turntable) / turntable);
    return turned;
}

std::vector<int> FramePlan::missing() const {
    std::vector<int> numbers;
    for (int k = 0; k < range.count(); ++k) {
        const int number = range.first + k * range.step;
        if (!skip_existing || !std::filesystem::exists(name.of(number))) numbers.push_back(number);
    }
    return numbers;
}

void FrameNotices::add(int frame, const Notices& notices) {
    if (notices.empty()) return;
    if (first_frame_ < 0) first_frame_ = frame;
    if (frame != first_frame_) {
        others_.insert(frame);
        return;
    }
    for (const Notice& notice : notices)
        first_.push_back({notice.kind, fmt::format("frame {}: {}", frame, notice.text)});
}

Notices FrameNotices::all() const {
    Notices all = first_;
    if (!others_.empty())
        all.push_back({Notice::Kind::Warning, fmt::format("other frames with warnings: {}", others_.size())});
    return all;
}

void renderFrames(const FramePlan& plan, const std::vector<int>& numbers, const Scene& scene, ProgressLine& line,
                  FrameCounts& counts, const RenderFrame& render) {
    const Clock::time_point start = Clock::now();
    JobQueue writer(kMostWaiting);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        Frame frame{numbers[k], plan.name.of(numbers[k]), plan.sceneAt(scene, numbers[k]), {}};
        if (plan.motion) frame.exposure = plan.motion->exposureAt(frame.number);
        const auto progress = [&](double share) {
            if (line.update((double(k) + share) / double(numbers.size()))) return true;
            writer.finish();
            throw Error(ExitCode::Interrupted,
                        fmt::format("interrupted in frame {}; the frames before are written; go on by the same command "
                                    "with --skip-existing",
                                    numbers[k]));
        };
        writer.add([&counts, write = render(std::move(frame), progress)] {
            const Clock::time_point begun = Clock::now();
            write();
            counts.writing_seconds += elapsedSince(begun);
            ++counts.written;
        });
    }
    writer.finish();
    counts.seconds = elapsedSince(start);
}

}  // namespace dsphere::cli
