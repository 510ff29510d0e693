// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>
#include <sstream>

#include "tools/expect.hpp"

namespace gloam::test {
namespace usage_test {

using testing::HasSubstr;

TEST(Usage, HelpNamesEveryCommand) {
    const CommandResult result = run_command({"--help"});
    expect_success(result);
    for (const char* command :
         {"demo", "devices", "list", "check", "report", "render", "bench", "stress", "pack"}) {
        EXPECT_THAT(result.out, HasSubstr(command));
        const CommandResult help = run_command({command, "--help"});
        expect_success(help);
        EXPECT_THAT(help.out, HasSubstr(command));
    }
}

TEST(Usage, UnknownOptionIsNamed) {
    expect_could_not_run(run_command({"--no-such-option"}), "--no-such-option");
    for (const char* command : {"demo", "devices", "list", "check", "render", "stress"}) {
        expect_could_not_run(run_command({command, "--no-such-option"}), "--no-such-option");
    }
    expect_could_not_run(run_command({"pack", "gloam/geometry/background.glsl", "--no-such-option"}),
                         "--no-such-option");
}

TEST(Usage, UnknownCommandIsNamed) {
    expect_could_not_run(run_command({"no-such-command"}), "no-such-command");
}

TEST(Usage, ACommandIsNeeded) {
    expect_could_not_run(run_command({}), "subcommand");
}

TEST(Devices, AreListedWithTheirFloatControls) {
    const CommandResult text = run_command({"devices"});
    expect_success(text);
    EXPECT_THAT(text.out, testing::StartsWith("0: "));
    EXPECT_THAT(text.out, HasSubstr("subnormals"));

    const CommandResult result = run_command({"devices", "--json"});
    expect_success(result);
    const auto devices = nlohmann::json::parse(result.out);
    ASSERT_FALSE(devices.empty());
    for (std::size_t i = 0; i < devices.size(); ++i) {
        EXPECT_EQ(devices[i].at("index"), i);
        EXPECT_NE(devices[i].at("name"), "");
        EXPECT_TRUE(devices[i].at("float32").at("denorm_preserve").is_boolean());
    }
}

TEST(Devices, NoneIsOneClearLine) {
    const CommandOptions none{
        .environment = {"VK_ICD_FILENAMES=/no/such/driver.json", "VK_DRIVER_FILES=/no/such/driver.json"}};
    expect_could_not_run(run_command({"devices"}, none), "Vulkan");
    expect_could_not_run(run_command({"check", "gloam_radical_inverse_base2"}, none), "Vulkan");
}

TEST(List, NamesOneALine) {
    for (const char* kind : {"equations", "methods", "presets", "scenes", "variants"}) {
        const CommandResult result = run_command({"list", kind});
        expect_success(result);
        std::istringstream lines(result.out);
        std::vector<std::string> names;
        for (std::string name; std::getline(lines, name);) names.push_back(name);
        EXPECT_FALSE(names.empty()) << kind;

        const auto json = nlohmann::json::parse(run_command({"list", kind, "--json"}).out);
        ASSERT_EQ(json.size(), names.size()) << kind;
        for (std::size_t i = 0; i < names.size(); ++i) {
            EXPECT_EQ(json[i].at("name"), names[i]);
            EXPECT_THAT(names[i], testing::Not(HasSubstr(" ")));
        }
    }
}

TEST(List, UnknownKindIsNamedWithThoseThereAre) {
    const CommandResult result = run_command({"list", "no-such-kind"});
    expect_could_not_run(result, "no-such-kind");
    EXPECT_THAT(result.err, HasSubstr("equations"));
}

}  // namespace usage_test
}  // namespace gloam::test
