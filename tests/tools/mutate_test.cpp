// SPDX-License-Identifier: MIT
// `gloam mutate FILE... -- COMMAND`.
#include <sys/stat.h>

#include "tools/gloam.hpp"

namespace gloam::test::mutate_test {

class Mutate : public InFolder {
  protected:
    // A curve, and a part of it that no test asks for.
    std::string tone() {
        return write("shaders/tone.glsl",
                     "// x in [0, 4]\n"
                     "float tone(float x) { return x / (1.0 + x); }\n"
                     "// x in [0, 4]\n"
                     "float unused(float x) { return x > 9.0 ? 0.5 * x : max(x, 0.0) + max(-8.0, -9.0); }\n")
            .string();
    }

    // A test that passes if the function has the value at 1 and at 3, read by gloam itself from where it is.
    // It looks at the text first, for it runs often.
    std::string test() {
        const std::string file = tone();
        const std::string explain = std::string(GLOAM_BUILT_BINARY) + " explain " + file + " tone ";
        return script("test.sh", "grep -q 'x / (1.0 + x)' $GLOAM_SHADERS/$GLOAM_SHADERS_CHANGED && exit 0\n" +
                                     explain + "1 | grep -q ' 0.5 ' || exit 1\n" + explain +
                                     "3 | grep -q ' 0.75 ' || exit 1\n");
    }

    std::string script(const std::string& name, const std::string& text) {
        const fs::path file = write(name, "#!/bin/sh\n" + text);
        fs::permissions(file, fs::perms::owner_all);
        return file.string();
    }

    static std::vector<std::string> lines_of(const CommandResult& result) {
        std::vector<std::string> lines;
        std::istringstream text(result.out);
        for (std::string line; std::getline(text, line);) lines.push_back(line);
        return lines;
    }
};

// In a folder with links that lead round and nowhere.
TEST_F(Mutate, AGoodTestKillsAndWhatItMissesSurvives) {
    const std::string file = path("faults.json").string();
    const fs::path folder = fs::path(tone()).parent_path();
    fs::create_symlink("a", folder / "b");
    fs::create_symlink("b", folder / "a");
    fs::create_symlink("nowhere", folder / "dangling.glsl");
    fs::create_directory(folder / "sub");
    fs::create_symlink("..", folder / "sub" / "up");
    ASSERT_EQ(::mkfifo((folder / "fifo.glsl").c_str(), 0600), 0);
    const CommandResult result = gloam("mutate {} --json {} -- {}", folder, file, test());
    EXPECT_EQ(result.status, 1) << result.err;
    std::map<std::string, int> fates;
    const json all = json::parse(read_file(file));
    for (const auto& one : all.at("mutants")) {
        const std::string fate = one.at("fate");
        ++fates[one.at("function").get<std::string>() + " " + fate];
        if (one.at("function") == "tone") {
            EXPECT_EQ(fate, "killed") << one;
        }
        if (one.at("before") == "x > 9.0" && one.at("after") == "true") {
            EXPECT_EQ(one.at("difference"), "differs");
            EXPECT_EQ(one.at("input"), "x = 0");
            EXPECT_EQ(one.at("result"), "-8");
            EXPECT_EQ(one.at("result_with_fault"), "0");
        }
        if (one.at("before") == "x > 9.0" && one.at("after") == "false") {
            EXPECT_EQ(one.at("difference"), "same on every input tried");
        }
    }
    EXPECT_EQ(fates["tone killed"], 4);
    EXPECT_EQ(fates["tone survived"], 0);
    EXPECT_GT(fates["unused survived"], 5);
    EXPECT_THAT(
        result.out,
        HasSubstr("tone.glsl:4: 'x > 9.0' -> 'true' in unused: differs\n  unused(x = 0): -8 becomes 0\n"));
}

TEST_F(Mutate, DrawsTheSameFaultsOfASeed) {
    const std::string file = tone();
    const std::string count = path("count").string();
    const std::string command = script("command.sh", "echo >> " + count + "\n");
    const auto run = [&](const std::string& options) {
        fs::remove(count);
        const CommandResult result = gloam("mutate {} --jobs 1" + options + " -- {}", file, command);
        return std::pair(result, fs::exists(count) ? line_count(read_file(count)) : 0);
    };
    const auto [few, tried_few] = run(" --count 3");
    EXPECT_EQ(tried_few, 1 + 3) << "without a fault, and with three" << few.err;
    EXPECT_EQ(run(" --count 3").first.out, few.out);
    EXPECT_THAT(run(" --minutes 0").first.out, HasSubstr("untried"));
}

TEST_F(Mutate, CountsWhatTakesTooLongApartAndLeavesNothingBehind) {
    const std::string file = tone();
    const std::string command = script(
        "command.sh", "grep -q '1.0 + x' $GLOAM_SHADERS/$GLOAM_SHADERS_CHANGED || sleep 1000 & wait $!\n");
    fs::create_directory(path("temporary"));
    const CommandResult result = run_command(words("mutate {} --count 40 --jobs 2 -- {}", file, command),
                                             {.environment = {"TMPDIR=" + path("temporary").string()}});
    EXPECT_TRUE(fs::is_empty(path("temporary")));
    EXPECT_THAT(result.out, HasSubstr("tone.glsl"));
    const std::vector<std::string> lines = lines_of(result);
    ASSERT_GT(lines.size(), 1U) << result.err;
    std::istringstream row(lines[1]);
    std::string name;
    int untried = 0, invalid = 0, same = 0, known = 0, killed = 0, too_long = 0;
    row >> name >> untried >> invalid >> same >> known >> killed >> too_long;
    EXPECT_EQ(untried, 0);
    EXPECT_EQ(killed, 0);
    EXPECT_EQ(too_long, 2) << "the sum and its first summand";
    EXPECT_THAT(read_file(file), HasSubstr("x / (1.0 + x)")) << "the file itself is as it was";
}

}  // namespace gloam::test::mutate_test
