// SPDX-License-Identifier: MIT
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tools/expect.hpp"

namespace gloam::test {
namespace usage_test {

using testing::HasSubstr;

TEST(Usage, HelpNamesEveryCommand) {
    const CommandResult result = run_command({"--help"});
    expect_success(result);
    for (const char* command : {"demo", "devices", "list", "check", "report", "render", "bench", "stress",
                                "pack", "explain", "completion"}) {
        EXPECT_THAT(result.out, HasSubstr(command));
        const CommandResult help = run_command({command, "--help"});
        expect_success(help);
        EXPECT_THAT(help.out, HasSubstr(command));
        EXPECT_THAT(help.out, HasSubstr("Examples:\n  "));
    }
}

TEST(Usage, UnknownOptionIsNamed) {
    expect_could_not_run(run_command({"--no-such-option"}), "--no-such-option");
    for (const char* command : {"demo", "devices", "list", "check", "render", "stress"}) {
        expect_could_not_run(run_command({command, "--no-such-option"}), "--no-such-option");
    }
    expect_could_not_run(run_command({"pack", "gloam/geometry/background.glsl", "--no-such-option"}),
                         "--no-such-option");
}

TEST(Usage, UnknownCommandIsNamed) {
    expect_could_not_run(run_command({"no-such-command"}), "no-such-command");
}

TEST(Usage, ACommandIsNeeded) {
    expect_could_not_run(run_command({}), "subcommand");
}

TEST(Devices, AreListedWithTheirFloatControls) {
    const CommandResult text = run_command({"devices"});
    expect_success(text);
    EXPECT_THAT(text.out, testing::StartsWith("0: "));
    EXPECT_THAT(text.out, HasSubstr("subnormals"));

    const CommandResult result = run_command({"devices", "--json"});
    expect_success(result);
    const auto devices = nlohmann::json::parse(result.out);
    ASSERT_GE(devices.size(), 2U);
    // Those of Vulkan have a number and float controls; then those of OpenGL, and the interpreter as the
    // last.
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const std::string type = devices[i].at("type");
        const bool is_interpreter = i + 1 == devices.size();
        const bool is_opengl = type == "opengl" || type == "opengl es";
        EXPECT_EQ(devices[i].at("index"), is_interpreter || is_opengl ? nlohmann::json() : nlohmann::json(i));
        EXPECT_EQ(devices[i].at("name") == "interpreter", is_interpreter);
        EXPECT_NE(devices[i].at("name"), "");
        EXPECT_EQ(devices[i].contains("float32"), !is_opengl);
        if (!is_opengl) {
            EXPECT_TRUE(devices[i].at("float32").at("denorm_preserve").is_boolean());
        }
    }
}

TEST(Devices, NoneIsOneClearLine) {
    const CommandOptions none{
        .environment = {"VK_ICD_FILENAMES=/no/such/driver.json", "VK_DRIVER_FILES=/no/such/driver.json"}};
    expect_could_not_run(run_command({"devices"}, none), "Vulkan");
    expect_could_not_run(run_command({"check", "gloam_radical_inverse_base2"}, none), "Vulkan");
}

TEST(Devices, TheInterpreterNeedsNoDriver) {
    const CommandOptions none{
        .environment = {"VK_ICD_FILENAMES=/no/such/driver.json", "VK_DRIVER_FILES=/no/such/driver.json"}};
    const CommandResult result =
        run_command({"check", "TSSAO-5", "HALTON", "--inputs", "512", "--device", "interpreter"}, none);
    expect_success(result);
    EXPECT_THAT(result.out, testing::StartsWith("device: interpreter"));
    EXPECT_THAT(result.out, HasSubstr("2 checks, 0 failed"));
    expect_could_not_run(run_command({"render", "corner", "--device", "interpreter"}, none), "Vulkan");
}

TEST(List, NamesOneALine) {
    for (const char* kind : {"equations", "methods", "presets", "scenes", "variants", "views"}) {
        const CommandResult result = run_command({"list", kind});
        expect_success(result);
        std::istringstream lines(result.out);
        std::vector<std::string> names;
        for (std::string name; std::getline(lines, name);) names.push_back(name);
        EXPECT_FALSE(names.empty()) << kind;

        const auto json = nlohmann::json::parse(run_command({"list", kind, "--json"}).out);
        ASSERT_EQ(json.size(), names.size()) << kind;
        for (std::size_t i = 0; i < names.size(); ++i) {
            EXPECT_EQ(json[i].at("name"), names[i]);
            EXPECT_THAT(names[i], testing::Not(HasSubstr(" ")));
        }
    }
}

TEST(List, SettingsWithDefaultAndRange) {
    const CommandResult result = run_command({"list", "settings"});
    expect_success(result);
    for (const char* line :
         {"samples            k_1: for each pixel that has not converged, in each frame (32 samples; ",
          "skip_open          off: tiles that nothing can block are sampled, to the same result (on; "
          "on or off)"})
        EXPECT_THAT(result.out, HasSubstr(line));
    const auto settings = nlohmann::json::parse(run_command({"list", "settings", "--json"}).out);
    EXPECT_EQ(line_count(result.out), static_cast<int>(settings.size()));
    const CommandResult one = run_command({"list", "settings", "samples"});
    EXPECT_THAT(one.out, HasSubstr("name: samples\n"));
    EXPECT_THAT(one.out, HasSubstr("default: 32\n"));
}

// What is printed of a preset makes the same: as text by --method and --set, as JSON by --preset.
TEST(List, APresetSaysWhatItSets) {
    const CommandResult result = run_command({"list", "presets", "sweep-balanced"});
    expect_success(result);
    EXPECT_THAT(result.out, testing::StartsWith("name: sweep-balanced\ndescription: "));
    const CommandResult as_json = run_command({"list", "presets", "sweep-balanced", "--json"});
    EXPECT_EQ(nlohmann::json::parse(as_json.out).at("settings").at("method"), "sweep");
    const TemporaryDirectory folder;
    const std::string file = (folder.path() / "same.json").string();
    std::ofstream(file) << as_json.out;
    std::vector<std::string> by_settings;
    std::istringstream lines(result.out);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("  method="))
            by_settings.insert(by_settings.end(), {"--method", line.substr(9)});
        else if (line.starts_with("  "))
            by_settings.insert(by_settings.end(), {"--set", line.substr(2)});
    const auto used = [&](std::vector<std::string> options) {
        const std::vector<std::string> command{"render", "corner", "--radius", "1",
                                               "--size", "16x9",   "--out",    folder.path().string()};
        options.insert(options.begin(), command.begin(), command.end());
        expect_success(run_command(options));
        std::ifstream stream(folder.path() / "render.json");
        return nlohmann::json::parse(stream).at("settings");
    };
    const auto expected = used({"--preset", "sweep-balanced"});
    EXPECT_NE(used({"--preset", "paper"}), expected);
    by_settings.insert(by_settings.end(), {"--preset", "paper"});
    EXPECT_EQ(used(by_settings), expected);
    EXPECT_EQ(used({"--preset", file}), expected);
    expect_could_not_run(run_command({"list", "presets", "no-such"}), "no-such");
}

TEST(List, EquationsSayAllThatIsKnownOfThem) {
    for (const auto& equation : nlohmann::json::parse(run_command({"list", "equations", "--json"}).out)) {
        for (const char* member : {"name", "description", "function", "file", "formula", "error", "source"})
            EXPECT_NE(equation.at(member), "") << equation;
    }
}

TEST(List, EquationsAsAPage) {
    const TemporaryDirectory folder;
    const std::string file = (folder.path() / "equations.html").string();
    expect_success(run_command({"list", "equations", "--html", file}));
    std::ifstream stream(file);
    const std::string page{std::istreambuf_iterator<char>(stream), {}};
    std::istringstream names(run_command({"list", "equations"}).out);
    for (std::string name; std::getline(names, name);)
        ASSERT_THAT(page, HasSubstr("<td>" + name + "</td>")) << name;
    expect_could_not_run(run_command({"list", "methods", "--html", file}), "--html");
    expect_could_not_run(run_command({"list", "equations", "--html", "/no/such/a.html"}), "/no/such/a.html");
}

TEST(List, UnknownKindIsNamedWithThoseThereAre) {
    const CommandResult result = run_command({"list", "no-such-kind"});
    expect_could_not_run(result, "no-such-kind");
    EXPECT_THAT(result.err, HasSubstr("equations"));
}

TEST(Usage, VersionNamesEverythingThatCompiles) {
    const CommandResult result = run_command({"--version"});
    expect_success(result);
    EXPECT_EQ(line_count(result.out), 1);
    for (const char* part : {"gloam 0.", "glslang ", "SPIRV-Tools "})
        EXPECT_THAT(result.out, HasSubstr(part));
    const TemporaryDirectory folder;
    const std::string file = (folder.path() / "a.json").string();
    expect_success(run_command({"check", "gloam_radical_inverse_base2", "--inputs", "64", "--json", file,
                                "--junit", file + ".xml"}));
    for (const std::string& name : {file, file + ".xml"}) {
        std::ifstream stream(name);
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        for (const char* part : {"gloam 0.", "glslang ", "SPIRV-Tools "})
            EXPECT_THAT(text, HasSubstr(part)) << name;
    }
}

// Whatever option is added: an empty text, NaN and a count below zero are no values.
TEST(Usage, ValuesThatNobodyMeansAreNamed) {
    const std::vector<std::vector<std::string>> wrong{
        {"check", "--timeout", "nan"}, {"check", "--timeout", "NaN"}, {"check", "--timeout", ""},
        {"check", "--seed", ""},       {"check", "--seed", "-1"},     {"check", "--shard", ""},
        {"check", "--inputs", "-1"},   {"check", "--json", ""},       {"bench", "--error", "nan"},
        {"bench", "--samples", "-4"},  {"render", "--radius", ""},    {"render", "--radius", "nan"},
        {"render", "--out", ""},       {"render", "--bias", "-nan"},  {"stress", "--seed", "-1"},
        {"pack", "--version", ""},     {"demo", "--out", ""}};
    for (const auto& command : wrong) {
        const CommandResult result = run_command(command);
        expect_could_not_run(result, command[1]);
    }
}

TEST(Usage, AnOptionThatNeedsAnotherSaysSo) {
    const std::vector<std::vector<std::string>> alone{{"render", "corner", "--truth-rays", "64"},
                                                      {"render", "corner", "--truth-falloff", "step"},
                                                      {"render", "corner", "--truth-thickness", "1"},
                                                      {"render", "moving", "--truth-every"},
                                                      {"bench", "--fail-if-worse"},
                                                      {"bench", "--resume"}};
    for (const auto& command : alone) {
        const CommandResult result = run_command(command);
        EXPECT_EQ(result.status, 2) << command.back();
        EXPECT_EQ(line_count(result.err), 1) << result.err;
        EXPECT_THAT(result.err, HasSubstr("--")) << command.back();
    }
    expect_could_not_run(run_command({"bench", "--from", "a.json", "--scene", "corner"}), "--from");
    expect_could_not_run(run_command({"check", "--in-process", "--jobs", "2"}), "--in-process");
}

TEST(Usage, TheSceneMayComeBehindTruth) {
    const TemporaryDirectory folder;
    const CommandResult result =
        run_command({"render", "--size", "16x9", "--samples", "1", "--out", (folder.path() / "out").string(),
                     "--truth-rays", "32", "--truth", "corner"});
    expect_success(result);
    EXPECT_THAT(result.out, testing::StartsWith("corner: "));
}

}  // namespace usage_test
}  // namespace gloam::test
