// SPDX-License-Identifier: MIT
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "gpu/device.hpp"
#include "tools/expect.hpp"

namespace gloam::test {
namespace drivers_test {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

json vulkan_devices(const std::string& list) {
    json vulkan = json::array();
    for (const json& device : json::parse(list))
        if (!device.at("index").is_null()) vulkan.push_back(device);
    return vulkan;
}

// Of Vulkan: the others, which have no index, are left out.
json devices(std::vector<std::string> arguments = {}, const CommandOptions& options = {}) {
    arguments.insert(arguments.begin(), {"devices", "--json"});
    const CommandResult result = run_command(arguments, options);
    expect_success(result);
    EXPECT_EQ(json::parse(result.out).back().at("name"), "interpreter");
    return vulkan_devices(result.out);
}

std::size_t swiftshaders(const json& devices) {
    return static_cast<std::size_t>(std::count_if(devices.begin(), devices.end(), [](const json& device) {
        return device.at("name").get<std::string>().find("SwiftShader") != std::string::npos;
    }));
}

std::string manifest_in(const TemporaryDirectory& folder, const std::string& name,
                        const std::string& library) {
    std::string path = (folder.path() / name).string();
    std::ofstream(path) << json{{"file_format_version", "1.0.0"},
                                {"ICD", {{"library_path", library}, {"api_version", "1.3.0"}}}};
    return path;
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
    const std::string first = manifest_in(folder, "first.json", "libno_such_driver.so");
    const std::string second = manifest_in(folder, "second.json", "./gone.so");
    const CommandResult result =
        run_command({"check", "--driver", first, "--driver", second, "gloam_radical_inverse_base2"});
    expect_could_not_run(result, "second.json");
    EXPECT_THAT(result.err, HasSubstr("gone.so"));
}

// Asked for by name, a driver is checked, or the run fails: it once was passed over without a word.
TEST(Drivers, WhatIsNoDriverIsAnError) {
    const TemporaryDirectory folder;
    const std::string library = (folder.path() / "libnone.so").string();
    std::ofstream(library) << "no library";
    const std::string unknown = manifest_in(folder, "unknown.json", "libno_such_driver.so");
    const std::string text = manifest_in(folder, "text.json", library);
    const std::string other = manifest_in(folder, "other.json", "libm.so.6");  // a library, but no driver
    for (const std::string& manifest : {unknown, text, other}) {
        expect_could_not_run(
            run_command({"check", "--driver", manifest, "gloam_radical_inverse_base2", "--inputs", "64"}),
            manifest);
        expect_could_not_run(run_command({"devices", "--driver", manifest}), manifest);
    }
}

// A driver that crashes, exits or hangs while it loads costs itself only, and is named.
TEST(Drivers, OneThatDoesNotLoadCostsItselfOnly) {
    const TemporaryDirectory folder;
    const std::string crashing = manifest_in(folder, "crashing.json", GLOAM_CRASHING_DRIVER);
    for (const auto& how : {std::vector<std::string>{}, std::vector<std::string>{"--driver", crashing}}) {
        CommandOptions options;
        if (how.empty()) options.environment = {"VK_ADD_DRIVER_FILES=" + crashing};
        const auto run = [&](std::vector<std::string> command) {
            command.insert(command.end(), how.begin(), how.end());
            return run_command(command, options);
        };
        const CommandResult list = run({"devices"});
        EXPECT_EQ(list.status, 0);
        EXPECT_THAT(list.out, testing::StartsWith("0: "));
        EXPECT_THAT(list.err, HasSubstr(crashing));
        EXPECT_THAT(list.err, HasSubstr("ABRT"));
        const std::string out = (folder.path() / "out").string();
        const CommandResult render =
            run({"render", "corner", "--size", "16x9", "--samples", "1", "--out", out});
        EXPECT_EQ(render.status, 0) << render.err;
        EXPECT_THAT(render.err, HasSubstr(crashing));
        const std::string file = (folder.path() / "a.json").string();
        const CommandResult check = run(
            {"check", "gloam_radical_inverse_base2", "--inputs", "64", "--device", "all", "--json", file});
        EXPECT_EQ(check.status, 1) << check.err;
        EXPECT_THAT(check.out, HasSubstr(crashing));
        EXPECT_THAT(check.out, HasSubstr("1 failed"));
        std::ifstream stream(file);
        // The driver that crashed has a report as the others of Vulkan have.
        EXPECT_EQ(json::parse(stream).size(), vulkan_devices(run({"devices", "--json"}).out).size() + 1);
    }
}

TEST(Drivers, OneThatEndsTheProcessCostsItselfOnly) {
    const TemporaryDirectory folder;
    const std::string manifest = manifest_in(folder, "ends.json", GLOAM_CRASHING_DRIVER);
    const CommandResult list = run_command(
        {"devices"}, {.environment = {"VK_ADD_DRIVER_FILES=" + manifest, "GLOAM_TEST_DRIVER_EXITS=1"}});
    EXPECT_EQ(list.status, 0);
    EXPECT_THAT(list.out, testing::StartsWith("0: "));
    EXPECT_THAT(list.err, HasSubstr(manifest + ": its process ended with status 0"));
}

TEST(Drivers, OneThatHangsCostsItselfAndItsTimeOnly) {
    const TemporaryDirectory folder;
    const std::string manifest = manifest_in(folder, "hangs.json", GLOAM_CRASHING_DRIVER);
    std::vector<std::string> environment{"VK_ADD_DRIVER_FILES=" + manifest, "GLOAM_TEST_DRIVER_HANGS=1",
                                         "GLOAM_DRIVER_SECONDS=3"};
    const CommandResult list = run_command({"devices"}, {.environment = environment});
    EXPECT_EQ(list.status, 0);
    EXPECT_THAT(list.out, testing::StartsWith("0: "));
    EXPECT_THAT(list.err, HasSubstr(manifest + ": does not load within 3 s"));
    for (const char* wrong :
         {"GLOAM_DRIVER_SECONDS=soon", "GLOAM_DRIVER_SECONDS=0", "GLOAM_DRIVER_SECONDS=nan"}) {
        environment.back() = wrong;
        expect_could_not_run(run_command({"devices"}, {.environment = environment}), "GLOAM_DRIVER_SECONDS");
    }
}

TEST(Drivers, NoneThatLoadsIsOneLine) {
    const TemporaryDirectory folder;
    const std::string crashing = manifest_in(folder, "crashing.json", GLOAM_CRASHING_DRIVER);
    const CommandOptions only{.environment = {"VK_DRIVER_FILES=" + crashing, "VK_ICD_FILENAMES=" + crashing}};
    expect_could_not_run(run_command({"devices"}, only), crashing);
    expect_could_not_run(run_command({"render", "corner", "--out", (folder.path() / "out").string()}, only),
                         "ABRT");
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
