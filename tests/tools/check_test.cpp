// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "tools/expect.hpp"
#include "tools/installation.hpp"

namespace gloam::test {
namespace check_test {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

constexpr const char* function = "gloam_radical_inverse_base2";

json check_json(const fs::path& program, const fs::path& file, int expected_status) {
    const CommandResult result =
        run_program(program, {"check", function, "--inputs", "4096", "--json", file.string()});
    EXPECT_EQ(result.status, expected_status) << result.out << result.err;
    json report = json::parse(read_file(file));
    for (json& row : report.at("results")) row["seconds"] = 0.0;  // all else must be the same in every run
    return report;
}

TEST(Check, OneLineForEachEquationAndStatusZero) {
    const CommandResult result = run_command({"check", function, "--inputs", "1024", "--validation"});
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr(function));
    EXPECT_THAT(result.out, HasSubstr("1 checks, 0 failed"));
}

TEST(Check, GlobsSelect) {
    const CommandResult result = run_command({"check", "GLOAM_radical_*", "--inputs", "64"});
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr("gloam_radical_inverse_base2"));
    EXPECT_THAT(result.out, testing::Not(HasSubstr("gloam_smoothstep")));
    EXPECT_THAT(result.out, testing::ContainsRegex("[2-9] checks, 0 failed"));
}

TEST(Check, JsonHasTheStableShape) {
    const Installation installation;
    const json report = check_json(installation.program(), installation.file("a.json"), 0);
    EXPECT_NE(report.at("device").at("name"), "");
    ASSERT_EQ(report.at("results").size(), 1U);
    const json& result = report.at("results").front();
    EXPECT_NE(result.at("equation"), "");
    EXPECT_EQ(result.at("function"), function);
    EXPECT_EQ(result.at("file"), "gloam/sampling/radical_inverse.glsl");
    EXPECT_EQ(result.at("variant"), "shipped");
    EXPECT_EQ(result.at("inputs"), 4096);
    EXPECT_EQ(result.at("outside"), 0);
    for (const char* number : {"max_ulp", "max_abs", "budget_fraction", "seconds"})
        EXPECT_TRUE(result.at(number).is_number()) << number;
    EXPECT_EQ(result.at("verdict"), "budget");
    EXPECT_EQ(result.at("reason"), "");
    EXPECT_TRUE(result.contains("width_fraction"));
    EXPECT_TRUE(result.at("budget").is_object());
    EXPECT_TRUE(result.contains("worst"));
}

TEST(Check, TheSameSeedGivesTheSameReport) {
    const Installation installation;
    const json first = check_json(installation.program(), installation.file("a.json"), 0);
    EXPECT_EQ(first, check_json(installation.program(), installation.file("b.json"), 0));
}

TEST(Check, AWrongConstantFailsWithStatusOneAndAStory) {
    const Installation installation;
    installation.replace("gloam/sampling/radical_inverse.glsl", "5.9604644775390625e-8", "5.9604652e-8");
    const CommandResult result = run_program(installation.program(), {"check", function, "--inputs", "4096"});
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err, "");
    EXPECT_THAT(result.out, HasSubstr("1 checks, 1 failed"));
    EXPECT_THAT(result.out, HasSubstr("want"));

    const json report = check_json(installation.program(), installation.file("a.json"), 1);
    const json& row = report.at("results").front();
    EXPECT_GT(row.at("outside").get<int>(), 2000);
    EXPECT_TRUE(row.at("worst").is_object());
}

TEST(Check, AShaderThatDoesNotCompileFailsAndNamesFileAndLine) {
    const Installation installation;
    installation.replace("gloam/sampling/radical_inverse.glsl",
                         "uint bits = ", "uint bits = no_such_variable + ");
    const CommandResult result = run_program(installation.program(), {"check", function});
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.out, testing::ContainsRegex("radical_inverse\\.glsl:[0-9]+: .*no_such_variable"));
}

TEST(Check, AllVariantsAndJunit) {
    const TemporaryDirectory folder;
    const fs::path junit = folder.path() / "junit.xml";
    const CommandResult result =
        run_command({"check", function, "--inputs", "64", "--variant", "all", "--junit", junit.string()});
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr("9 checks, 0 failed"));
    EXPECT_THAT(read_file(junit), HasSubstr("<testsuite"));
}

TEST(Check, BadInputIsNamed) {
    expect_could_not_run(run_command({"check", "no-such-equation"}), "no-such-equation");
    expect_could_not_run(run_command({"check", function, "--device", "no-such-device"}), "no-such-device");
    expect_could_not_run(run_command({"check", function, "--variant", "no-such-variant"}), "no-such-variant");
    expect_could_not_run(run_command({"check", function, "--inputs", "0"}), "--inputs");
    expect_could_not_run(run_command({"check", function, "--inputs", "many"}), "many");
    expect_could_not_run(run_command({"check", function, "--json", "/no/such/folder/a.json"}),
                         "/no/such/folder/a.json");
}

}  // namespace check_test
}  // namespace gloam::test
