// SPDX-License-Identifier: MIT
#include "base/process.hpp"

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <cerrno>
#include <csignal>
#include <system_error>
#include <thread>

namespace gloam::base {
namespace worker_process_test {

using namespace std::chrono_literals;
using testing::HasSubstr;
using Heard = WorkerProcess::Heard;

std::vector<std::string> shell(const std::string& script) {
    return {"/bin/sh", "-c", script};
}

WorkerProcess::Clock::time_point in(WorkerProcess::Clock::duration time) {
    return WorkerProcess::Clock::now() + time;
}

// Neither running nor waiting to be reaped.
bool is_gone(pid_t process) {
    return kill(process, 0) != 0 && errno == ESRCH;
}

TEST(WorkerProcess, AnswersLinesWithLines) {
    WorkerProcess worker(shell("while read -r line; do echo \"got $line\"; done"));
    std::string line;
    for (const std::string word : {"one", "two words", ""}) {
        ASSERT_TRUE(worker.send(word));
        ASSERT_EQ(worker.receive(line, in(20s)), Heard::line);
        EXPECT_EQ(line, "got " + word);
    }
}

TEST(WorkerProcess, LinesArriveWholeHoweverTheyWereWritten) {
    WorkerProcess worker(
        shell("printf 'a\\nb\\nc'; sleep 0.05; printf 'd\\n'; "
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

TEST(WorkerProcess, SaysHowItEnded) {
    std::string line;
    WorkerProcess killed(shell("kill -9 $$"));
    EXPECT_EQ(killed.receive(line, in(20s)), Heard::end);
    EXPECT_EQ(killed.end(), "ended by signal 9 (KILL: Killed)");
    EXPECT_FALSE(killed.send("anybody?"));

    WorkerProcess crashed(shell("echo 'first words' >&2; echo 'LLVM ERROR: last words' >&2; kill -SEGV $$"));
    EXPECT_EQ(crashed.receive(line, in(20s)), Heard::end);
    EXPECT_EQ(crashed.end(),
              "ended by signal 11 (SEGV: Segmentation fault): first words\nLLVM ERROR: last words");

    WorkerProcess left(shell("exit 3"));
    EXPECT_EQ(left.receive(line, in(20s)), Heard::end);
    EXPECT_EQ(left.end(), "ended with status 3");
}

TEST(WorkerProcess, KeepsTheEndOfWhatWasSaidOnStandardError) {
    WorkerProcess worker(shell("head -c 100000 /dev/zero | tr '\\0' x >&2; echo the end >&2; exit 1"));
    std::string line;
    EXPECT_EQ(worker.receive(line, in(20s)), Heard::end);
    const std::string text = worker.end();
    EXPECT_LT(text.size(), 1100U);
    EXPECT_THAT(text, testing::EndsWith("xxxthe end"));
}

TEST(WorkerProcess, SilenceEndsAtTheDeadlineAndDeathLeavesNoZombie) {
    pid_t process = 0;
    const auto start = WorkerProcess::Clock::now();
    {
        WorkerProcess worker(shell("exec sleep 1000"));
        process = worker.id();
        std::string line;
        EXPECT_EQ(worker.receive(line, in(50ms)), Heard::silence);
        EXPECT_FALSE(is_gone(process));
    }
    EXPECT_LT(WorkerProcess::Clock::now() - start, 5s);
    EXPECT_TRUE(is_gone(process));
}

TEST(WorkerProcess, OneThatClosesItsOutputButLivesOnIsEnded) {
    WorkerProcess worker(shell("exec >&- <&-; exec sleep 1000"));
    std::string line;
    EXPECT_EQ(worker.receive(line, in(20s)), Heard::end);
    EXPECT_EQ(worker.end(), "ended by signal 9 (KILL: Killed)");
    EXPECT_TRUE(is_gone(worker.id()));
}

TEST(WorkerProcess, DiesWithTheThreadThatStartedIt) {
    pid_t process = 0;
    auto* leaked = static_cast<WorkerProcess*>(nullptr);
    std::thread([&] {
        leaked = new WorkerProcess(shell("exec sleep 1000"));
        process = leaked->id();
    }).join();
    std::string line;
    EXPECT_EQ(leaked->receive(line, in(20s)), Heard::end);
    EXPECT_EQ(leaked->end(), "ended by signal 9 (KILL: Killed)");
    delete leaked;
    EXPECT_TRUE(is_gone(process));
}

// How many files a worker finds open.
int open_files() {
    WorkerProcess worker(shell("ls /proc/self/fd | wc -l"));
    std::string line;
    EXPECT_EQ(worker.receive(line, in(20s)), Heard::line);
    return std::stoi(line);
}

TEST(WorkerProcess, OneInheritsNothingOfAnother) {
    const int alone = open_files();
    const WorkerProcess other(shell("exec sleep 1000"));
    EXPECT_EQ(open_files(), alone);
}

TEST(WorkerProcess, AProgramThatIsNotThereIsNamed) {
    EXPECT_THAT([] { WorkerProcess worker({"/no/such/program"}); },
                testing::ThrowsMessage<std::system_error>(HasSubstr("/no/such/program: No such file")));
}

}  // namespace worker_process_test
}  // namespace gloam::base
