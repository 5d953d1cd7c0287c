#include "cli/usage.h"

#include "base/error.h"
#include "cli/sceneoptions.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <numeric>
#include <string_view>
#include <vector>

namespace dsphere::cli {

namespace {

/// How many letters must be changed, added or dropped to make one word of the other (Levenshtein 1966).
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t(0));
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

std::vector<std::string> commandsOf(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    return names;
}

[[noreturn]] void throwNoCommand(const CLI::App& app, const std::string& word) {
    std::error_code ignored;
    if (std::filesystem::exists(word, ignored) || word.ends_with(".pbrt"))
        throwUsage(
            "{} is a file, not a command: dsphere render {} -o picture.png makes a picture of a "
            "scene or map, dsphere view {} shows it",
            word, word, word);
    const std::vector<std::string> names = commandsOf(app);
    const auto nearest =
        std::ranges::min_element(names, {}, [&](const std::string& name) { return editDistance(word, name); });
    if (editDistance(word, *nearest) <= std::max<std::size_t>(1, word.size() / 3))
        throwUsage("{}: no such command; dsphere {}?", word, *nearest);
    throwUsage("{}: no such command; there are {}", word, fmt::join(names, ", "));
}

std::string upperCase(std::string word) {
    std::ranges::transform(word, word.begin(), [](unsigned char c) { return char(std::toupper(c)); });
    return word;
}

/// "render SCENE": the command and what it cannot do without.
std::string usageOf(const CLI::App& command) {
    std::string usage = command.get_name();
    for (const CLI::Option* option : command.get_options())
        if (option->get_required())
            usage += option->get_positional() ? " " + upperCase(option->get_name())
                                              : " " + option->get_name() + " " + option->get_type_name();
    return usage;
}

}  // namespace

void checkArguments(const CLI::App& app, int argc, const char* const* argv) {
    for (int k = 1; k < argc; ++k) {
        const std::string_view word = argv[k];
        if (word.empty()) throwUsage("{}: its value is empty", k > 1 ? argv[k - 1] : "the command line's first word");
        if (word.starts_with("--") && word.ends_with("="))
            throwUsage("{}: its value is empty", word.substr(0, word.size() - 1));
    }
    if (argc < 2 || argv[1][0] == '-') return;
    const std::vector<std::string> names = commandsOf(app);
    if (std::ranges::find(names, argv[1]) == names.end()) throwNoCommand(app, argv[1]);
}

std::string explained(const CLI::App& app, const CLI::ParseError& error) {
    const std::vector<CLI::App*> given = app.get_subcommands();
    if (given.empty()) return fmt::format("{}; see dsphere --help", error.what());
    const CLI::App& command = *given.front();
    const bool missing = error.get_exit_code() == int(CLI::ExitCodes::RequiredError);
    const std::string hint = missing ? fmt::format("; give it: dsphere {}", usageOf(command)) : std::string();
    return fmt::format("{}{}; see dsphere {} --help", error.what(), hint, command.get_name());
}

}  // namespace dsphere::cli
