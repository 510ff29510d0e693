// SPDX-License-Identifier: MIT
// gloam check --compiler: what a compiler's engineer asks.
#include "tools/gloam.hpp"

namespace gloam::test::check_steps_test {

// What a broken compiler makes of the assembly between two programs of SPIRV-Tools: it exchanges what it
// subtracts, or makes the second of two equal components 0.
constexpr const char* exchanges = R"(sed 's/OpISub \(%[a-z]*\) \(%[0-9]*\) \(%[0-9]*\)/OpISub \1 \3 \2/')";
constexpr const char* loses_second =
    R"(sed 's/\(OpCompositeConstruct %v2float \(%[0-9]*\)\) \2$/\1 %float_0/')";

std::string broken_compiler(const fs::path& folder, const std::string& edits) {
    const fs::path script = folder / "broken";
    std::ofstream(script) << "#!/bin/sh\nset -e\nspirv-dis \"$1\" -o \"$2.txt\"\n"
                          << edits << " \"$2.txt\" >\"$2.changed\"\n"
                          << "spirv-as --target-env spv1.5 \"$2.changed\" -o \"$2\"\n";
    fs::permissions(script, fs::perms::owner_all);
    return script.string() + " {in} {out}";
}

using CheckSteps = InFolder;

// The folder of the failure of a shader after a broken compiler among other steps.
fs::path handed_over(const fs::path& folder, const std::string& glsl, const std::string& edits = exchanges,
                     const Arguments& options = {}) {
    std::ofstream(folder / "f.glsl") << glsl;
    Arguments command = words(
        "check {} --inputs 64 --in-process --failures {} --json {} --compiler {}", folder / "f.glsl",
        folder / "failures", folder / "r.json",
        "spirv-opt --merge-return --ccp | " + broken_compiler(folder, edits) + " | spirv-opt --ssa-rewrite");
    command.insert(command.end(), options.begin(), options.end());
    const CommandResult result = run_command(command);
    EXPECT_EQ(result.status, 1) << result.out << result.err;
    EXPECT_THAT(result.out, HasSubstr("run it again: gloam check"));
    EXPECT_THAT(result.out, HasSubstr("--variant shipped --compiler 'spirv-opt --merge-return --ccp | "));
    for (const auto& entry : fs::recursive_directory_iterator(folder / "failures"))
        if (entry.path().filename() == "report.txt") return entry.path().parent_path();
    return {};
}

std::string expect_reproduced_by_its_program(const fs::path& folder) {
    const CommandResult built = run_program(
        "cc", words("-Wall -Wextra -Werror {} -o {} -lvulkan -lm", folder / "repro.c", folder / "repro"));
    EXPECT_EQ(built.status, 0) << built.err;
    const CommandResult reproduced = run_program(folder / "repro", {});
    EXPECT_EQ(reproduced.status, 1) << reproduced.out << reproduced.err;
    EXPECT_THAT(reproduced.out, HasSubstr("OUTSIDE"));
    EXPECT_THAT(reproduced.out.substr(reproduced.out.find("before the steps")),
                testing::Not(HasSubstr("OUTSIDE")));
    return reproduced.out;
}

// With the images of samplers.
TEST_F(CheckSteps, ABrokenCompilerIsHandedOverWithTheFewestStepsAndAProgram) {
    const fs::path at = handed_over(folder.path(), R"(
        uniform sampler2D flat_one;
        uniform isamplerCube sky;
        uniform sampler2DShadow depths;
        int f(int a, int b) {
            int c = a * 3 + int(64.0 * texelFetch(flat_one, ivec2(1, 3), 0).y);
            c += textureLod(sky, vec3(1.0, 0.25, -0.25), 0.0).z + int(textureLod(depths, vec3(0.5), 0.0));
            return c > 7 ? c - b : b;
        })");
    EXPECT_THAT(read_file(at / "report.txt"),
                HasSubstr("The fewest steps that fail: " + broken_compiler(folder.path(), exchanges) + "\n"));
    EXPECT_THAT(read_file(at / "report.txt"), HasSubstr("the compiler's step is at fault"));
    for (const char* file : {"before.spv", "shader.spv"})
        EXPECT_EQ(run_program("spirv-val", words("--target-env vulkan1.2 {}", at / file)).status, 0) << file;
    expect_reproduced_by_its_program(at);
    const CommandResult nowhere = run_program(at / "repro", {"no such device"});
    EXPECT_EQ(nowhere.status, 2);
    EXPECT_THAT(nowhere.err, AllOf(HasSubstr("contains \"no such device\""), HasSubstr("VK_DRIVER_FILES")));
}

// Between 16 and 17 times the smallest half. A half so small may also be flushed. Mesa 25 leaves out the
// rounding where nothing comes between the two functions (docs/drivers.md).
TEST_F(CheckSteps, TwoOutputsOfDifferentOutcomesAreOutsideForTheProgramToo) {
    const fs::path at = handed_over(
        folder.path(),
        "vec2 f(float x, uint nothing) {\n"
        "    float y = unpackHalf2x16(packHalf2x16(vec2(x, 0.0)) + nothing).x;\n    return vec2(y);\n}\n",
        loses_second, {"--range", "x=9.9e-7:1e-6", "--range", "nothing=0:0"});
    EXPECT_THAT(
        read_file(at / "report.txt"),
        AllOf(HasSubstr("  permitted together: 0 (0x0p+0); 0 (0x0p+0)\n"),
              HasSubstr("  or together:        1.01327896e-06 (0x1.1p-20); 1.01327896e-06 (0x1.1p-20)\n")));
    EXPECT_THAT(expect_reproduced_by_its_program(at),
                AllOf(HasSubstr(", expected 0, or 9.5367431640625e-07, or 1.0132789611816406e-06: ok\n"
                                "  output 1: 0x00000000 0"),
                      HasSubstr("  no outcome has all outputs together: OUTSIDE\n")));
}

// What `git bisect run` asks: good, bad (0 and 1), or skip this build.
TEST_F(CheckSteps, AScriptForBisectJudgesADriver) {
    const fs::path lavapipe = installed_lavapipe();
    if (lavapipe.empty()) GTEST_SKIP() << "no lavapipe here (Debian: mesa-vulkan-drivers)";
    const std::string path = fs::path(GLOAM_BUILT_BINARY).parent_path().string() + ":" + std::getenv("PATH");
    const auto status = [&](const std::string& build, const fs::path& manifest) {
        const std::string line = GLOAM_EXAMPLES "/laboratory/bisect.sh {} HALTON-base2 --inputs 64";
        return run_program("/bin/bash", words(line, manifest),
                           {.environment = {"BUILD=" + build, "PATH=" + path}})
            .status;
    };
    const fs::path crashing = write("crashing.json",
                                    R"({"file_format_version": "1.0.0", "ICD": {"api_version": "1.3.0",
                                    "library_path": ")" GLOAM_CRASHING_DRIVER "\"}}");
    EXPECT_EQ(status("true", lavapipe), 0);
    EXPECT_EQ(status("true", crashing), 1);
    EXPECT_EQ(status("false", lavapipe), 125);
    EXPECT_EQ(status("true", this->path("missing.json")), 125);
}

}  // namespace gloam::test::check_steps_test
