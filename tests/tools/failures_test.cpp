// SPDX-License-Identifier: MIT
// A failure is handed over ready to report.
#include <nlohmann/json.hpp>
#include <vector>

#include "tools/expect.hpp"
#include "tools/installation.hpp"

namespace gloam::test {
namespace failures_test {

namespace fs = std::filesystem;
using testing::AnyOf;
using testing::HasSubstr;

constexpr const char* shader_file = "gloam/sampling/radical_inverse.glsl";

// The folders of the failures of one device.
std::vector<fs::path> folders(const fs::path& failures) {
    std::vector<fs::path> found;
    if (!fs::exists(failures)) return found;
    for (const auto& device : fs::directory_iterator(failures)) {
        for (const auto& failure : fs::directory_iterator(device)) found.push_back(failure);
    }
    return found;
}

CommandResult check(const Installation& installation, const fs::path& failures,
                    const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{
        "check", "gloam_radical_inverse_base2", "--inputs", "65536", "--failures", failures.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(installation.program(), arguments);
}

void expect_assembles(const fs::path& assembly) {
    const fs::path module = assembly.parent_path() / "again.spv";
    const CommandResult assembled =
        run_program("spirv-as", {"--target-env", "spv1.5", assembly.string(), "-o", module.string()});
    EXPECT_EQ(assembled.status, 0) << assembled.err;
    const CommandResult valid = run_program("spirv-val", {"--target-env", "vulkan1.2", module.string()});
    EXPECT_EQ(valid.status, 0) << valid.err;
}

TEST(Failures, AWrongResultIsHandedOverWhole) {
    const Installation installation;
    installation.replace(shader_file, "5.9604644775390625e-8", "5.9604652e-8");
    for (const std::vector<std::string>& how :
         {std::vector<std::string>{}, {"--in-process"}, {"--jobs", "2"}}) {
        const fs::path failures = installation.file("failures" + std::to_string(how.size()));
        const CommandResult result = check(installation, failures, how);
        EXPECT_EQ(result.status, 1);
        EXPECT_EQ(result.err, "");
        ASSERT_EQ(folders(failures).size(), 1U);
        const fs::path folder = folders(failures).front();
        EXPECT_EQ(folder.filename(), "halton-base2-shipped");
        const std::string report = read_file(folder / "report.txt");
        EXPECT_THAT(report, HasSubstr("uint 1 (0x00000001)"));  // no simpler index has an odd result
        EXPECT_THAT(report, HasSubstr("want 0.5"));
        EXPECT_THAT(read_file(folder / "shader.comp"),
                    HasSubstr("float gloam_radical_inverse_base2(uint index)"));
        EXPECT_THAT(read_file(folder / "repro.amber"), HasSubstr("EXPECT floats IDX 0 GE 0.500000000"));
        const CommandResult valid =
            run_program("spirv-val", {"--target-env", "vulkan1.2", (folder / "shader.spv").string()});
        EXPECT_EQ(valid.status, 0) << valid.err;
        expect_assembles(folder / "shader.spvasm");
    }
}

// The command in report.txt is complete: run unchanged in a shell, it finds exactly the same failure.
TEST(Failures, RunItAgainReproducesToTheBit) {
    const Installation installation;
    installation.replace(shader_file, "5.9604644775390625e-8", "5.9604652e-8");
    const fs::path failures = installation.file("failures");
    const fs::path first = installation.file("first.json");
    EXPECT_EQ(
        check(installation, failures, {"--seed", "12345", "--variant", "optimized", "--json", first.string()})
            .status,
        1);
    ASSERT_EQ(folders(failures).size(), 1U);
    const std::string report = read_file(folders(failures).front() / "report.txt");
    for (const char* part : {"Versions: gloam ", "glslang ", "SPIRV-Tools "})
        EXPECT_THAT(report, HasSubstr(part));
    const std::string mark = "Run it again: gloam ";
    const std::size_t begin = report.find(mark) + mark.size();
    const std::string command = report.substr(begin, report.find('\n', begin) - begin);
    for (const char* part : {"--variant optimized", "--device ", "--inputs 65536", "--seed 12345"})
        EXPECT_THAT(command, HasSubstr(part));
    const fs::path second = installation.file("second.json");
    const CommandResult again = run_program(
        "/bin/sh", {"-c", installation.program().string() + " " + command + " --json " + second.string()});
    EXPECT_EQ(again.status, 1) << again.err;
    EXPECT_THAT(again.out, HasSubstr("run it again: gloam " + command));
    auto one = nlohmann::json::parse(read_file(first));
    auto other = nlohmann::json::parse(read_file(second));
    one["results"][0].erase("seconds");
    other["results"][0].erase("seconds");
    EXPECT_EQ(one, other);
}

TEST(Failures, TheAssemblyInTheAmberScriptIsAModule) {
    const Installation installation;
    installation.replace(shader_file, "5.9604644775390625e-8", "5.9604652e-8");
    const fs::path failures = installation.file("failures");
    check(installation, failures);
    ASSERT_EQ(folders(failures).size(), 1U);
    const std::string script = read_file(folders(failures).front() / "repro.amber");
    const std::size_t begin = script.find('\n', script.find("SHADER compute")) + 1;
    const fs::path assembly = installation.file("amber.spvasm");
    std::ofstream(assembly) << script.substr(begin, script.find("END", begin) - begin);
    expect_assembles(assembly);
}

TEST(Failures, AHangIsHandedOverWithoutRunningItAgain) {
    const Installation installation;
    installation.make_radical_inverse_base2_hang();
    const fs::path failures = installation.file("failures");
    EXPECT_EQ(check(installation, failures, {"--timeout", "1.5"}).status, 1);
    ASSERT_EQ(folders(failures).size(), 1U);
    const fs::path folder = folders(failures).front();
    // The worker's processor time and its wait for the device are limited alike: either may end first.
    EXPECT_THAT(read_file(folder / "report.txt"),
                AnyOf(HasSubstr("hang: not finished after 1.5 s"), HasSubstr("submission within 1.5 s")));
    EXPECT_THAT(read_file(folder / "repro.amber"), HasSubstr("not judged"));
    EXPECT_THAT(read_file(folder / "shader.comp"), HasSubstr("spin"));
}

TEST(Failures, WhatDoesNotCompileHasAReportThatSaysSo) {
    const Installation installation;
    installation.replace(shader_file, "uint bits = ", "uint bits = no_such_variable + ");
    const fs::path failures = installation.file("failures");
    EXPECT_EQ(check(installation, failures).status, 1);
    ASSERT_EQ(folders(failures).size(), 1U);
    const fs::path folder = folders(failures).front();
    EXPECT_THAT(read_file(folder / "report.txt"), HasSubstr("could not be made"));
    EXPECT_FALSE(fs::exists(folder / "shader.spv"));
}

TEST(Failures, AnAccessOutsideAnImageComesWithTheImage) {
    const Installation installation;
    installation.replace("gloam/geometry/normal_from_depth.glsl", "gloam_fetch_depth(pixel)",
                         "gloam_fetch_depth(pixel - ivec2(1, 0))");
    const fs::path failures = installation.file("failures");
    const CommandResult result = run_program(
        installation.program(),
        {"check", "gloam_normal_from_depth*", "--inputs", "4096", "--failures", failures.string()});
    EXPECT_EQ(result.status, 1) << result.out << result.err;
    ASSERT_FALSE(folders(failures).empty());
    EXPECT_THAT(read_file(folders(failures).front() / "repro.amber"),
                HasSubstr("BUFFER image0 DATA_TYPE uint32"));
}

TEST(Failures, WithoutAnyNothingIsLeft) {
    const Installation installation;
    const fs::path failures = installation.file("failures");
    expect_success(check(installation, failures));
    EXPECT_FALSE(fs::exists(failures));
}

TEST(Failures, AFolderThatCannotBeIsNamed) {
    const TemporaryDirectory folder;
    const fs::path file = folder.path() / "file";
    std::ofstream(file) << "x";
    expect_could_not_run(run_command({"check", "HALTON", "--failures", (file / "below").string()}),
                         file.string());
}

}  // namespace failures_test
}  // namespace gloam::test
