#pragma once

// What commands say. Neither stream's failure throws: standard error's is nobody's to hear, standard output's is kept
// for finishOutput(), after the files of a command are written.

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <string>
#include <string_view>
#include <utility>

namespace dsphere::cli {

/// Gives each standard stream that is closed a place where nothing is written, so that no file is opened in its stead
/// and takes what is said for its contents.
void openClosedStreams();

/// Words out of a file for a terminal: control characters, which could steer it, as \x1b, and at most 4096 bytes.
std::string printable(std::string_view text);

void printText(std::string_view text);
void printErrorText(std::string_view text);

/// To standard output.
template <typename... Args>
void print(fmt::format_string<Args...> format, Args&&... args) {
    printText(fmt::format(format, std::forward<Args>(args)...));
}

/// To standard error.
template <typename... Args>
void printErr(fmt::format_string<Args...> format, Args&&... args) {
    printErrorText(fmt::format(format, std::forward<Args>(args)...));
}

/// Names of files may hold bytes that are no UTF-8, which JSON cannot: U+FFFD stands for them.
template <typename Json>
std::string jsonText(const Json& json) {
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

/// Error (Failure) when not all of what was printed arrived.
void finishOutput();

}  // namespace dsphere::cli
