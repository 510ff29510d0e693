// SPDX-License-Identifier: MIT
#include "cli/check/worker_session.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "support/run_command.hpp"

namespace gloam::cli {
namespace worker_session_test {

using namespace std::chrono_literals;
using check::Reason;
using testing::HasSubstr;

std::vector<std::string> shell(const std::string& script) {
    return {"/bin/sh", "-c", script};
}

// Greets, then executes the commands that it receives.
const std::vector<std::string> obedient = shell("echo hello; while read -r line; do eval \"$line\"; done");

TEST(WorkerSession, OneWorkerAnswersManyQuestions) {
    WorkerSession session(obedient, 20s);
    EXPECT_EQ(session.greeting(), "hello");
    const std::string first = session.ask("echo $$").line;
    EXPECT_EQ(session.ask("echo $$").line, first);
    EXPECT_EQ(session.ask("echo $((6 * 7))").line, "42");
}

TEST(WorkerSession, ACrashCostsOneQuestion) {
    WorkerSession session(obedient, 20s);
    const std::string first = session.ask("echo $$").line;
    const Reply crashed = session.ask("echo oh no >&2; kill -ABRT $$");
    EXPECT_EQ(crashed.reason, Reason::crash);
    EXPECT_EQ(crashed.error, "the process ended by signal 6 (ABRT: Aborted): oh no");
    const Reply next = session.ask("echo $$");
    EXPECT_EQ(next.reason, Reason::none);
    EXPECT_EQ(next.error, "");
    EXPECT_NE(next.line, first);
}

TEST(WorkerSession, AnExitWithoutAnAnswerIsACrashToo) {
    WorkerSession session(obedient, 20s);
    const Reply answer = session.ask("exit 0");
    EXPECT_EQ(answer.reason, Reason::crash);
    EXPECT_THAT(answer.error, HasSubstr("ended with status 0"));
}

TEST(WorkerSession, SilenceIsAHangAndCostsOneQuestion) {
    WorkerSession session(obedient, 300ms);
    const auto start = std::chrono::steady_clock::now();
    const Reply hung = session.ask("sleep 1000");
    EXPECT_EQ(hung.reason, Reason::hang);
    EXPECT_EQ(hung.error, "not finished after 0.3 s, the time limit");
    EXPECT_LT(std::chrono::steady_clock::now() - start, 10s);
    EXPECT_EQ(session.ask("echo alive").line, "alive");
}

TEST(WorkerSession, AWorkerThatWasDismissedIsReplaced) {
    WorkerSession session(obedient, 20s);
    const std::string first = session.ask("echo $$").line;
    session.dismiss();
    EXPECT_NE(session.ask("echo $$").line, first);
}

TEST(WorkerSession, AWorkerThatNeverGreetsIsTriedTwiceAndNoMore) {
    const test::TemporaryDirectory folder;
    const std::string log = (folder.path() / "log").string();
    WorkerSession session(shell("echo start >> " + log + "; echo no driver >&2; kill -9 $$"), 20s);
    EXPECT_THAT([&] { (void)session.ask("echo"); },
                testing::ThrowsMessage<NoWorker>("the process ended by signal 9 (KILL: Killed): no driver"));
    std::ifstream stream(log);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), "start\nstart\n");
}

TEST(WorkerSession, AWorkerThatFailsOnceBeforeItsGreetingIsForgiven) {
    const test::TemporaryDirectory folder;
    const std::string mark = (folder.path() / "mark").string();
    WorkerSession session(
        shell("[ -e " + mark + " ] || { touch " + mark + "; exit 1; }; echo hello; read line; echo $line"),
        20s);
    EXPECT_EQ(session.ask("word").line, "word");
}

TEST(WorkerSession, AGreetingMayTakeAsLongAsAnAnswer) {
    WorkerSession session(shell("exec sleep 1000"), 100ms);
    try {
        (void)session.greeting();
        FAIL() << "nothing thrown";
    } catch (const NoWorker& none) {
        EXPECT_EQ(none.reason, Reason::hang);
    }
}

TEST(WorkerSession, ARefusalIsNotTriedAgain) {
    int asked = 0;
    WorkerSession session(shell("echo no; read line"), 20s, [&](const std::string& greeting) {
        ++asked;
        return greeting == "no" ? "it says no" : "";
    });
    try {
        (void)session.ask("word");
        FAIL() << "nothing thrown";
    } catch (const NoWorker& none) {
        EXPECT_EQ(none.reason, Reason::error);
        EXPECT_STREQ(none.what(), "it says no");
    }
    EXPECT_EQ(asked, 1);
}

}  // namespace worker_session_test
}  // namespace gloam::cli
