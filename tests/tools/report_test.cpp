// SPDX-License-Identifier: MIT
#include "tools/gloam.hpp"

namespace gloam::test::report_test {

class ReportCommand : public InFolder {
  protected:
    // Results of a check, and the same with a failure on another build of the driver.
    ReportCommand() {
        expect_success(gloam("check gloam_radical_* --inputs 64 --json {}", good));
        json report = json::parse(read_file(good));
        report["results"][0]["outside"] = 5;
        report["results"][0]["outcome"] = "failed";
        report["results"][0]["classes"].begin().value()["outside"] = 5;
        write("bad.json", report.dump());
        report["device"]["driver"] = "another build";
        write("other.json", report.dump());
        report["results"][1]["inputs"] = "many";
        write("field.json", report.dump());
    }

    const fs::path good = path("good.json");
};

// A failure is status 1, and conflicts are said; so is what newly failed and what was mended.
TEST_F(ReportCommand, TellsFailuresConflictsAndChanges) {
    const CommandResult both = gloam("report {} {}", good, path("bad.json"));
    EXPECT_EQ(both.status, 1);
    EXPECT_EQ(both.err, "");
    EXPECT_THAT(both.out, AllOf(HasSubstr("FAIL 5/64"), HasSubstr("the worse is kept"),
                                HasSubstr(path("bad.json").string())));
    EXPECT_THAT(output_of(gloam("report {} --since {}", good, path("other.json"))), HasSubstr(": mended\n"));
    const CommandResult later = gloam("report {} --since {}", path("other.json"), good);
    EXPECT_EQ(later.status, 1);
    EXPECT_THAT(later.out, HasSubstr("(another build): newly failed\n"));
    expect_could_not_run(gloam("report {} --since {}", good, path("none.json")), "none.json");
    expect_could_not_run(gloam("report {}", path("field.json")),
                         "results[1].inputs: expected a count, found \"many\"");
}

// Each task of the array writes its shard, and a task that runs again keeps what is there.
TEST_F(ReportCommand, TheTasksOfAJobArrayAreShards) {
    const fs::path program = GLOAM_BUILT_BINARY;
    const auto task = [&](const std::string& index) {
        return run_program(
            "/bin/bash",
            words(GLOAM_EXAMPLES "/laboratory/slurm.sh 2 {} gloam_radical_* --inputs 64", path("all")),
            {.environment = {"SLURM_ARRAY_TASK_ID=" + index,
                             "PATH=" + program.parent_path().string() + ":/usr/bin:/bin"}});
    };
    for (const char* index : {"0", "1", "1"}) expect_success(task(index));
    const std::string both = output_of(gloam("report {} {}", path("all/1.json"), path("all/0.json")));
    EXPECT_EQ(both, output_of(gloam("report {}", good)));
}

// A failure is handed over ready to report.

class Failures : public testing::Test {
  protected:
    // Of a check of one function: `more` are further words.
    [[nodiscard]] CommandResult check(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> all = words("check gloam_radical_inverse_base2 --inputs 65536 --failures {}",
                                             installation_.file("failures"));
        all.insert(all.end(), more.begin(), more.end());
        return run_program(installation_.program(), all);
    }

    // The folder of the only failure, of whatever device.
    [[nodiscard]] fs::path folder() const {
        std::vector<fs::path> found;
        if (fs::exists(installation_.file("failures")))
            for (const auto& device : fs::directory_iterator(installation_.file("failures")))
                for (const auto& failure : fs::directory_iterator(device)) found.push_back(failure);
        EXPECT_EQ(found.size(), 1U);
        return found.empty() ? fs::path() : found.front();
    }

    [[nodiscard]] std::string text(const char* file) const { return read_file(folder() / file); }

    const Installation installation_;
};

void expect_valid(const fs::path& module) {
    const CommandResult valid = run_program("spirv-val", words("--target-env vulkan1.2 {}", module));
    EXPECT_EQ(valid.status, 0) << valid.err;
}

void expect_assembles(const fs::path& assembly) {
    const fs::path module = assembly.parent_path() / "again.spv";
    const CommandResult assembled =
        run_program("spirv-as", words("--target-env spv1.5 {} -o {}", assembly, module));
    EXPECT_EQ(assembled.status, 0) << assembled.err;
    expect_valid(module);
}

TEST_F(Failures, AWrongResultIsHandedOverWhole) {
    installation_.spoil_radical_inverse_base2();
    for (const std::vector<std::string>& how : {std::vector<std::string>{"--in-process"}, {"--jobs", "2"}}) {
        fs::remove_all(installation_.file("failures"));
        const CommandResult result = check(how);
        EXPECT_EQ(result.status, 1);
        EXPECT_EQ(result.err, "");
        EXPECT_EQ(folder().filename(), "halton-base2-shipped");
        EXPECT_THAT(text("report.txt"),
                    HasSubstr("uint 1 (0x00000001)"));  // no simpler index has an odd result
        EXPECT_THAT(text("report.txt"), HasSubstr("want 0.5"));
        EXPECT_THAT(text("shader.comp"), HasSubstr("float gloam_radical_inverse_base2(uint index)"));
        EXPECT_THAT(text("repro.c"), testing::ContainsRegex("#define FOUND_ON \"[^\"]+\"\n"));
    }
    expect_valid(folder() / "shader.spv");
    expect_assembles(folder() / "shader.spvasm");
    const std::string script = text("repro.amber");
    EXPECT_THAT(script, HasSubstr("EXPECT floats IDX 0 GE 0.500000000"));
    const std::size_t begin = script.find('\n', script.find("SHADER compute")) + 1;
    const fs::path assembly = installation_.file("amber.spvasm");
    std::ofstream(assembly) << script.substr(begin, script.find("END", begin) - begin);
    expect_assembles(assembly);
}

// The command in report.txt is complete: run unchanged in a shell, it finds exactly the same failure.
TEST_F(Failures, RunItAgainReproducesToTheBit) {
    installation_.spoil_radical_inverse_base2();
    const fs::path first = installation_.file("first.json");
    EXPECT_EQ(check(words("--seed 12345 --variant optimized --json {}", first)).status, 1);
    const std::string report = text("report.txt");
    for (const char* part : {"Versions: gloam ", "glslang ", "SPIRV-Tools "})
        EXPECT_THAT(report, HasSubstr(part));
    const std::string mark = "Run it again: gloam ";
    const std::size_t begin = report.find(mark) + mark.size();
    const std::string command = report.substr(begin, report.find('\n', begin) - begin);
    for (const char* part : {"--variant optimized", "--device ", "--inputs 65536", "--seed 12345"})
        EXPECT_THAT(command, HasSubstr(part));
    const fs::path second = installation_.file("second.json");
    const CommandResult again = run_program(
        "/bin/sh",
        words("-c {}", installation_.program().string() + " " + command + " --json " + second.string()));
    EXPECT_EQ(again.status, 1) << again.err;
    EXPECT_THAT(again.out, HasSubstr("run it again: gloam " + command));
    auto one = json::parse(read_file(first));
    auto other = json::parse(read_file(second));
    one["results"][0].erase("seconds");
    other["results"][0].erase("seconds");
    EXPECT_EQ(one, other);
}

TEST_F(Failures, WhatDoesNotCompileHasAReportThatSaysSo) {
    installation_.replace("gloam/sampling/halton.glsl", "uint bits = ", "uint bits = no_such_variable + ");
    EXPECT_EQ(check().status, 1);
    EXPECT_THAT(text("report.txt"), HasSubstr("could not be made"));
    EXPECT_FALSE(fs::exists(folder() / "shader.spv"));
}

TEST_F(Failures, AnAccessOutsideAnImageComesWithTheImage) {
    installation_.replace("gloam/geometry/camera_normal.glsl", "gloam_fetch_depth(pixel)",
                          "gloam_fetch_depth(pixel - ivec2(1, 0))");
    const fs::path failures = installation_.file("failures");
    const CommandResult result =
        installation_.gloam("check gloam_camera_normal* --inputs 4096 --failures {}", failures);
    EXPECT_EQ(result.status, 1) << result.out << result.err;
    ASSERT_TRUE(fs::exists(failures));
    const fs::path device = fs::directory_iterator(failures)->path();
    EXPECT_THAT(read_file(fs::directory_iterator(device)->path() / "repro.amber"),
                HasSubstr("BUFFER image0 DATA_TYPE uint32"));
}

}  // namespace gloam::test::report_test
