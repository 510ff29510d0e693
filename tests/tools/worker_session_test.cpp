// SPDX-License-Identifier: MIT
#include "cli/framework/check/worker_session.hpp"
#include "tools/gloam.hpp"

namespace gloam::test::worker_session_test {

using cli::NoWorker;
using cli::WorkerSession;
using namespace std::chrono_literals;

// Whose driver failed once, perhaps; one that fails again is no worker.
TEST(WorkerSession, AWorkerThatDoesNotGreetIsTriedTwice) {
    const TemporaryDirectory folder;
    const std::string log = (folder.path() / "log").string();
    const auto session = [&](const std::string& script) {
        return WorkerSession({"/bin/sh", "-c", "echo start >> " + log + "; " + script}, 20s);
    };
    const std::string mark = (folder.path() / "mark").string();
    EXPECT_EQ(
        session("[ -e " + mark + " ] || { touch " + mark + "; exit 1; }; echo hello; read line; echo $line")
            .ask("word")
            .line,
        "word");
    EXPECT_THAT([&] { (void)session("echo no driver >&2; kill -9 $$").ask("echo"); },
                ThrowsMessage<NoWorker>("the process ended by signal 9 (KILL: Killed): no driver"));
    EXPECT_EQ(read_file(log), "start\nstart\nstart\nstart\n");
}

}  // namespace gloam::test::worker_session_test
