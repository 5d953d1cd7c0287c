#pragma once

#include "report/results.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>

namespace dsphere::report {

nlohmann::ordered_json toJson(const Results& results);

/// Error (InvalidInput), prefixed by `name`, when a field is missing or of another kind.
Results fromJson(const nlohmann::ordered_json& json, const std::string& name);

/// What --json-file wrote. Error (InvalidInput) for a file that cannot be read or is something else.
Results readResults(const std::filesystem::path& path);

}  // namespace dsphere::report
