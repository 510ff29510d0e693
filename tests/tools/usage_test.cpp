// SPDX-License-Identifier: MIT
#include "base/version.hpp"
#include "tools/gloam.hpp"

namespace gloam::test::usage_test {

class Usage : public InFolder {};

TEST(Devices, AreListedWithTheirFloatControls) {
    const std::string text = output_of(gloam("devices"));
    EXPECT_THAT(text, StartsWith("0: "));
    EXPECT_THAT(text, HasSubstr("subnormals"));

    const auto devices = json::parse(output_of(gloam("devices --json"))).at("devices");
    ASSERT_GE(devices.size(), 2U);
    // Those of Vulkan have a number and float controls; then those of OpenGL, and the interpreter as the
    // last.
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const std::string type = devices[i].at("type");
        const bool is_interpreter = i + 1 == devices.size();
        const bool is_opengl = type == "opengl" || type == "opengl es";
        EXPECT_EQ(devices[i].at("index"), is_interpreter || is_opengl ? json() : json(i));
        EXPECT_EQ(devices[i].at("name") == "interpreter", is_interpreter);
        EXPECT_NE(devices[i].at("name"), "");
        EXPECT_EQ(devices[i].contains("float32"), !is_opengl);
        if (!is_opengl) {
            EXPECT_TRUE(devices[i].at("float32").at("denorm_preserve").is_boolean());
        }
    }
}

const CommandOptions none = with_driver_alone("/no/such/driver.json");

TEST(Devices, NoneIsOneClearLine) {
    expect_could_not_run(run_command(words("devices"), none), "Vulkan");
    expect_could_not_run(run_command(words("check gloam_radical_inverse_base2"), none), "Vulkan");
}

TEST(Devices, TheInterpreterNeedsNoDriver) {
    const std::string result =
        output_of(run_command(words("check TSSAO-5 HALTON --inputs 512 --device interpreter"), none));
    EXPECT_THAT(result, StartsWith("device: interpreter"));
    EXPECT_THAT(result, HasSubstr("2 checks, 0 failed"));
    expect_could_not_run(run_command(words("render corner --device interpreter"), none), "Vulkan");
}

class List : public InFolder {};

TEST_F(List, ANameAndItsMeaningALine) {
    for (const char* kind :
         {"equations", "methods", "numbers", "presets", "scenes", "settings", "variants", "views"}) {
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

TEST_F(List, APresetShowsEverySettingThatRunsWithItsSymbol) {
    const std::size_t settings = json::parse(gloam("list settings --json").out).at("settings").size();
    const std::vector<std::pair<const char*, std::vector<const char*>>> rows = {
        {"tssao-paper",
         {"samples=32 +k_1\n", "samples_converged=16 +k_2", "weight_max=500 +w_max", "F, 5 x 5"}},
        {"issao-figure3",
         {"history=off +none in the paper\n", "bias=0.01257.* psi / R\n", "weight_max=500 +ours"}},
        {"sao-code", {"history=off", "samples=11 +s\n", "intensity=0.3 +ours"}},
        {"study-volumetric-performance", {"samples=12 +ours", "history=off"}},
        {"balanced", {"samples=32 +k_1\n", "history=on", "passes=frame"}}};
    for (const auto& [preset, lines] : rows) {
        const std::string text = output_of(gloam("list presets {}", preset));
        for (const char* line : lines) EXPECT_THAT(text, testing::ContainsRegex(line)) << preset;
        const auto as_json = json::parse(gloam("list presets {} --json", preset).out);
        EXPECT_LT(as_json.at("settings").size(), settings) << preset;
        EXPECT_EQ(as_json.at("origins").size(), as_json.at("settings").size()) << preset;
    }
}

TEST_F(List, EquationsSayAllThatIsKnownOfThem) {
    const auto equations = json::parse(gloam("list equations --json").out).at("equations");
    for (const auto& equation : equations) {
        for (const char* member : {"name", "description", "function", "file", "formula", "error", "source"})
            EXPECT_NE(equation.at(member), "") << equation;
    }
}

TEST_F(List, EquationsAsAPage) {
    const std::string file = path("equations.html").string();
    expect_success(gloam("list equations --html {}", file));
    const std::string page = read_file(file);
    std::istringstream names(gloam("list equations").out);
    for (std::string name, meaning; names >> name && std::getline(names, meaning);)
        ASSERT_THAT(page, HasSubstr("<td>" + name + "</td>")) << name;
}

}  // namespace gloam::test::usage_test
