// SPDX-License-Identifier: MIT
#include "backend/gl/device.hpp"
#include "backend/vulkan/device.hpp"
#include "tools/gloam.hpp"

namespace gloam::test::drivers_test {

json vulkan_devices(const std::string& list) {
    json vulkan = json::array();
    const json all = json::parse(list).at("devices");
    for (const json& device : all)
        if (!device.at("index").is_null()) vulkan.push_back(device);
    return vulkan;
}

// Of Vulkan: the others, which have no index, are left out.
json devices(std::vector<std::string> arguments = {}, const CommandOptions& options = {}) {
    arguments.insert(arguments.begin(), {"devices", "--json"});
    const CommandResult result = run_command(arguments, options);
    expect_success(result);
    EXPECT_EQ(json::parse(result.out).at("devices").back().at("name"), "interpreter");
    return vulkan_devices(result.out);
}

std::size_t swiftshaders(const json& devices) {
    return static_cast<std::size_t>(std::count_if(devices.begin(), devices.end(), [](const json& device) {
        return device.at("name").get<std::string>().find("SwiftShader") != std::string::npos;
    }));
}

class Drivers : public InFolder {
  protected:
    [[nodiscard]] std::string manifest(const std::string& name, const std::string& library) const {
        return write(name, manifest_of(library)).string();
    }
    [[nodiscard]] std::string crashing() const { return manifest("crashing.json", GLOAM_CRASHING_DRIVER); }
};

// A driver that crashes, exits or hangs while it loads costs itself only, and is named.
TEST_F(Drivers, OneThatDoesNotLoadCostsItselfOnly) {
    const std::string crashing = this->crashing();
    for (const auto& how : {std::vector<std::string>{}, std::vector<std::string>{"--driver", crashing}}) {
        CommandOptions options;
        if (how.empty()) options.environment = {"VK_ADD_DRIVER_FILES=" + crashing};
        const auto run = [&](std::vector<std::string> command) {
            command.insert(command.end(), how.begin(), how.end());
            return run_command(command, options);
        };
        const CommandResult list = run(words("devices"));
        EXPECT_EQ(list.status, 0);
        EXPECT_THAT(list.out, StartsWith("0: "));
        EXPECT_THAT(list.err, HasSubstr(crashing));
        EXPECT_THAT(list.err, HasSubstr("ABRT"));
        const std::string out = path("out").string();
        const CommandResult render = run(words("render corner --size 16x9 --samples 1 --out {}", out));
        EXPECT_EQ(render.status, 0) << render.err;
        EXPECT_THAT(render.err, HasSubstr(crashing));
        const std::string file = path("a.json").string();
        const CommandResult check =
            run(words("check gloam_radical_inverse_base2 --inputs 64 --device all --json {}", file));
        EXPECT_EQ(check.status, 1) << check.err;
        EXPECT_THAT(check.out, HasSubstr(crashing));
        EXPECT_THAT(check.out, HasSubstr("1 failed"));
        // The driver that crashed has a report as the others of Vulkan have.
        EXPECT_EQ(json::parse(read_file(file)).size(),
                  vulkan_devices(run(words("devices --json")).out).size() + 1);
    }
}

TEST_F(Drivers, OneThatEndsTheProcessCostsItselfOnly) {
    const std::string ends = manifest("ends.json", GLOAM_CRASHING_DRIVER);
    const CommandResult list = run_command(
        words("devices"), {.environment = {"VK_ADD_DRIVER_FILES=" + ends, "GLOAM_TEST_DRIVER_EXITS=1"}});
    EXPECT_EQ(list.status, 0);
    EXPECT_THAT(list.out, StartsWith("0: "));
    EXPECT_THAT(list.err, HasSubstr(ends + ": its process ended with status 0"));
}

TEST_F(Drivers, OneThatHangsCostsItselfAndItsTimeOnly) {
    const std::string hangs = manifest("hangs.json", GLOAM_CRASHING_DRIVER);
    std::vector<std::string> environment{"VK_ADD_DRIVER_FILES=" + hangs, "GLOAM_TEST_DRIVER_HANGS=1",
                                         "GLOAM_DRIVER_SECONDS=3"};
    const CommandResult list = run_command(words("devices"), {.environment = environment});
    EXPECT_EQ(list.status, 0);
    EXPECT_THAT(list.out, StartsWith("0: "));
    EXPECT_THAT(list.err, HasSubstr(hangs + ": does not load within 3 s"));
    for (const char* wrong :
         {"GLOAM_DRIVER_SECONDS=soon", "GLOAM_DRIVER_SECONDS=0", "GLOAM_DRIVER_SECONDS=nan"}) {
        environment.back() = wrong;
        expect_could_not_run(run_command(words("devices"), {.environment = environment}),
                             "GLOAM_DRIVER_SECONDS");
    }
}

TEST_F(Drivers, NoneThatLoadsIsOneLine) {
    const std::string crashing = this->crashing();
    const CommandOptions only = with_driver_alone(crashing);
    expect_could_not_run(run_command(words("devices"), only), crashing);
    expect_could_not_run(run_command(words("render corner --out {}", path("out")), only), "ABRT");
}

TEST_F(Drivers, ABrowsersSwiftShaderIsFoundAndComesLast) {
    const auto manifest = gpu::find_swiftshader();
    if (!manifest) GTEST_SKIP() << "no SwiftShader here (Debian's package chromium has it)";
    if (gpu::drivers_are_chosen()) GTEST_SKIP() << "the environment chooses the drivers";
    const json all = devices();
    EXPECT_EQ(swiftshaders(all), 1U);
    EXPECT_THAT(all.back().at("name").get<std::string>(), HasSubstr("SwiftShader"));
    EXPECT_THAT(all.back().at("driver").get<std::string>(),
                testing::ContainsRegex("SwiftShader driver [0-9]+\\."));
    EXPECT_EQ(swiftshaders(devices({"--driver", manifest->string()})), 1U) << "listed twice";

    const CommandResult check = gloam("check gloam_radical_inverse_base2 --inputs 64 --device swiftshader");
    expect_success(check);
    EXPECT_THAT(check.out, HasSubstr("device: SwiftShader"));
    if (all.size() == 1) return;
    EXPECT_THAT(output_of(gloam("check gloam_radical_inverse_base2 --inputs 64")),
                Not(HasSubstr("SwiftShader")));
}

TEST_F(Drivers, TheEnvironmentsChoiceIsRespected) {
    const auto manifest = gpu::find_swiftshader();
    if (!manifest) GTEST_SKIP() << "no SwiftShader here (Debian's package chromium has it)";
    const json chosen = devices({}, with_driver_alone(*manifest));
    EXPECT_EQ(chosen.size(), 1U);
    EXPECT_EQ(swiftshaders(chosen), 1U);
    const CommandOptions elsewhere{.environment = {"VK_ADD_DRIVER_FILES=/no/such/driver.json"}};
    const CommandResult without = run_command(words("devices --json"), elsewhere);
    EXPECT_THAT(without.out, Not(HasSubstr("SwiftShader")));
}

// OpenGL devices on the command line.

// The names of the OpenGL devices here.
std::vector<std::string> names() {
    const CommandResult result = gloam("devices --json");
    expect_success(result);
    std::vector<std::string> all;
    const json listed = json::parse(result.out).at("devices");
    for (const json& device : listed) {
        const std::string name = device.at("name");
        if (!name.starts_with("gl:") && !name.starts_with("es:")) continue;
        EXPECT_TRUE(device.at("index").is_null());
        EXPECT_THAT(device.at("api_version").get<std::string>(), HasSubstr("OpenGL"));
        all.push_back(name);
    }
    return all;
}

class OpenGlCommands : public InFolder {
  protected:
    void SetUp() override {
        if (names_.empty()) GTEST_SKIP() << "no OpenGL device here";
    }
    const std::vector<std::string> names_ = names();
};

TEST_F(OpenGlCommands, EveryListedDeviceRunsChecks) {
    const CommandResult result = gloam("check HALTON-2D BUILTIN-sin --inputs 256 --device gl");
    EXPECT_EQ(result.status, 0) << result.err;
    for (const std::string& name : names_) EXPECT_THAT(result.out, HasSubstr("device: " + name + " ("));
    EXPECT_THAT(result.out, HasSubstr(std::to_string(2 * names_.size()) + " checks, 0 failed"));
    EXPECT_THAT(result.out, HasSubstr("not judged"));
}

// There are no precision rules for OpenGL ES 3.0, and a built-in function documents no accuracy.
TEST_F(OpenGlCommands, NothingJudgedIsNoSuccess) {
    const CommandResult result = gloam("check BUILTIN-sin --inputs 64 --device es:llvmpipe-3.0");
    EXPECT_EQ(result.status, 2) << result.out << result.err;
    EXPECT_THAT(result.out, HasSubstr("not judged; it documents no accuracy"));
    EXPECT_THAT(result.out, HasSubstr("1 checks, 0 failed, 1 not judged"));
}

TEST_F(OpenGlCommands, TheListIsAlsoForPeople) {
    const std::string result = output_of(gloam("devices"));
    for (const std::string& name : names_) EXPECT_THAT(result, HasSubstr("\n" + name + ": OpenGL "));
}

TEST_F(OpenGlCommands, ResultsSayWhichInterfaceItWas) {
    const fs::path file = path("results.json");
    expect_success(
        gloam("check HALTON-2D --inputs 64 --device {} --json {} --variant all", names_.front(), file));
    const std::string result = output_of(gloam("report {}", file));
    EXPECT_THAT(result, HasSubstr(names_.front()));
    EXPECT_THAT(result, HasSubstr("1 checks, 0 failed"));
}

// Where there are no compute shaders, there is no script.
TEST_F(OpenGlCommands, AFailureIsHandedOverAsAShaderTest) {
    const Installation installation;
    installation.spoil_radical_inverse_base2();
    for (const std::string& name : names_) {
        const bool compute = gl::has_compute(gl::device_name_from(name)->version);
        if (name != "es:llvmpipe-3.0" && name != "es:llvmpipe-3.1") continue;
        const fs::path failures = installation.file("failures" + std::to_string(compute));
        const CommandResult result =
            installation.gloam("check HALTON-base2 --inputs 64 --device {} --failures {}", name, failures);
        EXPECT_EQ(result.status, 1) << result.err;
        ASSERT_TRUE(fs::exists(failures));
        const fs::path device = fs::directory_iterator(failures)->path();
        const fs::path folder = fs::directory_iterator(device)->path();
        EXPECT_FALSE(fs::exists(folder / "repro.amber"));
        EXPECT_THAT(read_file(folder / "shader.glsl"),
                    HasSubstr("float gloam_radical_inverse_base2(uint index)"));
        EXPECT_THAT(read_file(folder / "report.txt"), HasSubstr(", OpenGL ES 3."));
        EXPECT_EQ(fs::exists(folder / "repro.shader_test"), compute);
        if (!compute) continue;
        EXPECT_THAT(
            read_file(folder / "repro.shader_test"),
            AllOf(HasSubstr("float gloam_radical_inverse_base2(uint index)"),
                  HasSubstr("probe ssbo float 1 0 >= 0.500000000\nprobe ssbo float 1 0 <= 0.500000000\n"),
                  HasSubstr("ssbo 0 subdata int 0 1\n")));
    }
}

TEST_F(OpenGlCommands, OtherVariantsAndUnknownNamesAreRefusedInOneLine) {
    const std::string name = names_.front();
    expect_could_not_run(gloam("check HALTON-2D --device {} --variant strict", name),
                         name + ": expected the variant shipped");
    expect_could_not_run(gloam("check HALTON-2D --device gl:softpipe-3.3 --variant metamorphic"),
                         "gl:softpipe-3.3: expected the variant shipped, not metamorphic");
    expect_could_not_run(gloam("check HALTON-2D --device gl:nonsense-1.0"),
                         "no OpenGL device \"gl:nonsense-1.0\"");
    expect_could_not_run(gloam("check HALTON-2D --device {} --validation", name),
                         "validation layers are of Vulkan");
}

}  // namespace gloam::test::drivers_test
