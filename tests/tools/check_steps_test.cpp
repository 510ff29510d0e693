// SPDX-License-Identifier: MIT
// gloam check --compiler, --variant metamorphic, random functions: what a compiler's engineer asks.
#include <fstream>
#include <nlohmann/json.hpp>

#include "tools/expect.hpp"
#include "tools/installation.hpp"

namespace gloam::test::check_steps_test {

namespace fs = std::filesystem;

CommandResult check(const std::string& what, const std::vector<std::string>& steps,
                    const std::vector<std::string>& more = {}) {
    std::vector<std::string> all = words("check " + what + " --inputs 64 --in-process");
    for (const std::string& step : steps) all.insert(all.end(), {"--compiler", step});
    all.insert(all.end(), more.begin(), more.end());
    return run_command(all);
}

// A compiler that exchanges what it subtracts: assembly between two programs of SPIRV-Tools.
std::string broken_compiler(const fs::path& folder) {
    const fs::path script = folder / "broken";
    std::ofstream(script)
        << "#!/bin/sh\nset -e\nspirv-dis \"$1\" -o \"$2.txt\"\n"
           "sed -i 's/OpISub \\(%[a-z]*\\) \\(%[0-9]*\\) \\(%[0-9]*\\)/OpISub \\1 \\3 \\2/' \"$2.txt\"\n"
           "spirv-as --target-env spv1.5 \"$2.txt\" -o \"$2\"\n";
    fs::permissions(script, fs::perms::owner_all);
    return script.string() + " {in} {out}";
}

TEST(CheckSteps, RightPassesAreOkAndUnchangedModulesAreCounted) {
    const CommandResult result = check("HALTON-2D", {"spirv-opt -O", "spirv-opt --wrap-opkill"});
    EXPECT_EQ(result.status, 0) << result.out << result.err;
    EXPECT_THAT(result.out, HasSubstr("device: interpreter"));  // no driver is needed
    EXPECT_THAT(result.out, HasSubstr("1        1       0           0  shipped | spirv-opt -O"));
    EXPECT_THAT(result.out, HasSubstr("1        0       0           0  shipped | spirv-opt --wrap-opkill"));
}

// The module before the step reads outside of its array for them too.
TEST(CheckSteps, UndefinedInputsAreNotJudged) {
    const TemporaryDirectory folder;
    const auto file = folder.write("f.glsl",
                                   "float f(int i, float x) {\n    float a[4] = float[4](1.0, x, 3.0, 4.0);\n"
                                   "    return a[i] + x;\n}\n");
    const CommandResult result = check(file.string(), {"spirv-opt -O"}, words("--range i=0:7"));
    EXPECT_EQ(result.status, 0) << result.out << result.err;
    EXPECT_THAT(result.out, HasSubstr("the result is undefined for"));
}

TEST(CheckSteps, NothingChangedIsNoVerdict) {
    EXPECT_EQ(check("HALTON-2D", {"spirv-opt --wrap-opkill"}).status, 2);
}

TEST(CheckSteps, MetamorphicVariantsRunOnADriverAndThroughACompiler) {
    const CommandResult result = check("random:3-4", {}, words("--variant metamorphic --seeds 2"));
    EXPECT_EQ(result.status, 0) << result.out << result.err;
    EXPECT_THAT(result.out, HasSubstr("shipped | metamorphic 2"));
    EXPECT_EQ(check("random:3-4", {"metamorphic | spirv-opt -O"}, words("--seeds 2")).status, 0);
}

// The folder of the failure of a shader after a broken compiler among other steps.
fs::path handed_over(const fs::path& folder, const std::string& glsl) {
    std::ofstream(folder / "f.glsl") << glsl;
    const CommandResult result =
        check((folder / "f.glsl").string(),
              {"spirv-opt --merge-return --ccp | " + broken_compiler(folder) + " | spirv-opt --ssa-rewrite"},
              words("--failures {} --json {}", folder / "failures", folder / "r.json"));
    EXPECT_EQ(result.status, 1) << result.out << result.err;
    EXPECT_THAT(result.out, HasSubstr("run it again: gloam check"));
    EXPECT_THAT(result.out, HasSubstr("--variant shipped --compiler 'spirv-opt --merge-return --ccp | "));
    for (const auto& entry : fs::recursive_directory_iterator(folder / "failures"))
        if (entry.path().filename() == "report.txt") return entry.path().parent_path();
    return {};
}

void expect_reproduced_by_its_program(const fs::path& folder) {
    const CommandResult built = run_program(
        "cc", words("-Wall -Wextra -Werror {} -o {} -lvulkan -lm", folder / "repro.c", folder / "repro"));
    EXPECT_EQ(built.status, 0) << built.err;
    const CommandResult reproduced = run_program(folder / "repro", {});
    EXPECT_EQ(reproduced.status, 1) << reproduced.out << reproduced.err;
    EXPECT_THAT(reproduced.out, HasSubstr("OUTSIDE"));
    EXPECT_THAT(reproduced.out.substr(reproduced.out.find("before the steps")),
                testing::Not(HasSubstr("OUTSIDE")));
}

TEST(CheckSteps, ABrokenCompilerIsHandedOverWithTheFewestStepsAndAProgram) {
    const TemporaryDirectory folder;
    const fs::path at = handed_over(
        folder.path(), "int f(int a, int b) {\n    int c = a * 3;\n    return c > 7 ? c - b : b;\n}\n");
    EXPECT_THAT(read_file(at / "report.txt"),
                HasSubstr("The fewest steps that fail: " + broken_compiler(folder.path()) + "\n"));
    for (const char* file : {"before.spv", "shader.spv", "smallest.spv"})
        EXPECT_EQ(run_program("spirv-val", words("--target-env vulkan1.2 {}", at / file)).status, 0) << file;
    EXPECT_LT(fs::file_size(at / "smallest.spv"), fs::file_size(at / "before.spv"));
    expect_reproduced_by_its_program(at);
    EXPECT_EQ(run_program(at / "repro", {"no such device"}).status, 2);
}

TEST(CheckSteps, TheProgramHasTheImagesOfSamplers) {
    const TemporaryDirectory folder;
    expect_reproduced_by_its_program(handed_over(folder.path(), R"(
        uniform sampler2D flat_one;
        uniform isamplerCube sky;
        uniform sampler2DShadow depths;
        int f(int a, int b) {
            int c = a * 3 + int(64.0 * texelFetch(flat_one, ivec2(1, 3), 0).y);
            c += textureLod(sky, vec3(1.0, 0.25, -0.25), 0.0).z + int(textureLod(depths, vec3(0.5), 0.0));
            return c > 7 ? c - b : b;
        })"));
}

TEST(CheckSteps, ABudgetOfTimeLeavesChecksForALaterRun) {
    const TemporaryDirectory folder;
    const auto file = folder.path() / "r.json";
    const auto more = [&file](const std::string& words_of_it) {
        return words(words_of_it + " --json {}", file);
    };
    const CommandResult first = check("random:1-40", {"spirv-opt -O"}, more("--budget 0.2"));
    EXPECT_EQ(first.status, 0) << first.out << first.err;
    EXPECT_THAT(first.out,
                HasSubstr("checks were not run: the budget of 0.2 s is spent; --resume runs them"));
    const CommandResult second = check("random:1-40", {"spirv-opt -O"}, more("--resume"));
    EXPECT_EQ(second.status, 0) << second.out << second.err;
    EXPECT_THAT(second.out, HasSubstr("40 checks, 0 failed"));
    EXPECT_THAT(second.out, testing::Not(HasSubstr("not run")));
}

TEST(CheckSteps, AStepThatFailsFailsTheCheckInOneLine) {
    const CommandResult result = check("HALTON-2D", {"/bin/false {in} {out}"});
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.out, HasSubstr("/bin/false ended with status 1"));
}

TEST(CheckSteps, BadWordsAreNamed) {
    for (const auto& [what, step, named] :
         {std::array{"HALTON-2D", "spirv-opt --no-pass", "--no-pass"},
          std::array{"HALTON-2D", "spirv-opt -O | metamorphic 1", "metamorphic steps before"},
          std::array{"random:9-1", "spirv-opt -O", "random:FIRST-LAST"},
          std::array{"random:x", "spirv-opt -O", "random:FIRST-LAST"}}) {
        const CommandResult result = check(what, {step});
        EXPECT_EQ(result.status, 2);
        EXPECT_THAT(result.err, HasSubstr(named));
        EXPECT_EQ(line_count(result.err), 1) << result.err;
    }
}

}  // namespace gloam::test::check_steps_test
