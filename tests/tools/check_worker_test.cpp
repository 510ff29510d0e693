// SPDX-License-Identifier: MIT
// What a driver does to a worker of `gloam check` costs one check.
#include <csignal>

#include "base/process.hpp"
#include "cli/framework/check/worker_session.hpp"
#include "support/run_command.hpp"
#include "tools/gloam.hpp"

namespace gloam::test::check_worker_test {

using base::WorkerProcess;
using check::Reason;
using cli::NoWorker;
using cli::Reply;
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
    const CommandResult result =
        installation.gloam("check gloam_radical_* --inputs 65536 --timeout 1.5 --json {}", file);
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err, "");
    EXPECT_THAT(result.out, HasSubstr("2 checks, 1 failed"));
    const auto rows = rows_by_equation(json::parse(read_file(file)));
    EXPECT_EQ(rows.at(hanging).at("reason"), "hang");
    EXPECT_THAT(rows.at(hanging).at("error").get<std::string>(), HasSubstr("1.5 s"));
    EXPECT_EQ(rows.at("HALTON").at("reason"), "");
    EXPECT_EQ(rows.at("HALTON").at("inputs"), 65536);
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

// Whatever ends the processes: another program removes what they put beside.
TEST(CheckWorker, AnInterruptLeavesNoFolder) {
    const TemporaryDirectory place;
    const auto waits_until = [&](bool empty) {
        for (int i = 0; i < 6000 && fs::is_empty(place.path()) != empty; ++i)
            std::this_thread::sleep_for(10ms);
        return fs::is_empty(place.path()) == empty;
    };
    for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
        WorkerProcess check({"env", "TMPDIR=" + place.path().string(), GLOAM_BUILT_BINARY, "check", "HALTON",
                             "--inputs", "64", "--compiler", "tail -f {in} {out}"});
        EXPECT_TRUE(waits_until(false)) << signal;
        ASSERT_EQ(kill(check.id(), signal), 0);
        EXPECT_TRUE(waits_until(true)) << signal;
    }
}

TEST(CheckWorker, SeveralWorkersGiveTheRowsOfOne) {
    const auto output = [](std::vector<std::string> how) {
        how.insert(how.begin(), {"check", "HALTON*", "TSSAO-*", "--inputs", "256"});
        const CommandResult result = run_command(how);
        expect_success(result);
        return result.out;
    };
    const std::string one = output({});
    EXPECT_THAT(one, HasSubstr("TSSAO-5 "));
    EXPECT_EQ(output({"--jobs", "3"}), one);
    EXPECT_EQ(output({"--in-process"}), one);
}

TEST(CheckWorker, ADriverThatCrashesWhenOpenedIsOneRow) {
    const TemporaryDirectory folder;
    const CommandOptions crashing =
        with_driver_alone(folder.write("driver.json", manifest_of(GLOAM_CRASHING_DRIVER)));
    const CommandResult result =
        run_command(words("check gloam_radical_* --json {}", folder.path() / "a.json"), crashing);
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err, "");
    EXPECT_THAT(result.out, HasSubstr("1 checks, 1 failed"));
    const json report = json::parse(read_file(folder.path() / "a.json"));
    ASSERT_EQ(report.at("results").size(), 1U);
    const json& row = report.at("results").front();
    EXPECT_EQ(row.at("equation"), "device");
    EXPECT_EQ(row.at("reason"), "crash");
    EXPECT_THAT(row.at("error").get<std::string>(), HasSubstr("2 checks were not run"));
    EXPECT_THAT(row.at("error").get<std::string>(), HasSubstr("ABRT"));
    expect_could_not_run(run_command(words("check gloam_radical_* --device all"), crashing), "ABRT");
}

TEST(CheckWorker, HelpDoesNotNameIt) {
    EXPECT_THAT(gloam("--help").out, Not(HasSubstr("worker")));
}

std::vector<std::string> shell(const std::string& script) {
    return {"/bin/sh", "-c", script};
}

// Greets, then executes the commands that it receives.
const std::vector<std::string> obedient = shell("echo hello; while read -r line; do eval \"$line\"; done");

TEST(WorkerSession, ACrashOrADismissalCostsOneQuestion) {
    WorkerSession session(obedient, 20s);
    EXPECT_EQ(session.greeting(), "hello");
    const std::string first = session.ask("echo $$").line;
    EXPECT_EQ(session.ask("echo $$").line, first) << "one worker answers many questions";
    const Reply crashed = session.ask("echo oh no >&2; kill -ABRT $$");
    EXPECT_EQ(crashed.reason, Reason::crash);
    EXPECT_EQ(crashed.error, "the process ended by signal 6 (ABRT: Aborted): oh no");
    const Reply next = session.ask("echo $$");
    EXPECT_EQ(next.reason, Reason::none);
    EXPECT_EQ(next.error, "");
    EXPECT_NE(next.line, first);
    session.dismiss();
    EXPECT_NE(session.ask("echo $$").line, next.line);
    const Reply exited = session.ask("exit 0");
    EXPECT_EQ(exited.reason, Reason::crash);
    EXPECT_THAT(exited.error, HasSubstr("ended with status 0"));
}

TEST(WorkerSession, SilenceIsAHangAndCostsOneQuestion) {
    WorkerSession session(obedient, 300ms);
    const auto start = std::chrono::steady_clock::now();
    const Reply hung = session.ask("exec sleep 1000");
    EXPECT_EQ(hung.reason, Reason::hang);
    EXPECT_EQ(hung.error, "not finished after 0.3 s, the time limit");
    EXPECT_LT(std::chrono::steady_clock::now() - start, 10s);
    EXPECT_EQ(session.ask("echo alive").line, "alive");
    WorkerSession silent(shell("exec sleep 1000"), 100ms);  // a greeting may take as long as an answer
    EXPECT_THAT([&] { (void)silent.greeting(); },
                testing::Throws<NoWorker>(testing::Field(&NoWorker::reason, Reason::hang)));
}

TEST(WorkerSession, AWorkerThatNeverGreetsIsTriedTwiceAndNoMore) {
    const test::TemporaryDirectory folder;
    const std::string log = (folder.path() / "log").string();
    WorkerSession session(shell("echo start >> " + log + "; echo no driver >&2; kill -9 $$"), 20s);
    EXPECT_THAT([&] { (void)session.ask("echo"); },
                ThrowsMessage<NoWorker>("the process ended by signal 9 (KILL: Killed): no driver"));
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

}  // namespace gloam::test::check_worker_test
