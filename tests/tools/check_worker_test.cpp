// SPDX-License-Identifier: MIT
// What a driver does to a worker of `gloam check` costs one check.
#include <csignal>

#include "base/process.hpp"
#include "cli/framework/check/worker_session.hpp"
#include "support/run_command.hpp"
#include "tools/gloam.hpp"

namespace gloam::test::check_worker_test {

using base::WorkerProcess;
using cli::NoWorker;
using cli::WorkerSession;
using namespace std::chrono_literals;

constexpr const char* hanging = "HALTON-base2";

// The process whose parent is this one; 0 when there is none.
pid_t child_of(pid_t parent) {
    for (const auto& entry : fs::directory_iterator("/proc")) {
        const std::string name = entry.path().filename();
        if (name.find_first_not_of("0123456789") != std::string::npos) continue;
        const std::string status = read_file(entry.path() / "status");
        if (status.find("\nPPid:\t" + std::to_string(parent) + "\n") != std::string::npos)
            return std::stoi(name);
    }
    return 0;
}

bool ends_soon(pid_t process) {
    for (int i = 0; i < 1000; ++i) {
        const std::string status = read_file("/proc/" + std::to_string(process) + "/status");
        if (status.empty() || status.find("State:\tZ") != std::string::npos) return true;
        std::this_thread::sleep_for(10ms);
    }
    return false;
}

std::map<std::string, json> rows_by_equation(const json& report) {
    std::map<std::string, json> rows;
    for (const json& row : report.at("results")) rows[row.at("equation")] = row;
    return rows;
}

// `gloam check` of an installation whose HALTON-base2 hangs, with a worker that is in it.
class HangingCheck {
  public:
    explicit HangingCheck(const Installation& installation) : check_(command(installation)) {
        std::string line;
        // The device is named when its worker has greeted.
        EXPECT_EQ(check_.receive(line, WorkerProcess::Clock::now() + 60s), WorkerProcess::Heard::line);
        EXPECT_THAT(line, StartsWith("device: "));
        worker_ = child_of(check_.id());
        EXPECT_NE(worker_, 0);
    }

    [[nodiscard]] WorkerProcess& check() { return check_; }
    [[nodiscard]] pid_t worker() const { return worker_; }

  private:
    static std::vector<std::string> command(const Installation& installation) {
        installation.make_radical_inverse_base2_hang();
        return {
            installation.program().string(),     "check", "gloam_radical_*", "--inputs", "65536", "--json",
            installation.file("a.json").string()};
    }

    WorkerProcess check_;
    pid_t worker_ = 0;
};

TEST(CheckWorker, AShaderThatLoopsForEverIsOneRow) {
    const Installation installation;
    installation.make_radical_inverse_base2_hang();
    const fs::path file = installation.file("a.json");
    const fs::path failures = installation.file("failures");
    const CommandResult result = installation.gloam(
        "check gloam_radical_* --inputs 65536 --timeout 1.5 --json {} --failures {}", file, failures);
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err, "");
    EXPECT_THAT(result.out, HasSubstr("2 checks, 1 failed"));
    const auto rows = rows_by_equation(json::parse(read_file(file)));
    EXPECT_EQ(rows.at(hanging).at("reason"), "hang");
    EXPECT_THAT(rows.at(hanging).at("error").get<std::string>(), HasSubstr("1.5 s"));
    EXPECT_EQ(rows.at("HALTON").at("reason"), "");
    EXPECT_EQ(rows.at("HALTON").at("inputs"), 65536);
    // It is handed over without running it again. The worker's processor time and its wait for the device are
    // limited alike: either may end first.
    std::map<std::string, std::string> texts;
    for (const auto& entry : fs::recursive_directory_iterator(failures))
        if (entry.is_regular_file()) texts[entry.path().filename().string()] = read_file(entry.path());
    EXPECT_THAT(texts["report.txt"],
                AnyOf(HasSubstr("hang: not finished after 1.5 s"), HasSubstr("submission within 1.5 s")));
    EXPECT_THAT(texts["repro.amber"], HasSubstr("not judged"));
    EXPECT_THAT(texts["shader.comp"], HasSubstr("spin"));
}

TEST(CheckWorker, AWorkerKilledFromOutsideIsOneRow) {
    const Installation installation;
    HangingCheck hanging_check(installation);
    ASSERT_EQ(kill(hanging_check.worker(), SIGKILL), 0);
    std::string line;
    while (hanging_check.check().receive(line, WorkerProcess::Clock::now() + 60s) ==
           WorkerProcess::Heard::line) {
    }
    EXPECT_EQ(hanging_check.check().end(), "ended with status 1");
    const auto rows = rows_by_equation(json::parse(read_file(installation.file("a.json"))));
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows.at(hanging).at("reason"), "crash");
    EXPECT_THAT(rows.at(hanging).at("error").get<std::string>(), HasSubstr("signal 9 (KILL: Killed)"));
    EXPECT_EQ(rows.at("HALTON").at("reason"), "");
    EXPECT_EQ(rows.at("HALTON").at("outside"), 0);
}

TEST(CheckWorker, AnInterruptEndsTheWorkersToo) {
    for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
        const Installation installation;
        HangingCheck hanging_check(installation);
        ASSERT_EQ(kill(hanging_check.check().id(), signal), 0);
        EXPECT_TRUE(ends_soon(hanging_check.worker())) << signal;
        EXPECT_THAT(hanging_check.check().end(), HasSubstr("signal " + std::to_string(signal)));
        EXPECT_FALSE(fs::exists(installation.file("a.json")));
    }
}

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

}  // namespace gloam::test::check_worker_test
