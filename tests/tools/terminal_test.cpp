// SPDX-License-Identifier: MIT
// What people see on a terminal: colour, examples, and nothing where they want quiet.
#include <fcntl.h>
#include <unistd.h>

#include "support/full_disk.hpp"
#include "tools/gloam.hpp"

namespace gloam::test::terminal_test {

constexpr const char* quick_check = "check gloam_radical_inverse_base2 --inputs 64";

// Whether this machine gives a program a pseudo-terminal. A container without /dev/pts does not.
bool has_pseudo_terminals() {
    const int controller = posix_openpt(O_RDWR | O_NOCTTY);
    if (controller < 0) return false;
    const bool opens = grantpt(controller) == 0 && unlockpt(controller) == 0 &&
                       ptsname(controller) != nullptr && access(ptsname(controller), R_OK | W_OK) == 0;
    close(controller);
    return opens;
}

// util-linux's script gives the command a terminal.
CommandResult on_terminal(const std::string& arguments, std::vector<std::string> environment = {}) {
    environment.emplace_back("TERM=xterm");
    return run_program("/usr/bin/script",
                       words("-qec {} /dev/null", std::string(GLOAM_BUILT_BINARY) + " " + arguments),
                       {.environment = std::move(environment)});
}

class Terminal : public InFolder {};

TEST_F(Terminal, VerdictsHaveColourUnlessItIsNotWanted) {
    if (!fs::exists("/usr/bin/script")) GTEST_SKIP() << "util-linux's script is not installed";
    if (!has_pseudo_terminals()) GTEST_SKIP() << "no pseudo-terminals here: /dev/ptmx or /dev/pts is missing";
    EXPECT_THAT(on_terminal(quick_check).out, HasSubstr("\033[32mok\033[0m"));
    EXPECT_THAT(on_terminal(quick_check, {"NO_COLOR=1"}).out, Not(HasSubstr("\033[32m")));
    EXPECT_THAT(on_terminal(quick_check, {"TERM=dumb"}).out, HasSubstr("ok"));
}

TEST_F(Terminal, TheTableExplainsItsColumnsAndLinesUp) {
    const std::string result = output_of(
        gloam("check gloam_radical_inverse_base2 gloam_normal_from_neighbors_orthographic --inputs 64"));
    EXPECT_THAT(result, HasSubstr("of allowed: "));
    EXPECT_THAT(result, HasSubstr("judged by: "));
    std::vector<std::size_t> columns;
    std::istringstream lines(result);
    for (std::string line; std::getline(lines, line);) {
        for (const char* word : {"verdict", "ok"}) {
            if (line.ends_with(std::string(" ") + word)) columns.push_back(line.rfind(word));
        }
    }
    ASSERT_EQ(columns.size(), 3U) << result;
    EXPECT_EQ(columns[0], columns[1]);
    EXPECT_EQ(columns[0], columns[2]);
}

// An output that cannot be written is an error, wherever it goes; and no other file replaces a closed stream.

const std::vector<std::string> small_check{"check", "gloam_radical_inverse_base2", "--inputs", "64"};

std::vector<std::string> with_json(std::vector<std::string> command, const fs::path& file) {
    command.insert(command.end(), {"--json", file.string()});
    return command;
}

class Streams : public InFolder {};

TEST_F(Streams, AFullStandardOutputIsAnError) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    const fs::path file = path("a.json");
    expect_success(run_command(with_json(small_check, file)));
    const std::vector<std::vector<std::string>> commands{
        {"list", "presets"},
        {"--help"},
        {"devices"},
        {"devices", "--json"},
        small_check,
        {"report", file.string()},
        {"pack", "gloam/geometry/background.glsl"},
        {"render", "corner", "--size", "16x9", "--samples", "1", "--out", path("out").string()}};
    for (const auto& command : commands) {
        const CommandResult result = run_command(command, {.standard_output = "/dev/full"});
        EXPECT_EQ(result.status, 2) << command.front();
        EXPECT_EQ(line_count(result.err), 1) << result.err;
        EXPECT_THAT(result.err, HasSubstr("standard output")) << command.front();
    }
}

TEST_F(Streams, ClosedStreamsFailNoCheck) {
    const fs::path file = path("a.json");
    const CommandResult result = run_command(with_json(small_check, file), {.closed_streams = true});
    EXPECT_EQ(result.status, 2);  // its table went nowhere
    EXPECT_THAT(result.err, HasSubstr("standard output"));
    const auto report = json::parse(read_file(file));
    EXPECT_EQ(report.at("results").at(0).at("error"), "");
    EXPECT_EQ(report.at("results").at(0).at("outside"), 0);
}

TEST_F(Streams, AFileThatMayNotGrowIsNamed) {
    const fs::path file = path("a.json");
    CommandResult result;
    {
        const FullDisk disk(100);  // of the program, too
        rlimit limit{};
        getrlimit(RLIMIT_FSIZE, &limit);
        result = run_command(words("list equations --json"), {.standard_output = "/dev/null"});
        EXPECT_EQ(result.status, 0) << result.err;
        result = run_command(words("pack gloam/geometry/background.glsl --out {}", file),
                             {.standard_output = "/dev/null"});
    }
    EXPECT_EQ(result.status, 2);
    EXPECT_FALSE(fs::exists(file));
    EXPECT_TRUE(fs::is_empty(path("")));
}

}  // namespace gloam::test::terminal_test
