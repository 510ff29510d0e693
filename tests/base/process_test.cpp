// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>
#include <system_error>
#include <thread>

#include "base/process.hpp"
#include "base/threads.hpp"

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

TEST(Process, GetsItsOwnEnvironmentInTheirPlace) {
    ProcessLimits limits;
    limits.environment = {"HOME=/nowhere", "GLOAM_TEST=a b=c"};
    EXPECT_EQ(shell("echo $HOME $GLOAM_TEST; env | grep -c ^HOME=", limits).output, "/nowhere a b=c\n1\n");
    EXPECT_EQ(shell("echo $GLOAM_TEST", {}).output, "\n");
}

TEST(Process, AGroupEndsWithIt) {
    const ProcessLimits limits{.patience = std::chrono::milliseconds(500), .group = true};
    const ProcessResult result = shell("sleep 1000 & echo $!; wait", limits);
    EXPECT_EQ(result.end, ProcessResult::End::time);
    const pid_t below = std::stoi(result.output);
    for (int i = 0; i < 100 && kill(below, 0) == 0; ++i) {
        // Killed, but perhaps not waited for: there may be no process that does.
        const std::string state = shell("cut -d' ' -f3 /proc/" + result.output, {}).output;
        if (state.empty() || state.starts_with("Z")) return;
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    EXPECT_NE(kill(below, 0), 0);
}

using std::chrono::nanoseconds;

void wait_for(const Patience& patience) {
    std::this_thread::sleep_until(patience.next_look());
}

TEST(Patience, EndsNoEarlierThanItsLimit) {
    Patience patience(10s, [] { return nanoseconds(0); });
    EXPECT_FALSE(patience.is_over());
    EXPECT_GT(patience.next_look() - Patience::Clock::now(), 5s);
}

TEST(Patience, EndsAtItsLimitForAProcessThatComputesNothing) {
    Patience patience(20ms, [] { return nanoseconds(0); });
    wait_for(patience);
    EXPECT_TRUE(patience.is_over());
}

TEST(Patience, EndsAtItsLimitForAProcessThatHasUsedIt) {
    nanoseconds used = 5s;  // before the wait: does not count
    Patience patience(20ms, [&] { return used; });
    used += 20ms;
    wait_for(patience);
    EXPECT_TRUE(patience.is_over());
}

TEST(Patience, GoesOnWhileAProcessGetsOnlyAShareOfTheProcessor) {
    nanoseconds used = 0s;
    Patience patience(20ms, [&] { return used; });
    for (int look = 0; look < 3; ++look) {
        used += 5ms;
        wait_for(patience);
        EXPECT_FALSE(patience.is_over()) << look;
    }
    used += 5ms;
    wait_for(patience);
    EXPECT_TRUE(patience.is_over());
}

TEST(Patience, EndsForAProcessThatStopsComputing) {
    nanoseconds used = 0s;
    Patience patience(20ms, [&] { return used; });
    used += 10ms;
    wait_for(patience);
    EXPECT_FALSE(patience.is_over());
    wait_for(patience);
    EXPECT_TRUE(patience.is_over());
}

TEST(ProcessorTime, GrowsWithWorkAndIsZeroForAProcessThatHasEnded) {
    const nanoseconds before = processor_time_of(getpid());
    while (processor_time_of(getpid()) < before + 20ms) {
    }
    const pid_t child = fork();
    if (child == 0) _exit(0);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_EQ(processor_time_of(child), 0s);
}

TEST(Threads, SharesCoverEveryIndexOnceAndAreNeverEmpty) {
    for (const std::size_t count : {0U, 1U, 2U, 7U, 8U, 1000U}) {
        for (const std::size_t most : {1U, 2U, 3U, 16U}) {
            const std::vector<Range> shares = shares_of(count, most);
            EXPECT_LE(shares.size(), most);
            std::size_t next = 0;
            for (const Range& share : shares) {
                EXPECT_EQ(share.begin, next);
                EXPECT_LT(share.begin, share.end);
                next = share.end;
            }
            EXPECT_EQ(next, count) << most;
        }
    }
    EXPECT_GE(processors(), 1U);
}

}  // namespace process_test

}  // namespace gloam::base
