// SPDX-License-Identifier: MIT
#include <fstream>
#include <nlohmann/json.hpp>

#include "tools/expect.hpp"
#include "tools/installation.hpp"

namespace gloam::test {
namespace report_summary_test {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

json row(const std::string& equation, int outside) {
    return {{"equation", equation}, {"variant", "strict"}, {"verdict", "rules"},
            {"inputs", 9},          {"outside", outside},  {"fault", ""},
            {"error", ""},          {"reason", ""},        {"width_fraction", 0.5}};
}

json results(const std::string& driver, int outside) {
    return {{"device",
             {{"name", "Some GPU"}, {"driver", driver}, {"type", "discrete"}, {"api_version", "1.3.1"}}},
            {"results", {row("EQ-1", 0), row("EQ-2", outside)}}};
}

class ReportSummary : public testing::Test {
  protected:
    TemporaryDirectory folder;

    [[nodiscard]] std::string path(const std::string& name) const { return (folder.path() / name).string(); }

    void write(const std::string& name, const std::string& text) const {
        fs::create_directories(fs::path(path(name)).parent_path());
        std::ofstream(path(name)) << text;
    }
};

TEST_F(ReportSummary, AFolderOfResultsBecomesCountsLinesAndAPage) {
    for (int i = 0; i < 20; ++i)
        write("in/" + std::to_string(i % 3) + "/" + std::to_string(i) + ".json",
              results("AMD Radeon driver 2" + std::to_string(i % 4) + ".1", i == 5 ? 2 : 0).dump());
    write("in/readme.txt", "no results");
    const CommandResult result = run_command(
        {"report", path("in"), "--summary", "--lines", path("a.jsonl"), "--html", path("a.html")});
    EXPECT_EQ(result.status, 1) << "a check failed";
    EXPECT_THAT(result.out, HasSubstr("20 files, 4 drivers, 8 checks, 1 failed"));
    EXPECT_THAT(result.out,
                HasSubstr("AMD: AMD Radeon driver 21.1, Vulkan 1.3.1: 5 files, 1 devices, 2 checks, 1 failed "
                          "(EQ-2 strict)"));
    EXPECT_THAT(read_file(path("a.html")), HasSubstr("1 of 5"));
    std::ifstream lines(path("a.jsonl"));
    std::size_t count = 0;
    for (std::string line; std::getline(lines, line); ++count)
        EXPECT_EQ(json::parse(line).at("vendor"), "AMD");
    EXPECT_EQ(count, 8U);

    write("in/2/5.json", results("AMD Radeon driver 21.1", 0).dump());
    write("in/new.json", results("AMD Radeon driver 24.1", 0).dump());
    const CommandResult later = run_command({"report", path("in"), "--summary", "--since", path("a.jsonl")});
    expect_success(later);
    EXPECT_THAT(later.out, HasSubstr("1 new drivers: AMD Radeon driver 24.1, Vulkan 1.3.1"));
    EXPECT_THAT(later.out, HasSubstr("1 mended: EQ-2 strict on AMD Radeon driver 21.1, Vulkan 1.3.1"));
}

TEST_F(ReportSummary, WhatIsNoResultIsNamedAndTheOthersCount) {
    write("in/good.json", results("b 1", 0).dump());
    write("in/bad.json", "[[[");
    fs::create_symlink("/dev/zero", path("in/endless.json"));
    const CommandResult result = run_command({"report", path("in"), "--summary"});
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.out, HasSubstr("1 files, 1 drivers"));
    EXPECT_THAT(result.err, HasSubstr("bad.json is not what `gloam check --json` writes"));
}

TEST_F(ReportSummary, WrongOptionsAreNamed) {
    write("in/bad.json", "{}");
    write("old.jsonl", "nonsense\n");
    write("good.json", results("b 1", 0).dump());
    expect_could_not_run(
        run_command({"report", path("in/bad.json"), "--summary", "--lines", path("none.jsonl")}),
        "bad.json is not what `gloam check --json` writes");
    EXPECT_FALSE(fs::exists(path("none.jsonl")));
    expect_could_not_run(
        run_command({"report", path("good.json"), "--summary", "--since", path("old.jsonl")}), "line 1");
    expect_could_not_run(run_command({"report", path("good.json"), "--since", path("old.jsonl")}),
                         "--summary");
    expect_could_not_run(run_command({"report", path("nowhere"), "--summary"}), "nowhere is not what");
}

}  // namespace report_summary_test
}  // namespace gloam::test
