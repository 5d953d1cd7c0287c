#include "tests/cli/fixture.h"

#include <nlohmann/json.hpp>

namespace dsphere::test {
namespace {

using nlohmann::json;

TEST_F(CliTest, DevicesAsText) {
    Outcome outcome = run({"devices"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out.rfind("0  ", 0), 0u) << outcome.out;
    EXPECT_TRUE(holds(outcome.out, "Vulkan 1."));
}

TEST_F(CliTest, DevicesAsJson) {
    Outcome outcome = run({"devices", "--json"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "");
    json list = json::parse(outcome.out);
    ASSERT_FALSE(list.empty());
    for (std::size_t i = 0; i < list.size(); ++i) {
        EXPECT_EQ(list[i].at("index").get<std::size_t>(), i);
        for (const char* name : {"name", "type", "driver", "api_version", "unusable_reason"})
            EXPECT_TRUE(list[i].at(name).is_string()) << name;
        EXPECT_EQ(list[i].at("usable").get<bool>(), list[i].at("unusable_reason").get<std::string>().empty());
    }
}

TEST_F(CliTest, DevicesAreChosenByIndexAndByName) {
    json list = json::parse(run({"devices", "--json"}).out);
    for (const json& device : list) {
        if (!device.at("usable").get<bool>()) continue;
        std::string index = std::to_string(device.at("index").get<int>());
        Outcome outcome = run({"render", "planet.pbrt", "--quick", "--json", "--device", index});
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(json::parse(outcome.out).at("device"), device.at("name"));
        std::string part = device.at("name").get<std::string>().substr(0, 5);
        EXPECT_EQ(run({"render", "planet.pbrt", "--quick", "--device", part}).code, 0);
    }
}

}  // namespace
}  // namespace dsphere::test
