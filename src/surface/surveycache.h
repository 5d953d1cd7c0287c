#pragma once

#include "surface/survey.h"

#include <cstdint>
#include <optional>
#include <utility>

namespace dsphere {

/// Surveys in the cache folder, by a key that stands for all that they depend on. A file that is damaged, cut short, or
/// of another version counts as absent; so does everything where there is no such folder. Two writers at once leave one
/// whole file. Once kMostBytes are exceeded the files that were not used for the longest time are removed.
struct SurveyCache {
    static constexpr std::uint64_t kMostBytes = std::uint64_t(4) << 30;

    /// Whether there is a file of that key, sound or not.
    static bool has(std::uint64_t key);
    static std::optional<std::pair<Gaps, Survey>> load(std::uint64_t key);
    /// Failure to keep it is silent: it costs time at the next start alone.
    static void keep(std::uint64_t key, const Gaps& gaps, const Survey& survey);
};

}  // namespace dsphere
