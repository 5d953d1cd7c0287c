#include "cli/commands.h"
#include "cli/print.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace dsphere::cli {

namespace {

int runDevices(bool json) {
    std::vector<gpu::DeviceInfo> devices = namingTheHost(gpu::listDevices);
    if (json) {
        nlohmann::ordered_json list = nlohmann::ordered_json::array();
        for (const auto& device : devices)
            list.push_back({{"index", device.index},
                            {"name", device.name},
                            {"type", device.type},
                            {"driver", device.driver},
                            {"api_version", device.api_version},
                            {"usable", device.usable},
                            {"unusable_reason", device.unusable_reason}});
        printText(jsonText(list));
        return 0;
    }
    for (const auto& device : devices)
        print("{}  {}  ({}, {}, Vulkan {}){}\n", device.index, device.name, device.type, device.driver,
              device.api_version, device.usable ? "" : "  unusable: " + device.unusable_reason);
    return 0;
}

}  // namespace

void addDevices(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("devices", "List the Vulkan devices of this machine");
    auto json = std::make_shared<bool>(false);
    command->add_flag("--json", *json, "Print as JSON");
    command->callback([json, &action] { action = [json] { return runDevices(*json); }; });
}

}  // namespace dsphere::cli
