#include "scene/motion.h"

#include "base/error.h"
#include "base/limits.h"
#include "scene/textfile.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <vector>

namespace dsphere {

namespace {

constexpr std::string_view kSpaces = " \t\r";

struct ColumnRule {
    const char* name;
    double least, greatest;
    bool above_least = false;  ///< the least value itself is not allowed
    Between between = Between::Linear;
};

constexpr double kFar = limits::kGreatestCoordinate;
constexpr double kTurns = 1e9;          // degrees
constexpr double kGreatestFrame = 1e9;  // 386 days of film
constexpr double kLeastStep = 1e-6;     // between the frames of two keys

// In the order of Motion::Column.
constexpr ColumnRule kRules[] = {
    {"eye_x", -kFar, kFar},
    {"eye_y", -kFar, kFar},
    {"eye_z", -kFar, kFar},
    {"look_x", -kFar, kFar},
    {"look_y", -kFar, kFar},
    {"look_z", -kFar, kFar},
    {"up_x", -kFar, kFar},
    {"up_y", -kFar, kFar},
    {"up_z", -kFar, kFar},
    {"lat", -90.0, 90.0},
    {"lon", -kTurns, kTurns, false, Between::Angle},
    {"alt", 0.0, kFar, true, Between::Logarithm},
    {"heading", -kTurns, kTurns, false, Between::Angle},
    {"pitch", -90.0, 90.0},
    {"roll", -kTurns, kTurns, false, Between::Angle},
    {"fov", limits::kFov.least, limits::kFov.greatest},
    {"sun_lon", -kTurns, kTurns, false, Between::Angle},
    {"sun_lat", -90.0, 90.0},
    {"exaggeration", -kFar, kFar},
    {"exposure", -1000.0, 1000.0},
};
constexpr int kFrame = -1;

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(kSpaces);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kSpaces) - first + 1);
}

std::vector<std::string_view> split(std::string_view line, char at) {
    std::vector<std::string_view> words;
    for (;;) {
        const std::size_t end = std::min(line.find(at), line.size());
        words.push_back(trimmed(line.substr(0, end)));
        if (end == line.size()) return words;
        line.remove_prefix(end + 1);
    }
}

}  // namespace

/// Reads one file, line by line.
class MotionReader {
  public:
    MotionReader(std::string_view text, const std::string& name) : text_(text) {
        motion_.name_ = name;
        for (std::size_t i = 0; i < std::size(kRules); ++i) motion_.tracks_[i] = Track(kRules[i].between);
    }

    Motion read() {
        if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
        for (std::string_view rest = text_; !rest.empty();) {
            const std::size_t end = std::min(rest.find('\n'), rest.size());
            const std::string_view line = trimmed(rest.substr(0, end));
            rest.remove_prefix(std::min(end + 1, rest.size()));
            ++line_;
            if (line.empty()) continue;
            if (columns_.empty())
                readHeader(line);
            else
                readKey(line, motion_.keys_++);
        }
        if (columns_.empty()) throwInvalid("{}: is empty; expected a line that names the columns", motion_.name_);
        if (motion_.keys_ == 0) throwInvalid("{}: has no keys below the line that names the columns", motion_.name_);
        checkFilled();
        return std::move(motion_);
    }

  private:
    template <typename... Args>
    [[noreturn]] void fail(const std::string& column, fmt::format_string<Args...> format, Args&&... args) const {
        throwInvalid("{}:{}: column {}: {}", motion_.name_, line_, column,
                     fmt::format(format, std::forward<Args>(args)...));
    }

    static std::string nameOf(int column) { return column == kFrame ? "frame" : kRules[column].name; }
    bool named(int column) const { return std::ranges::find(columns_, column) != columns_.end(); }

    void readHeader(std::string_view line) {
        for (const std::string_view word : split(line, ',')) {
            const auto rule = std::ranges::find(kRules, word, &ColumnRule::name);
            const int column = word == "frame" ? kFrame : int(rule - std::begin(kRules));
            if (column == int(std::size(kRules))) {
                std::vector<std::string> known = {"frame"};
                for (const ColumnRule& one : kRules) known.emplace_back(one.name);
                fail(fmt::format("{:?}", word), "is unknown; there are {}", fmt::join(known, ", "));
            }
            if (named(column)) fail(nameOf(column), "stands there twice");
            columns_.push_back(column);
        }
        requireTogether({Motion::EyeX, Motion::EyeY, Motion::EyeZ});
        requireTogether({Motion::LookX, Motion::LookY, Motion::LookZ});
        requireTogether({Motion::UpX, Motion::UpY, Motion::UpZ});
        requireTogether({Motion::Latitude, Motion::Longitude, Motion::Altitude});
        requireTogether({Motion::SunLongitude, Motion::SunLatitude});
        for (const int column : {Motion::Heading, Motion::Pitch, Motion::Roll})
            if (named(column) && !named(Motion::Latitude)) fail(nameOf(column), "needs lat, lon and alt");
        for (const int column : {Motion::EyeX, Motion::LookX, Motion::UpX})
            if (named(column) && named(Motion::Latitude)) fail(nameOf(column), "and lat exclude each other");
    }

    void requireTogether(std::initializer_list<int> group) const {
        const auto isNamed = [this](int column) { return named(column); };
        const auto missing = std::ranges::find_if_not(group, isNamed);
        const auto present = std::ranges::find_if(group, isNamed);
        if (missing != group.end() && present != group.end())
            fail(nameOf(*present), "needs {} beside it", nameOf(*missing));
    }

    double number(int column, std::string_view word) const {
        double value = 0.0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
            fail(nameOf(column), "expected a number, not {:?}", word);
        if (column == kFrame) return value;
        const ColumnRule& rule = kRules[column];
        if (value < rule.least || (rule.above_least && value == rule.least))
            fail(nameOf(column), "expected {} {}, not {}", rule.above_least ? "more than" : "at least", rule.least,
                 value);
        if (value > rule.greatest) fail(nameOf(column), "expected at most {}, not {}", rule.greatest, value);
        return value;
    }

    void readKey(std::string_view line, int row) {
        const std::vector<std::string_view> words = split(line, ',');
        if (words.size() != columns_.size())
            throwInvalid("{}:{}: has {} values for {} columns", motion_.name_, line_, words.size(), columns_.size());
        const auto at = std::ranges::find(columns_, kFrame);
        const double frame = at == columns_.end() ? row : number(kFrame, words[std::size_t(at - columns_.begin())]);
        double& last = motion_.last_frame_;
        if (std::abs(frame) > kGreatestFrame)
            fail("frame", "expected {} to {}, not {}", -kGreatestFrame, kGreatestFrame, frame);
        if (row > 0 && !(frame >= last + kLeastStep))
            fail("frame", "{} comes after {}; frames must grow, by at least {}", frame, last, kLeastStep);
        last = frame;
        for (std::size_t i = 0; i < words.size(); ++i) {
            if (columns_[i] == kFrame || words[i].empty()) continue;
            const double value = number(columns_[i], words[i]);
            motion_.tracks_[std::size_t(columns_[i])].add(frame, value);
            if (columns_[i] != Motion::Fov) continue;
            motion_.least_fov_ = std::min(motion_.least_fov_, value);
            motion_.greatest_fov_ = std::max(motion_.greatest_fov_, value);
        }
    }

    void checkFilled() const {
        for (const int column : columns_)
            if (column != kFrame && motion_.tracks_[std::size_t(column)].empty())
                throwInvalid("{}: column {}: has no value in any row", motion_.name_, nameOf(column));
    }

    std::string_view text_;
    Motion motion_;
    std::vector<int> columns_;  ///< kFrame or a Motion::Column, from left to right
    int line_ = 0;
};

Motion Motion::parse(std::string_view text, const std::string& name) {
    return MotionReader(text, name).read();
}

Motion Motion::read(const std::filesystem::path& path) {
    std::string text;
    try {
        text = readText(path, limits::kTextBytes);
    } catch (const Error&) {
        throw;
    } catch (const std::runtime_error& error) {
        throwInvalid("--path: {}", error.what());
    }
    return parse(text, path.string());
}

}  // namespace dsphere
