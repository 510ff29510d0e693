// SPDX-License-Identifier: MIT
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "gpu/drivers.hpp"
#include "tools/expect.hpp"

namespace gloam::test {
namespace drivers_test {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

json devices(std::vector<std::string> arguments = {}, const CommandOptions& options = {}) {
    arguments.insert(arguments.begin(), {"devices", "--json"});
    const CommandResult result = run_command(arguments, options);
    expect_success(result);
    return json::parse(result.out);
}

std::size_t swiftshaders(const json& devices) {
    return static_cast<std::size_t>(std::count_if(devices.begin(), devices.end(), [](const json& device) {
        return device.at("name").get<std::string>().find("SwiftShader") != std::string::npos;
    }));
}

TEST(Drivers, WhatIsNoManifestIsNamedByEveryCommand) {
    const TemporaryDirectory folder;
    const std::string missing = (folder.path() / "missing.json").string();
    const std::string malformed = (folder.path() / "malformed.json").string();
    std::ofstream(malformed) << R"({"ICD": )";
    for (const char* command : {"check", "demo", "devices", "render"}) {
        expect_could_not_run(run_command({command, "--driver", missing}), missing + ": no such file");
        expect_could_not_run(run_command({command, "--driver", malformed}),
                             malformed + ": not a driver manifest");
    }
    expect_could_not_run(run_command({"devices", "--driver"}), "--driver");
}

TEST(Drivers, TheOptionTakesOneFileAndMayBeRepeated) {
    const TemporaryDirectory folder;
    const auto manifest = [&folder](const std::string& name, const std::string& library) {
        const std::string path = (folder.path() / name).string();
        std::ofstream(path) << json{{"ICD", {{"library_path", library}}}};
        return path;
    };
    const std::string first = manifest("first.json", "libno_such_driver.so");
    const std::string second = manifest("second.json", "./gone.so");
    const CommandResult result =
        run_command({"check", "--driver", first, "--driver", second, "gloam_radical_inverse_base2"});
    expect_could_not_run(result, "second.json");
    EXPECT_THAT(result.err, HasSubstr("gone.so"));
    // A name that the system does not find: the loader passes over it.
    expect_success(
        run_command({"check", "--driver", first, "gloam_radical_inverse_base2", "--inputs", "64"}));
}

TEST(Drivers, ABrowsersSwiftShaderIsFoundAndComesLast) {
    const auto manifest = gpu::find_swiftshader();
    if (!manifest) GTEST_SKIP() << "no SwiftShader here (Debian's package chromium has it)";
    if (gpu::drivers_are_chosen()) GTEST_SKIP() << "the environment chooses the drivers";
    const json all = devices();
    EXPECT_EQ(swiftshaders(all), 1U);
    EXPECT_THAT(all.back().at("name").get<std::string>(), HasSubstr("SwiftShader"));
    EXPECT_THAT(all.back().at("driver").get<std::string>(),
                testing::ContainsRegex("SwiftShader driver [0-9]+\\."));
    EXPECT_EQ(swiftshaders(devices({"--driver", manifest->string()})), 1U) << "listed twice";

    const CommandResult check =
        run_command({"check", "gloam_radical_inverse_base2", "--inputs", "64", "--device", "swiftshader"});
    expect_success(check);
    EXPECT_THAT(check.out, HasSubstr("device: SwiftShader"));
    if (all.size() == 1) return;
    const CommandResult standard = run_command({"check", "gloam_radical_inverse_base2", "--inputs", "64"});
    expect_success(standard);
    EXPECT_THAT(standard.out, Not(HasSubstr("SwiftShader")));
}

TEST(Drivers, TheEnvironmentsChoiceIsRespected) {
    const auto manifest = gpu::find_swiftshader();
    if (!manifest) GTEST_SKIP() << "no SwiftShader here (Debian's package chromium has it)";
    const CommandOptions only{
        .environment = {"VK_DRIVER_FILES=" + manifest->string(), "VK_ICD_FILENAMES=" + manifest->string()}};
    const json chosen = devices({}, only);
    EXPECT_EQ(chosen.size(), 1U);
    EXPECT_EQ(swiftshaders(chosen), 1U);
    const CommandOptions elsewhere{.environment = {"VK_ADD_DRIVER_FILES=/no/such/driver.json"}};
    const CommandResult without = run_command({"devices", "--json"}, elsewhere);
    EXPECT_THAT(without.out, Not(HasSubstr("SwiftShader")));
}

}  // namespace drivers_test
}  // namespace gloam::test
