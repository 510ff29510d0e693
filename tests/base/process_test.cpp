// SPDX-License-Identifier: MIT
#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <system_error>

#include "base/process.hpp"
#include "support/test.hpp"

namespace gloam::base::process_test {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;
using End = ProcessResult::End;
using Heard = WorkerProcess::Heard;

std::vector<std::string> command(const std::string& script) {
    return {"/bin/sh", "-c", script};
}

ProcessResult shell(const std::string& script, const ProcessLimits& limits = {}) {
    return run_process(command(script), limits);
}

TEST(Process, GivesItsOutputAndItsStatus) {
    const ProcessResult result = shell("cat; echo output; echo last words >&2; exit 3");
    EXPECT_EQ(result.output, "output\n");
    EXPECT_EQ(result.errors, "last words");
    EXPECT_EQ(result.number, 3);
    EXPECT_FALSE(result.succeeded());
    EXPECT_EQ(result.how(), "ended with status 3: last words");
    EXPECT_TRUE(shell("true").succeeded());
}

TEST(Process, IsEndedAtItsLimits) {
    const auto begin = std::chrono::steady_clock::now();
    const std::tuple<const char*, ProcessLimits, End> rows[] = {
        {"sleep 30", {.patience = 100ms}, End::time},
        {"exec >&- 2>&-; sleep 30", {.patience = 100ms}, End::time},
        {"while :; do :; done", {.cpu = 1s}, End::signal},
        {"yes", {.output_bytes = 100'000}, End::output},  // without end
        {"yes >&2", {.output_bytes = 100'000}, End::output}};
    for (const auto& [script, limits, end] : rows) EXPECT_EQ(shell(script, limits).end, end) << script;
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 25s);
}

// It would write on without end.
TEST(Process, WhatItStartedEndsWithItsStreams) {
    const ProcessResult result = shell("sh -c 'echo $$; exec yes >&2' & wait", {.output_bytes = 100'000});
    const std::filesystem::path program = "/proc/" + std::to_string(std::stoi(result.output)) + "/exe";
    for (int i = 0; i < 1000 && std::filesystem::exists(program); ++i) std::this_thread::sleep_for(10ms);
    EXPECT_FALSE(std::filesystem::exists(program));
}

// Without a limit the shell would end well, with 256 MiB.
TEST(Process, MemoryIsLimited) {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "no limit there: the sanitizer takes all of the address space";
#endif
    const std::string script = "x=xxxxxxxxxxxxxxxx; for i in 1 2 3 4 5 6 7 8 9 10 11 12; do x=$x$x$x$x; done";
    EXPECT_FALSE(shell(script, {.memory_bytes = 200U << 20U}).succeeded());
}

TEST(Process, WhatCannotBeStartedIsNamed) {
    expect_error<std::system_error>([] { (void)run_process({"no-such-program-anywhere"}, {}); },
                                    {"no-such-program-anywhere"});
}

TEST(Process, NothingOfTheCommandIsForAShell) {
    EXPECT_EQ(run_process({"echo", "$(id); `id`\n'"}, {}).output, "$(id); `id`\n'\n");
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

TEST(Patience, EndsForAProcessThatHasUsedItsLimitOrComputesNothing) {
    // What the process uses until each look, of which the last ends the wait.
    const std::vector<nanoseconds> rows[] = {{0ms},
                                             {20ms},
                                             {5ms, 5ms, 5ms, 5ms},  // it gets a share of the processor
                                             {10ms, 0ms}};
    for (const auto& row : rows) {
        nanoseconds used = 5s;  // before the wait: does not count
        std::size_t looks = 0;
        wait_patiently(
            20ms, [&] { return used; },
            [&](auto until) {
                if (looks++ == row.size()) return true;
                used += row[looks - 1];
                std::this_thread::sleep_until(until);
                return false;
            });
        EXPECT_EQ(looks, row.size());
    }
}

constexpr ProcessLimits few{.memory_bytes = std::uint64_t{200} << 20, .cpu = 1s, .patience = 20s};

TEST(Apart, GivesWhatTheWorkReturned) {
    const std::string much(3'000'000, 'x');
    EXPECT_EQ(run_apart([&] { return much; }, few), much);
    EXPECT_EQ(run_apart([] { return std::string(); }, few), "");
}

TEST(Apart, WhatTheWorkThrowsIsThrown) {
    EXPECT_THAT([] { (void)run_apart([]() -> std::string { throw std::out_of_range("beyond"); }, few); },
                ThrowsMessage<WorkError>("beyond"));
}

// A crash: tests/tools/stories/hostile.txt. Too much memory: Process.MemoryIsLimited.
TEST(Apart, WhatTheWorkDoesToItsProcessIsAnError) {
    using Work = std::string (*)();
    const auto expect = [](Work work, const testing::Matcher<const std::string&>& message,
                           const ProcessLimits& limits = few) {
        EXPECT_THAT([&] { (void)run_apart(work, limits); }, ThrowsMessage<LimitError>(message));
    };
    expect([]() -> std::string { _exit(0); }, testing::_);
    expect(
        []() -> std::string {
            while (std::clock() < 3600 * CLOCKS_PER_SEC) {
            }
            return "";
        },
        "takes more than 1 s");
    expect(
        []() -> std::string {
            std::this_thread::sleep_for(60s);
            return "";
        },
        testing::_, {.cpu = 1s, .patience = 100ms});
}

WorkerProcess::Clock::time_point in(WorkerProcess::Clock::duration time) {
    return WorkerProcess::Clock::now() + time;
}

// Neither running nor waiting to be reaped.
bool is_gone(pid_t process) {
    return kill(process, 0) != 0 && errno == ESRCH;
}

TEST(WorkerProcess, LinesArriveWholeHoweverTheyWereWritten) {
    WorkerProcess worker(
        command("printf 'a\\nb\\nc'; sleep 0.05; printf 'd\\n'; "
                "head -c 300000 /dev/zero | tr '\\0' x; echo; printf rest"));
    std::string line;
    for (const char* want : {"a", "b", "cd"}) {
        ASSERT_EQ(worker.receive(line, in(20s)), Heard::line);
        EXPECT_EQ(line, want);
    }
    ASSERT_EQ(worker.receive(line, in(20s)), Heard::line);
    EXPECT_EQ(line.size(), 300000U);
    EXPECT_EQ(worker.receive(line, in(20s)), Heard::end);  // an unfinished line is no answer
    EXPECT_EQ(worker.end(), "ended with status 0");
}

// How a worker that says nothing more ended.
std::string end_of(WorkerProcess& worker) {
    std::string line;
    EXPECT_EQ(worker.receive(line, in(20s)), Heard::end);
    EXPECT_FALSE(worker.send("anybody?"));
    return worker.end();
}

TEST(WorkerProcess, SaysHowItEnded) {
    const std::pair<const char*, testing::Matcher<std::string>> rows[] = {
        {"kill -9 $$", "ended by signal 9 (KILL: Killed)"},
        {"echo 'first words' >&2; echo 'LLVM ERROR: last words' >&2; kill -SEGV $$",
         "ended by signal 11 (SEGV: Segmentation fault): first words\nLLVM ERROR: last words"},
        {"exit 3", "ended with status 3"},
        {"head -c 100000 /dev/zero | tr '\\0' x >&2; echo the end >&2; exit 1",
         AllOf(testing::SizeIs(testing::Lt(1100U)), EndsWith("xxxthe end"))}};
    for (const auto& [script, end] : rows) {
        WorkerProcess worker(command(script));
        EXPECT_THAT(end_of(worker), end);
    }
}

TEST(WorkerProcess, SilenceEndsAtTheDeadlineAndDeathLeavesNoZombie) {
    pid_t process = 0;
    const auto start = WorkerProcess::Clock::now();
    {
        WorkerProcess worker(command("exec sleep 1000"));
        process = worker.id();
        std::string line;
        EXPECT_EQ(worker.receive(line, in(50ms)), Heard::silence);
        EXPECT_FALSE(is_gone(process));
    }
    EXPECT_LT(WorkerProcess::Clock::now() - start, 5s);
    EXPECT_TRUE(is_gone(process));
}

TEST(WorkerProcess, OneThatClosesItsOutputButLivesOnIsEnded) {
    WorkerProcess worker(command("exec >&- <&-; exec sleep 1000"));
    EXPECT_EQ(end_of(worker), "ended by signal 9 (KILL: Killed)");
    EXPECT_TRUE(is_gone(worker.id()));
}

// How many files a worker finds open.
int open_files() {
    WorkerProcess worker(command("ls /proc/self/fd | wc -l"));
    std::string line;
    EXPECT_EQ(worker.receive(line, in(20s)), Heard::line);
    return std::stoi(line);
}

TEST(WorkerProcess, OneInheritsNothingOfAnother) {
    const int alone = open_files();
    const WorkerProcess other(command("exec sleep 1000"));
    EXPECT_EQ(open_files(), alone);
}

}  // namespace gloam::base::process_test
