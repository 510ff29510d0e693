// SPDX-License-Identifier: MIT
// Hostile shaders: `check`, `explain` and `pack` refuse each with one line on standard error and status 2.
#include <sys/stat.h>

#include <fstream>

#include "tools/expect.hpp"
#include "tools/installation.hpp"

namespace gloam::test {
namespace hostile_shaders_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class HostileShaders : public testing::Test {
  protected:
    [[nodiscard]] fs::path write(const std::string& name, const std::string& text) const {
        fs::create_directories((folder() / name).parent_path());
        std::ofstream(folder() / name, std::ios::binary) << text;
        return folder() / name;
    }
    [[nodiscard]] const fs::path& folder() const { return scratch_.path(); }

    static void expect_refused(const fs::path& file, const std::string& why) {
        for (const std::vector<std::string>& command : {std::vector<std::string>{"check", file.string()},
                                                        {"explain", file.string(), "f", "1"},
                                                        {"pack", file.string()},
                                                        {"pack", file.string(), "--target", "wgsl"}}) {
            const CommandResult result = run_command(command);
            expect_could_not_run(result, file.filename().string());
            EXPECT_THAT(result.err, AllOf(HasSubstr(why), Not(HasSubstr("\x1b")))) << command.front();
        }
    }

  private:
    TemporaryDirectory scratch_;
};

std::string repeated(const std::string& text, std::size_t count) {
    std::string all;
    for (std::size_t i = 0; i < count; ++i) all += text;
    return all;
}

TEST_F(HostileShaders, DeepExpressions) {
    const fs::path file =
        write("terms.glsl", "float f(float x) { return " + repeated("x-", 40'000) + "x; }\n");
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"check", file.string()}, {"explain", file.string(), "f", "1"}})
        expect_could_not_run(run_command(command), "terms.glsl: the compiler ended by signal 11");
}

TEST_F(HostileShaders, MacrosThatDouble) {
    std::string macros = "#define M0 x\n";
    for (int i = 1; i <= 40; ++i)
        macros +=
            "#define M" + std::to_string(i) + repeated(" M" + std::to_string(i - 1) + " +", 2) + " 0.0\n";
    const fs::path file = write("macros.glsl", macros + "float f(float x) { return M40; }\n");
    const CommandResult result = run_command({"check", file.string()});
    expect_could_not_run(result, "macros.glsl: the compiler takes more than");
}

TEST_F(HostileShaders, IncludesFromElsewhere) {
    (void)write("secret.glsl", "float secret;\n");
    (void)write("library/math/twice.glsl", "float twice(float x) { return x + x; }\n");
    const std::string use = "float f(float x) { return twice(x); }\n";
    const fs::path outside = write("library/color/a.glsl", "#include \"../../secret.glsl\"\n" + use);
    const std::string why = "a.glsl:1: include \"../../secret.glsl\" is outside the include roots";
    expect_refused(outside, why);
    const fs::path beside = write("library/color/b.glsl", "#include \"../math/twice.glsl\"\n" + use);
    expect_refused(beside, "b.glsl:1: include \"../math/twice.glsl\" is outside the include roots");
    const std::string root = (folder() / "library").string();
    const CommandResult checked =
        run_command({"check", "--include", root, beside.string(), "--inputs", "64"});
    expect_success(checked);
    EXPECT_THAT(checked.out, HasSubstr("1 checks, 0 failed"));
    expect_success(run_command({"explain", "--include", root, beside.string(), "f", "1"}));
    expect_success(run_command({"pack", "--include", root, beside.string()}));
    expect_could_not_run(run_command({"check", "--include", root, outside.string()}), "include roots");
    expect_could_not_run(run_command({"check", "--include", root, "REMAP"}), "--include");
    expect_could_not_run(run_command({"check", "--include", root + "/none", beside.string()}), "none");
}

// A #line directive can name any file as the place of a line; gloam does not follow it.
TEST_F(HostileShaders, CoverageDoesNotQuoteOtherFiles) {
    const fs::path secret = write("secret.txt", "password\n");
    const fs::path file = write("own/a.glsl", "float f(float x) {\n#line 1 \"" + secret.string() +
                                                  "\"\nif (x > 1e30 && x < 0.0) return 1.0;\nreturn x;\n}\n");
    const std::string json = (folder() / "a.json").string();
    const CommandResult result =
        run_command({"check", file.string(), "--inputs", "64", "--coverage", "--json", json});
    EXPECT_THAT(result.out + read_file(json), AllOf(HasSubstr("a.glsl"), Not(HasSubstr("password"))));
}

TEST_F(HostileShaders, FilesThatAreNoText) {
    expect_refused(write("utf16.glsl", std::string("\xff\xfe"
                                                   "f\0",
                                                   4)),
                   "NUL");
    fs::create_directory(folder() / "folder.glsl");
    expect_refused(folder() / "folder.glsl", "is a folder");
    const fs::path fifo = folder() / "fifo.glsl";
    ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
    expect_refused(fifo, "is no regular file");
    expect_refused(write("long.glsl", std::string((64U << 20U) + 1, ' ')), "longer than");
}

TEST_F(HostileShaders, ControlCharactersDoNotReachTheTerminal) {
    const std::string red = "\x1b[31mred";
    expect_refused(write("token.glsl", "float f(float x) { return " + red + "; }\n"), "");
    expect_refused(write("error.glsl", "#error " + red + "\n"), "");
    expect_refused(write("include.glsl", "#include \"" + red + "\"\n"), "[31mred");
    const fs::path named = write("line\n" + red + ".glsl", "float f(float x) { return x@; }\n");
    for (const char* command : {"check", "pack"}) {
        const CommandResult result = run_command({command, named.string()});
        expect_could_not_run(result, "[31mred.glsl");
        EXPECT_THAT(result.out + result.err, Not(HasSubstr("\x1b")));
    }
}

}  // namespace hostile_shaders_test
}  // namespace gloam::test
