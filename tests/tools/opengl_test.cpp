// SPDX-License-Identifier: MIT
// OpenGL devices on the command line.
#include <nlohmann/json.hpp>

#include "gl/device.hpp"
#include "tools/expect.hpp"
#include "tools/installation.hpp"

namespace gloam::test {
namespace opengl_test {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

// The names of the OpenGL devices here.
std::vector<std::string> names() {
    const CommandResult result = run_command({"devices", "--json"});
    expect_success(result);
    std::vector<std::string> all;
    for (const json& device : json::parse(result.out)) {
        const std::string name = device.at("name");
        if (!name.starts_with("gl:") && !name.starts_with("es:")) continue;
        EXPECT_TRUE(device.at("index").is_null());
        EXPECT_THAT(device.at("api_version").get<std::string>(), HasSubstr("OpenGL"));
        all.push_back(name);
    }
    return all;
}

class OpenGlCommands : public testing::Test {
  protected:
    void SetUp() override {
        if (names_.empty()) GTEST_SKIP() << "no OpenGL device here";
    }
    const std::vector<std::string> names_ = names();
};

TEST_F(OpenGlCommands, EveryListedDeviceRunsChecks) {
    const CommandResult result =
        run_command({"check", "HALTON-2D", "BUILTIN-sin", "--inputs", "256", "--device", "gl"});
    EXPECT_EQ(result.status, 0) << result.err;
    for (const std::string& name : names_) EXPECT_THAT(result.out, HasSubstr("device: " + name + " ("));
    EXPECT_THAT(result.out, HasSubstr(std::to_string(2 * names_.size()) + " checks, 0 failed"));
    EXPECT_THAT(result.out, HasSubstr("not judged"));
}

// There are no precision rules for OpenGL ES 3.0, and a built-in function documents no accuracy.
TEST_F(OpenGlCommands, NothingJudgedIsNoSuccess) {
    const CommandResult result =
        run_command({"check", "BUILTIN-sin", "--inputs", "64", "--device", "es:llvmpipe-3.0"});
    EXPECT_EQ(result.status, 2) << result.out << result.err;
    EXPECT_THAT(result.out, HasSubstr("not judged; it documents no accuracy"));
    EXPECT_THAT(result.out, HasSubstr("1 checks, 0 failed, 1 not judged"));
}

TEST_F(OpenGlCommands, TheListIsAlsoForPeople) {
    const CommandResult result = run_command({"devices"});
    expect_success(result);
    for (const std::string& name : names_) EXPECT_THAT(result.out, HasSubstr("\n" + name + ": OpenGL "));
}

TEST_F(OpenGlCommands, ResultsSayWhichInterfaceItWas) {
    const TemporaryDirectory folder;
    const std::string file = (folder.path() / "results.json").string();
    expect_success(run_command({"check", "HALTON-2D", "--inputs", "64", "--device", names_.front(), "--json",
                                file, "--variant", "all"}));
    const CommandResult result = run_command({"report", file});
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr(names_.front()));
    EXPECT_THAT(result.out, HasSubstr("1 checks, 0 failed"));
}

// A compute shader is probed, a fragment shader draws green.
TEST_F(OpenGlCommands, AFailureIsHandedOverAsAShaderTest) {
    const Installation installation;
    installation.replace("gloam/sampling/radical_inverse.glsl", "5.9604644775390625e-8", "5.9604652e-8");
    for (const std::string& name : names_) {
        const bool compute = gl::has_compute(gl::device_name_from(name)->version);
        if (name != "es:llvmpipe-3.0" && name != "es:llvmpipe-3.1") continue;
        const fs::path failures = installation.file("failures" + std::to_string(compute));
        const CommandResult result = run_program(
            installation.program(),
            {"check", "HALTON-base2", "--inputs", "64", "--device", name, "--failures", failures.string()});
        EXPECT_EQ(result.status, 1) << result.err;
        ASSERT_TRUE(fs::exists(failures));
        const fs::path device = fs::directory_iterator(failures)->path();
        const fs::path folder = fs::directory_iterator(device)->path();
        EXPECT_FALSE(fs::exists(folder / "repro.amber"));
        EXPECT_THAT(read_file(folder / "shader.glsl"),
                    HasSubstr("float gloam_radical_inverse_base2(uint index)"));
        EXPECT_THAT(read_file(folder / "report.txt"), HasSubstr(", OpenGL ES 3."));
        const std::string script = read_file(folder / "repro.shader_test");
        EXPECT_THAT(script, HasSubstr("float gloam_radical_inverse_base2(uint index)"));
        EXPECT_THAT(script, HasSubstr(compute ? "probe ssbo float 1 0 >= 0.5\nprobe ssbo float 1 0 <= 0.5\n"
                                              : "probe all rgba 0.0 1.0 0.0 1.0\n"));
        EXPECT_THAT(script, HasSubstr(compute ? "ssbo 0 subdata int 0 1\n"
                                              : "uniform uint gloam_kernel_inputs[0] 1\n"));
        if (!compute) {
            EXPECT_THAT(script, HasSubstr(">= uintBitsToFloat(1056964608u)"));
        }
    }
}

TEST_F(OpenGlCommands, OtherVariantsAndUnknownNamesAreRefusedInOneLine) {
    const std::string name = names_.front();
    expect_could_not_run(run_command({"check", "HALTON-2D", "--device", name, "--variant", "strict"}),
                         "OpenGL devices have the variant shipped only, not strict");
    expect_could_not_run(run_command({"check", "HALTON-2D", "--device", "gl:nonsense-1.0"}),
                         "no OpenGL device \"gl:nonsense-1.0\"");
    expect_could_not_run(run_command({"check", "HALTON-2D", "--device", name, "--validation"}),
                         "validation layers are of Vulkan");
}

}  // namespace opengl_test
}  // namespace gloam::test
