// SPDX-License-Identifier: MIT
#include <fstream>
#include <nlohmann/json.hpp>

#include "tools/expect.hpp"
#include "tools/installation.hpp"

namespace gloam::test {
namespace report_test {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

class ReportCommand : public testing::Test {
  protected:
    TemporaryDirectory folder;

    [[nodiscard]] std::string path(const std::string& name) const { return (folder.path() / name).string(); }

    // The JSON of one shard of a small check.
    std::string shard(const std::string& which) const {
        const std::string file = path("shard" + which.substr(0, 1) + ".json");
        expect_success(run_command({"check", "gloam_radical_*", "TSSAO-5", "--inputs", "64", "--variant",
                                    "all", "--shard", which, "--json", file}));
        return file;
    }

    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path(name)) << text;
        return path(name);
    }
};

TEST_F(ReportCommand, ShardsMergeIntoTheWhole) {
    const std::string whole = path("whole.json");
    expect_success(run_command(
        {"check", "gloam_radical_*", "TSSAO-5", "--inputs", "64", "--variant", "all", "--json", whole}));
    const std::string merged = path("merged.json");
    const CommandResult result =
        run_command({"report", shard("0/3"), shard("1/3"), shard("2/3"), "--json", merged});
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr("HALTON-base2"));
    EXPECT_THAT(result.out, HasSubstr("shipped"));
    const CommandResult again = run_command({"report", whole});
    expect_success(again);
    EXPECT_EQ(result.out, again.out);
    EXPECT_EQ(json::parse(read_file(merged)).at("results").size(),
              json::parse(read_file(whole)).at("results").size());
    EXPECT_EQ(run_command({"report", merged}).out, again.out);  // what it writes it reads
}

TEST_F(ReportCommand, SummarizesTheAccuracy) {
    const CommandResult result = run_command({"report", "--accuracy", shard("0/1")});
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr("| part of the documented error |"));
    EXPECT_THAT(result.out, testing::Not(HasSubstr("Of 0 functions"))) << "the strict variant was among them";
    EXPECT_THAT(result.out, HasSubstr("No check failed."));
}

TEST_F(ReportCommand, AFailureIsStatusOneAndConflictsAreSaid) {
    const std::string good = shard("0/1");
    json report = json::parse(read_file(good));
    report["results"][0]["outside"] = 5;
    report["results"][0]["outcome"] = "failed";
    report["results"][0]["classes"].begin().value()["outside"] = 5;
    const std::string bad = write("bad.json", report.dump());
    const CommandResult result = run_command({"report", good, bad});
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err, "");
    EXPECT_THAT(result.out, HasSubstr("FAIL 5/64"));
    EXPECT_THAT(result.out, HasSubstr("the worse is kept"));
    EXPECT_THAT(result.out, HasSubstr(bad));
}

TEST_F(ReportCommand, MarkdownIsAPage) {
    const CommandResult result = run_command({"report", "--markdown", shard("0/1")});
    expect_success(result);
    EXPECT_THAT(result.out, testing::StartsWith("# Equations on drivers\n"));
    EXPECT_THAT(result.out, HasSubstr("| HALTON-base2 |"));
}

TEST_F(ReportCommand, WrongFilesAreNamed) {
    expect_could_not_run(run_command({"report"}), "file");
    expect_could_not_run(run_command({"report", "--no-such-option", "x"}), "--no-such-option");
    expect_could_not_run(run_command({"report", path("none.json")}), path("none.json") + ": No such file");
    expect_could_not_run(run_command({"report", folder.path().string()}), folder.path().string());
    expect_could_not_run(run_command({"report", write("empty.json", "")}), "empty.json");
    expect_could_not_run(run_command({"report", write("text.json", "{\n  \"device\": oops")}), "line 2");
    expect_could_not_run(run_command({"report", write("foreign.json", "{\"tests\": []}")}),
                         "device: expected this field");
    json report = json::parse(read_file(shard("0/1")));
    report["results"][1]["inputs"] = "many";
    expect_could_not_run(run_command({"report", write("field.json", report.dump())}),
                         "results[1].inputs: expected a count, found \"many\"");
    expect_could_not_run(run_command({"report", shard("0/1"), "--json", "/no/such/folder/a.json"}),
                         "/no/such/folder/a.json");
}

}  // namespace report_test
}  // namespace gloam::test
