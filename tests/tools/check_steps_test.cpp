// SPDX-License-Identifier: MIT
// gloam check --compiler, --variant metamorphic: what a compiler's engineer asks.
#include "tools/gloam.hpp"

namespace gloam::test::check_steps_test {

CommandResult check(const std::string& what, const std::vector<std::string>& steps,
                    const std::vector<std::string>& more = {}) {
    std::vector<std::string> all = words("check " + what + " --inputs 64 --in-process");
    for (const std::string& step : steps) all.insert(all.end(), {"--compiler", step});
    all.insert(all.end(), more.begin(), more.end());
    return run_command(all);
}

// What a broken compiler makes of the assembly between two programs of SPIRV-Tools: it exchanges what it
// subtracts, leaves out the rounding to half precision, makes the second of two equal components 0.
constexpr const char* exchanges = R"(sed 's/OpISub \(%[a-z]*\) \(%[0-9]*\) \(%[0-9]*\)/OpISub \1 \3 \2/')";
constexpr const char* keeps_digits =
    R"(awk '/ PackHalf2x16/ {from = $NF}
            / UnpackHalf2x16/ {$0 = $1 " = OpCopyObject " $4 " " from} {print}')";
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
    Arguments more = words("--failures {} --json {}", folder / "failures", folder / "r.json");
    more.insert(more.end(), options.begin(), options.end());
    const CommandResult result = check(
        (folder / "f.glsl").string(),
        {"spirv-opt --merge-return --ccp | " + broken_compiler(folder, edits) + " | spirv-opt --ssa-rewrite"},
        more);
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

TEST_F(CheckSteps, ABrokenCompilerIsHandedOverWithTheFewestStepsAndAProgram) {
    const fs::path at = handed_over(
        folder.path(), "int f(int a, int b) {\n    int c = a * 3;\n    return c > 7 ? c - b : b;\n}\n");
    EXPECT_THAT(read_file(at / "report.txt"),
                HasSubstr("The fewest steps that fail: " + broken_compiler(folder.path(), exchanges) + "\n"));
    for (const char* file : {"before.spv", "shader.spv"})
        EXPECT_EQ(run_program("spirv-val", words("--target-env vulkan1.2 {}", at / file)).status, 0) << file;
    expect_reproduced_by_its_program(at);
    const CommandResult nowhere = run_program(at / "repro", {"no such device"});
    EXPECT_EQ(nowhere.status, 2);
    EXPECT_THAT(nowhere.err, AllOf(HasSubstr("contains \"no such device\""), HasSubstr("VK_DRIVER_FILES")));
}

// Between 16 and 17 times the smallest half. A half so small may also be flushed. Mesa 25 leaves out the
// rounding where nothing comes between the two functions (docs/drivers.md).
const Arguments between{"--range", "x=9.9e-7:1e-6", "--range", "nothing=0:0"};
constexpr const char* either_half = ", expected 0, or 9.5367431640625e-07, or 1.0132789611816406e-06: ";

TEST_F(CheckSteps, AValueBetweenTwoOutcomesIsOutsideForTheProgramToo) {
    const fs::path at = handed_over(
        folder.path(),
        "float f(float x, uint nothing) { return unpackHalf2x16(packHalf2x16(vec2(x, 0.0)) + nothing).x; }\n",
        keeps_digits, between);
    const std::string report = read_file(at / "report.txt");
    EXPECT_THAT(
        report,
        HasSubstr("permitted 0 (0x0p+0), or 9.53674316e-07 (0x1p-20), or 1.01327896e-06 (0x1.1p-20)\n"));
    EXPECT_THAT(
        report,
        HasSubstr("permitted 0 (0x0p+0); or 9.53674316e-07 (0x1p-20); or 1.01327896e-06 (0x1.1p-20)\n"));
    EXPECT_THAT(read_file(at / "repro.amber"), HasSubstr("EXPECT floats IDX 0 NE 9."));
    EXPECT_THAT(expect_reproduced_by_its_program(at), HasSubstr(either_half + std::string("OUTSIDE\n")));
}

TEST_F(CheckSteps, TwoOutputsOfDifferentOutcomesAreOutsideForTheProgramToo) {
    const fs::path at = handed_over(
        folder.path(),
        "vec2 f(float x, uint nothing) {\n"
        "    float y = unpackHalf2x16(packHalf2x16(vec2(x, 0.0)) + nothing).x;\n    return vec2(y);\n}\n",
        loses_second, between);
    EXPECT_THAT(
        read_file(at / "report.txt"),
        AllOf(HasSubstr("  permitted together: 0 (0x0p+0); 0 (0x0p+0)\n"),
              HasSubstr("  or together:        1.01327896e-06 (0x1.1p-20); 1.01327896e-06 (0x1.1p-20)\n")));
    EXPECT_THAT(expect_reproduced_by_its_program(at),
                AllOf(HasSubstr(either_half + std::string("ok\n  output 1: 0x00000000 0")),
                      HasSubstr("  no outcome has all outputs together: OUTSIDE\n")));
}

TEST_F(CheckSteps, TheProgramHasTheImagesOfSamplers) {
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

TEST_F(CheckSteps, ABudgetOfTimeLeavesChecksForALaterRun) {
    const auto file = folder.path() / "r.json";
    const auto more = [&file](const std::string& words_of_it) {
        return words(words_of_it + " --json {}", file);
    };
    const CommandResult first = check("HALTON-base2", {"spirv-opt {each}"}, more("--budget 0.2"));
    EXPECT_EQ(first.status, 0) << first.out << first.err;
    EXPECT_THAT(first.out,
                HasSubstr("checks were not run: the budget of 0.2 s is spent; --resume runs them"));
    const CommandResult second = check("HALTON-base2", {"spirv-opt {each}"}, more("--resume"));
    EXPECT_EQ(second.status, 0) << second.out << second.err;
    EXPECT_THAT(second.out, HasSubstr(" checks, 0 failed"));
    EXPECT_THAT(second.out, Not(HasSubstr("not run")));
}

// `gloam check --exit-code`, and what `git bisect run` makes of it.

constexpr int skip_this_build = 125;

class Bisect : public InFolder {
  protected:
    // Git in a repository of its own, without the settings of this machine.
    template <class... Texts>
    [[nodiscard]] CommandResult git(std::string_view line, const Texts&... arguments) const {
        const std::string path =
            fs::path(GLOAM_BUILT_BINARY).parent_path().string() + ":" + std::getenv("PATH");
        return run_program(
            "/usr/bin/git", words(line, arguments...),
            {.environment = {"GIT_CONFIG_GLOBAL=/dev/null", "GIT_CONFIG_SYSTEM=/dev/null",
                             "GIT_AUTHOR_NAME=a", "GIT_AUTHOR_EMAIL=a", "GIT_COMMITTER_NAME=a",
                             "GIT_COMMITTER_EMAIL=a", "BUILD=cp source.json icd.json", "PATH=" + path},
             .working_directory = this->path("")});
    }
    // Commits a revision of the driver; returns its hash.
    [[nodiscard]] std::string commit(int number, const std::string& manifest) const {
        write("number", std::to_string(number));
        if (manifest.empty()) fs::remove(path("source.json"));
        if (!manifest.empty()) write("source.json", manifest);
        EXPECT_EQ(git("add --all").status, 0);
        EXPECT_EQ(git("commit --quiet --message {}", "revision " + std::to_string(number)).status, 0);
        return git("rev-parse HEAD").out.substr(0, 40);
    }
};

// The manifest of Mesa's lavapipe; empty: it is not here.
std::string lavapipe() {
    const fs::path folder = "/usr/share/vulkan/icd.d";
    if (fs::exists(folder))
        for (const fs::directory_entry& entry : fs::directory_iterator(folder))
            if (entry.path().filename().string().starts_with("lvp_icd")) return read_file(entry.path());
    return "";
}

TEST_F(Bisect, TheStatusIsGoodBadOrSkip) {
    EXPECT_EQ(gloam("check HALTON-base2 --inputs 64 --exit-code --device interpreter").status, 0);
    const Installation installation;
    installation.spoil_radical_inverse_base2();
    EXPECT_EQ(installation.gloam("check HALTON-base2 --inputs 64 --exit-code").status, 1);
    for (const char* line : {"check nonsense --exit-code", "check HALTON-base2 --exit-code --nonsense",
                             "check HALTON-base2 --exit-code --device nonsense"}) {
        const CommandResult result = run_command(words(line));
        EXPECT_EQ(result.status, skip_this_build) << line;
        EXPECT_EQ(line_count(result.err), 1) << result.err;
    }
    EXPECT_EQ(gloam("check HALTON-base2 --device nonsense").status, 2) << "without the option";
}

TEST_F(Bisect, ADriverThatCrashesIsBadAndOneThatIsMissingIsSkipped) {
    const auto status_with = [&](const fs::path& manifest) {
        return run_command(words("check HALTON-base2 --inputs 64 --exit-code"), with_driver_alone(manifest))
            .status;
    };
    EXPECT_EQ(status_with(write("crashing.json", manifest_of(GLOAM_CRASHING_DRIVER))), 1);
    EXPECT_EQ(status_with(write("text.json", "no manifest")), skip_this_build);
    EXPECT_EQ(status_with(path("missing.json")), skip_this_build);
}

TEST_F(Bisect, GitNamesTheRevisionThatBrokeADriver) {
    const std::string good = lavapipe();
    if (good.empty()) GTEST_SKIP() << "no lavapipe here (Debian: mesa-vulkan-drivers)";
    if (!fs::exists("/usr/bin/git")) GTEST_SKIP() << "no git here";
    ASSERT_EQ(git("init --quiet").status, 0);
    write(".gitignore", "icd.json\n");
    std::string first_bad;
    for (int number = 0; number < 12; ++number) {
        const bool bad = number >= 7;
        const bool builds = number != 5 && number != 8;
        const std::string hash = commit(number, !builds ? ""
                                                : bad   ? manifest_of(GLOAM_CRASHING_DRIVER)
                                                        : good);
        if (number == 7) first_bad = hash;
    }
    ASSERT_EQ(git("bisect start HEAD HEAD~11").status, 0);
    const CommandResult result =
        git("bisect run {} icd.json HALTON-base2 --inputs 64", GLOAM_EXAMPLES "/laboratory/bisect.sh");
    EXPECT_EQ(result.status, 0) << result.out << result.err;
    EXPECT_THAT(result.out, HasSubstr(first_bad + " is the first bad commit"));
}

}  // namespace gloam::test::check_steps_test
