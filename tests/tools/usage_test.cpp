// SPDX-License-Identifier: MIT
#include "tools/gloam.hpp"

namespace gloam::test::usage_test {

class List : public InFolder {};

TEST_F(List, ANameAndItsMeaningALine) {
    for (const char* kind : {"equations", "methods", "presets", "scenes", "settings", "variants", "views"}) {
        std::istringstream lines(output_of(gloam("list {}", kind)));
        std::vector<std::string> names;
        for (std::string line; std::getline(lines, line);) {
            names.push_back(line.substr(0, line.find(' ')));
            EXPECT_THAT(line.substr(names.back().size()), testing::ContainsRegex("^ +[^ ]+ [^ ]")) << line;
        }
        EXPECT_FALSE(names.empty()) << kind;

        const auto json = json::parse(gloam("list {} --json", kind).out).at(kind);
        ASSERT_EQ(json.size(), names.size()) << kind;
        EXPECT_EQ(json[0].contains("time"), std::string(kind) == "presets") << kind;
        for (std::size_t i = 0; i < names.size(); ++i) {
            EXPECT_EQ(json[i].at("name"), names[i]);
            EXPECT_NE(json[i].at("description"), "") << names[i];
            EXPECT_THAT(names[i], Not(HasSubstr(" ")));
        }
    }
}

// What is printed of a preset makes the same: as text by --method and --set, as JSON by --preset.
TEST_F(List, APresetSaysWhatItSets) {
    const std::string result = output_of(gloam("list presets balanced"));
    EXPECT_THAT(result, StartsWith("name: balanced\ndescription: "));
    const CommandResult as_json = gloam("list presets balanced --json");
    EXPECT_EQ(json::parse(as_json.out).at("settings").at("method"), "sweep");
    const std::string file = write("same.json", as_json.out).string();
    std::vector<std::string> by_settings;
    std::istringstream lines(result);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("  method="))
            by_settings.insert(by_settings.end(), {"--method", line.substr(9, line.find(' ', 9) - 9)});
        else if (line.starts_with("  ") && !line.starts_with("  radius="))
            by_settings.insert(by_settings.end(), {"--set", line.substr(2, line.find(' ', 2) - 2)});
    const auto used = [&](const std::vector<std::string>& options) {
        std::vector<std::string> all = words("render corner --radius 1 --size 16x9 --out {}", path("out"));
        all.insert(all.end(), options.begin(), options.end());
        expect_success(run_command(all));
        return json::parse(read_file(path("out") / "render.json")).at("settings");
    };
    const auto expected = used(words("--preset balanced"));
    EXPECT_NE(used(words("--preset tssao-paper")), expected);
    by_settings.insert(by_settings.end(), {"--preset", "tssao-paper"});
    EXPECT_EQ(used(by_settings), expected);
    EXPECT_EQ(used(words("--preset {}", file)), expected);
}

}  // namespace gloam::test::usage_test
