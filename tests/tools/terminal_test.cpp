// SPDX-License-Identifier: MIT
// What people see on a terminal: colour, completion, examples, and nothing where they want quiet.
#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "tools/expect.hpp"

namespace gloam::test {
namespace terminal_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

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
                       {"-qec", std::string(GLOAM_BUILT_BINARY) + " " + arguments, "/dev/null"},
                       {.environment = std::move(environment)});
}

TEST(Terminal, VerdictsHaveColourUnlessItIsNotWanted) {
    if (!fs::exists("/usr/bin/script")) GTEST_SKIP() << "util-linux's script is not installed";
    if (!has_pseudo_terminals()) GTEST_SKIP() << "no pseudo-terminals here: /dev/ptmx or /dev/pts is missing";
    EXPECT_THAT(on_terminal(quick_check).out, HasSubstr("\033[32mok\033[0m"));
    EXPECT_THAT(on_terminal(quick_check, {"NO_COLOR=1"}).out, Not(HasSubstr("\033[32m")));
    EXPECT_THAT(on_terminal(quick_check, {"TERM=dumb"}).out, HasSubstr("ok"));
}

TEST(Terminal, TheTableExplainsItsColumnsAndLinesUp) {
    const CommandResult result = run_command({"check", "gloam_radical_inverse_base2",
                                              "gloam_normal_from_neighbors_orthographic", "--inputs", "64"});
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr("of allowed: "));
    EXPECT_THAT(result.out, HasSubstr("judged by: "));
    std::vector<std::size_t> columns;
    std::istringstream lines(result.out);
    for (std::string line; std::getline(lines, line);) {
        for (const char* word : {"verdict", "ok"}) {
            if (line.ends_with(std::string(" ") + word)) columns.push_back(line.rfind(word));
        }
    }
    ASSERT_EQ(columns.size(), 3U) << result.out;
    EXPECT_EQ(columns[0], columns[1]);
    EXPECT_EQ(columns[0], columns[2]);
}

TEST(Terminal, QuietLeavesTheCountAlone) {
    const CommandResult check =
        run_command({"check", "gloam_radical_inverse_base2", "--inputs", "64", "--quiet"});
    expect_success(check);
    EXPECT_EQ(check.out, "1 checks, 0 failed\n");
    const TemporaryDirectory folder;
    const CommandResult render = run_command({"render", "corner", "--size", "16x9", "--samples", "1",
                                              "--quiet", "--out", (folder.path() / "out").string()});
    expect_success(render);
    EXPECT_EQ(render.out, "");
}

TEST(Terminal, HelpHasExamples) {
    for (const char* command : {"demo", "devices", "list", "check", "report", "render", "bench", "pack"}) {
        const CommandResult help = run_command({command, "--help"});
        EXPECT_THAT(help.out, HasSubstr(std::string("Examples:\n  gloam ") + command)) << command;
    }
    EXPECT_THAT(run_command({"--help"}).out, HasSubstr("Examples:\n  gloam demo"));
}

// What bash offers for the last word of a command line.
std::string completions(const std::string& words) {
    const std::string script =
        "source <(\"$0\" completion bash)\n"
        "COMP_WORDS=(" +
        words +
        ")\n"
        "COMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n"
        "_gloam\nprintf '%s\\n' \"${COMPREPLY[@]}\"";
    const CommandResult result = run_program("/bin/bash", {"--norc", "-c", script, GLOAM_BUILT_BINARY});
    EXPECT_EQ(result.err, "") << words;
    return result.out;
}

TEST(Completion, KnowsCommandsOptionsAndNames) {
    EXPECT_EQ(completions("gloam ren"), "render\n");
    EXPECT_THAT(completions("gloam ''"), HasSubstr("demo\n"));
    EXPECT_THAT(completions("gloam ''"), Not(HasSubstr("worker")));  // hidden
    EXPECT_EQ(completions("gloam check --val"), "--validation\n");
    EXPECT_EQ(completions("gloam render --method gta"), "gtao\n");
    EXPECT_EQ(completions("gloam check --variant stri"), "strict\n");
    EXPECT_EQ(completions("gloam render col"), "columns\n");
    EXPECT_EQ(completions("gloam bench temp"), "temporal\n");
    EXPECT_EQ(completions("gloam --vers"), "--version\n");
}

TEST(Completion, OtherShellsAreNamed) {
    expect_could_not_run(run_command({"completion", "powershell"}), "powershell");
    expect_could_not_run(run_command({"completion"}), "shell");
}

// A browser runs the page's script, which its content security policy names by a hash: it counts the rows.
void expect_script_runs(const std::string& page) {
    constexpr const char* browser = "/usr/bin/chromium";
    if (!fs::exists(browser)) return;  // wanted, not needed: tools/packages-tests.txt
    const TemporaryDirectory home;
    const CommandResult shown =
        run_program(browser, {"--headless", "--no-sandbox", "--disable-gpu", "--dump-dom", "file://" + page},
                    {.environment = {"HOME=" + home.path().string()}});
    EXPECT_THAT(shown.out, HasSubstr("1 of 1 rows</output>"));
}

TEST(Terminal, CheckAndReportWriteAPage) {
    const TemporaryDirectory folder;
    const auto path = [&](const char* name) { return (folder.path() / name).string(); };
    const auto read = [](const std::string& file) {
        std::ifstream stream(file);
        return std::string(std::istreambuf_iterator<char>(stream), {});
    };
    expect_success(run_command({"check", "gloam_radical_inverse_base2", "--inputs", "64", "--json",
                                path("a.json"), "--html", path("a.html")}));
    EXPECT_THAT(read(path("a.html")), HasSubstr("1 checks, 0 failed"));
    expect_success(run_command({"report", path("a.json"), "--html", path("b.html")}));
    EXPECT_EQ(read(path("a.html")), read(path("b.html")));
    expect_script_runs(path("a.html"));
    // A device's name from a file of someone else.
    std::string text = read(path("a.json"));
    const std::size_t name = text.find("\"name\": \"") + 9;
    text.insert(name, "</script><b>");
    std::ofstream(path("a.json")) << text;
    expect_success(run_command({"report", path("a.json"), "--html", path("b.html")}));
    EXPECT_THAT(read(path("b.html")), HasSubstr("&lt;/script&gt;&lt;b&gt;"));
    EXPECT_THAT(read(path("b.html")), Not(HasSubstr("</script><b>")));
    expect_could_not_run(run_command({"report", path("a.json"), "--html", "/no/such/folder/a.html"}),
                         "/no/such/folder/a.html");
}

}  // namespace terminal_test
}  // namespace gloam::test
