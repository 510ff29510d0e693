// SPDX-License-Identifier: MIT
#include "base/process.hpp"

#include <gmock/gmock.h>

#include <csignal>
#include <system_error>

namespace gloam::base {
namespace process_test {

using namespace std::chrono_literals;
using End = ProcessResult::End;
using testing::HasSubstr;

ProcessResult shell(const std::string& script, const ProcessLimits& limits = {},
                    std::string_view input = {}) {
    return run_process({"/bin/sh", "-c", script}, input, limits);
}

TEST(Process, GivesItsOutputAndItsStatus) {
    const ProcessResult result = shell("cat; echo last words >&2; exit 3", {}, "some input");
    EXPECT_EQ(result.output, "some input");
    EXPECT_EQ(result.errors, "last words");
    EXPECT_EQ(result.number, 3);
    EXPECT_FALSE(result.succeeded());
    EXPECT_EQ(result.how(), "ended with status 3: last words");
    EXPECT_TRUE(shell("true").succeeded());
}

TEST(Process, TakesMuchInputWhileItGivesMuchOutput) {
    const std::string much(3'000'000, 'x');
    EXPECT_EQ(shell("cat", {}, much).output, much);
    EXPECT_TRUE(shell("exec <&-; echo done", {}, much).succeeded());  // it need not listen
}

TEST(Process, ASignalIsNamed) {
    const ProcessResult result = shell("kill -SEGV $$");
    EXPECT_EQ(result.end, End::signal);
    EXPECT_EQ(result.number, SIGSEGV);
    EXPECT_THAT(result.how(), HasSubstr("ended by signal 11 (SEGV: Segmentation fault)"));
}

TEST(Process, EndsWhenItsTimeIsOver) {
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(shell("sleep 30", {.patience = 100ms}).end, End::time);
    EXPECT_EQ(shell("exec >&- 2>&-; sleep 30", {.patience = 100ms}).end, End::time);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 20s);
}

TEST(Process, ProcessorTimeIsLimited) {
    const ProcessResult result = shell("while :; do :; done", {.cpu = 1s});
    EXPECT_EQ(result.end, End::signal);
    EXPECT_EQ(result.number, SIGXCPU);
}

TEST(Process, MemoryIsLimited) {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "no limit there: the sanitizer takes all of the address space";
#endif
    const std::string script = "x=xxxxxxxxxxxxxxxx; while :; do x=$x$x$x$x; done";
    EXPECT_FALSE(shell(script, {.memory_bytes = 200U << 20U}).succeeded());
}

TEST(Process, OutputWithoutEndIsCutOff) {
    EXPECT_EQ(shell("yes", {.output_bytes = 100'000}).end, End::output);
}

TEST(Process, WhatCannotBeStartedIsNamed) {
    EXPECT_THAT([] { (void)run_process({"no-such-program-anywhere"}, "", {}); },
                testing::ThrowsMessage<std::system_error>(HasSubstr("no-such-program-anywhere")));
}

TEST(Process, NothingOfTheCommandIsForAShell) {
    EXPECT_EQ(run_process({"echo", "$(id); `id`\n'"}, "", {}).output, "$(id); `id`\n'\n");
}

}  // namespace process_test
}  // namespace gloam::base
