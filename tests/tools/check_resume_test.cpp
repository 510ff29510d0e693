// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "tools/expect.hpp"
#include "tools/installation.hpp"

namespace gloam::test {
namespace check_resume_test {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

class CheckResume : public testing::Test {
  protected:
    [[nodiscard]] std::vector<std::string> command(std::vector<std::string> more = {}) const {
        std::vector<std::string> words{"check", "TSSAO-*", "--inputs", "64", "--json", results().string()};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }

    [[nodiscard]] fs::path results() const { return folder_.path() / "results.json"; }
    [[nodiscard]] fs::path journal() const { return folder_.path() / "results.json.journal"; }

    // The lines that stand in the journal whole.
    [[nodiscard]] std::vector<std::string> kept() const {
        std::ifstream stream(journal());
        std::vector<std::string> lines;
        for (std::string line; std::getline(stream, line) && !stream.eof();) lines.push_back(line);
        return lines;
    }

    // Runs the check until some results stand in the journal, and kills it then.
    void run_and_kill() {
        std::vector<std::string> words = command();
        words.insert(words.begin(), GLOAM_BUILT_BINARY);
        std::vector<char*> arguments;
        for (std::string& word : words) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        const pid_t child = fork();
        if (child == 0) {
            dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
            execv(arguments[0], arguments.data());
            _exit(127);
        }
        constexpr std::size_t enough = 4;  // the heading and three results
        const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (kept().size() < enough && std::chrono::steady_clock::now() < deadline)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        kill(child, SIGKILL);
        int status = 0;
        ASSERT_EQ(waitpid(child, &status, 0), child);
        ASSERT_TRUE(WIFSIGNALED(status)) << "it ended before it was killed";
        ASSERT_GE(kept().size(), enough);
    }

  private:
    TemporaryDirectory folder_;
};

TEST_F(CheckResume, AKilledRunLeavesItsResultsAndTheNextGoesOnFromThere) {
    run_and_kill();
    EXPECT_FALSE(fs::exists(results()));
    std::map<std::string, double> seconds;
    const std::vector<std::string> lines = kept();
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const json row = json::parse(json::parse(lines[i]).at("row").get<std::string>());
        seconds[row.at("equation")] = row.at("seconds");
    }
    std::ofstream(journal(), std::ios::app) << R"({"device": "cut of)";  // as a kill may leave it

    const CommandResult resumed = run_command(command({"--resume"}));
    expect_success(resumed);
    EXPECT_FALSE(fs::exists(journal()));
    const json rows = json::parse(read_file(results())).at("results");
    EXPECT_GT(rows.size(), seconds.size());
    for (const auto& [equation, time] : seconds) {
        const auto row = std::find_if(rows.begin(), rows.end(),
                                      [&name = equation](const json& r) { return r.at("equation") == name; });
        ASSERT_NE(row, rows.end()) << equation;
        EXPECT_EQ(row->at("seconds"), time) << equation << " was run again";
        EXPECT_THAT(resumed.out, HasSubstr(equation));
    }
}

TEST_F(CheckResume, WithoutTheOptionARunBeginsAnew) {
    std::ofstream(journal()) << "of another run\n";
    expect_success(run_command(
        {"check", "gloam_radical_inverse_base2", "--inputs", "64", "--json", results().string()}));
    EXPECT_FALSE(fs::exists(journal()));
}

TEST_F(CheckResume, ResultsOfOtherInputsAreNotTakenOver) {
    run_and_kill();
    const CommandResult other = run_command(command({"--resume", "--seed", "2"}));
    expect_could_not_run(other, journal().string());
    EXPECT_THAT(other.err, HasSubstr("\"seed\":2"));
}

TEST_F(CheckResume, ALineThatIsNoResultIsNamed) {
    run_and_kill();
    std::ofstream(journal(), std::ios::app) << "\n{}\n";
    expect_could_not_run(run_command(command({"--resume"})), journal().string() + ", line ");
}

TEST_F(CheckResume, NeedsAFileOfResults) {
    expect_could_not_run(run_command({"check", "--resume"}), "--json");
}

}  // namespace check_resume_test
}  // namespace gloam::test
