// SPDX-License-Identifier: MIT
#include "support/run_command.hpp"

#include <gmock/gmock.h>

#include <fstream>

namespace gloam::test::run_command_test {

TEST(RunProgram, KeepsStatusOutputAndErrorsApart) {
    const CommandResult result = run_program("/bin/sh", {"-c", "echo out; echo err >&2; exit 3"});
    EXPECT_EQ(result.status, 3);
    EXPECT_EQ(result.out, "out\n");
    EXPECT_EQ(result.err, "err\n");
}

TEST(RunProgram, ReportsASignalAsShellsDo) {
    EXPECT_EQ(run_program("/bin/sh", {"-c", "kill -SEGV $$"}).status, 128 + 11);
}

TEST(RunProgram, PassesArgumentsUnchanged) {
    EXPECT_EQ(run_program("printf", {"%s|%s", "a b", "$HOME *"}).out, "a b|$HOME *");
}

TEST(RunProgram, ReplacesTheNamedVariablesOnly) {
    const CommandResult result = run_program("/bin/sh", {"-c", "echo $GLOAM_TEST_A${PATH:+ path}"},
                                             {.environment = {"GLOAM_TEST_A=1"}});
    EXPECT_EQ(result.out, "1 path\n");
}

TEST(RunProgram, RunsInTheGivenDirectory) {
    const TemporaryDirectory directory;
    ASSERT_EQ(run_program("touch", words("here"), {.working_directory = directory.path()}).status, 0);
    EXPECT_TRUE(std::filesystem::exists(directory.path() / "here"));
}

TEST(RunProgram, StandsMoreOutputThanAPipeHolds) {
    EXPECT_EQ(run_program("/bin/sh", {"-c", "head -c 300000 /dev/zero | tr '\\0' x"}).out.size(), 300000U);
}

TEST(RunProgram, ThrowsWhenTheProgramCannotStartOrDoesNotEnd) {
    EXPECT_THROW(static_cast<void>(run_program("/no/such/program", {})), std::runtime_error);
    EXPECT_THROW(static_cast<void>(run_program("sleep", words("60"), {.timeout = std::chrono::seconds(0)})),
                 std::runtime_error);
}

TEST(TemporaryDirectory, LeavesNothingBehind) {
    std::filesystem::path path;
    {
        const TemporaryDirectory directory;
        path = directory.path();
        std::ofstream(path / "file") << "text";
        ASSERT_TRUE(std::filesystem::exists(path / "file"));
    }
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(LineCount, CountsALastLineWithoutItsNewline) {
    EXPECT_EQ(line_count(""), 0);
    EXPECT_EQ(line_count("a\n"), 1);
    EXPECT_EQ(line_count("a\nb"), 2);
}

}  // namespace gloam::test::run_command_test
