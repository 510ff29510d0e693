// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "tools/expect.hpp"
#include "tools/installation.hpp"

namespace gloam::test::report_test {

namespace fs = std::filesystem;
using nlohmann::json;

class ReportCommand : public InFolder {
  protected:
    // The JSON of one shard of a small check.
    fs::path shard(const std::string& which) const {
        const fs::path json = path("shard" + which.substr(0, 1) + ".json");
        expect_success(gloam("check gloam_radical_* TSSAO-5 --inputs 64 --variant all --shard {} --json {}",
                             which, json));
        return json;
    }
};

TEST_F(ReportCommand, ShardsMergeIntoTheWhole) {
    const fs::path whole = path("whole.json");
    expect_success(gloam("check gloam_radical_* TSSAO-5 --inputs 64 --variant all --json {}", whole));
    const fs::path merged = path("merged.json");
    const std::string result =
        output_of(gloam("report {} {} {} --json {}", shard("0/3"), shard("1/3"), shard("2/3"), merged));
    EXPECT_THAT(result, HasSubstr("HALTON-base2"));
    EXPECT_THAT(result, HasSubstr("shipped"));
    const std::string again = output_of(gloam("report {}", whole));
    EXPECT_EQ(result, again);
    EXPECT_EQ(json::parse(read_file(merged)).at("results").size(),
              json::parse(read_file(whole)).at("results").size());
    EXPECT_EQ(gloam("report {}", merged).out, again);  // what it writes it reads
}

TEST_F(ReportCommand, SummarizesTheAccuracy) {
    const std::string result = output_of(gloam("report --accuracy {}", shard("0/1")));
    EXPECT_THAT(result, HasSubstr("| part of the documented error |"));
    EXPECT_THAT(result, Not(HasSubstr("Of 0 functions"))) << "the strict variant was among them";
    EXPECT_THAT(result, HasSubstr("No check failed."));
}

TEST_F(ReportCommand, AFailureIsStatusOneAndConflictsAreSaid) {
    const fs::path good = shard("0/1");
    json report = json::parse(read_file(good));
    report["results"][0]["outside"] = 5;
    report["results"][0]["outcome"] = "failed";
    report["results"][0]["classes"].begin().value()["outside"] = 5;
    const fs::path bad = write("bad.json", report.dump());
    const CommandResult result = gloam("report {} {}", good, bad);
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err, "");
    EXPECT_THAT(result.out, HasSubstr("FAIL 5/64"));
    EXPECT_THAT(result.out, HasSubstr("the worse is kept"));
    EXPECT_THAT(result.out, HasSubstr(bad.string()));
}

// Other seeds are other questions: nothing of them is in conflict.
TEST_F(ReportCommand, SeedsStandBesideEachOther) {
    const fs::path first = shard("0/1");
    const fs::path second = path("seed.json");
    expect_success(gloam("check gloam_radical_* --inputs 64 --seed 2 --json {}", second));
    const std::string result = output_of(gloam("report {} {}", first, second));
    EXPECT_THAT(result, HasSubstr(", 64 inputs, seed 1\n"));
    EXPECT_THAT(result, HasSubstr(", 64 inputs, seed 2\n"));
    EXPECT_THAT(result, Not(HasSubstr("the worse is kept")));
}

TEST_F(ReportCommand, MarkdownIsAPage) {
    const std::string result = output_of(gloam("report --markdown {}", shard("0/1")));
    EXPECT_THAT(result, StartsWith("# Equations on drivers\n"));
    EXPECT_THAT(result, HasSubstr("| HALTON-base2 |"));
}

TEST_F(ReportCommand, WrongFilesAreNamed) {
    expect_could_not_run(gloam("report"), "file");
    expect_could_not_run(gloam("report --no-such-option x"), "--no-such-option");
    expect_could_not_run(gloam("report {}", path("none.json")),
                         path("none.json").string() + ": No such file");
    expect_could_not_run(gloam("report {}", path("")), path("").string());
    expect_could_not_run(gloam("report {}", write("empty.json", "")), "empty.json");
    expect_could_not_run(gloam("report {}", write("text.json", "{\n  \"device\": oops")), "line 2");
    expect_could_not_run(gloam("report {}", write("foreign.json", "{\"tests\": []}")),
                         "device: expected this field");
    json report = json::parse(read_file(shard("0/1")));
    report["results"][1]["inputs"] = "many";
    expect_could_not_run(gloam("report {}", write("field.json", report.dump())),
                         "results[1].inputs: expected a count, found \"many\"");
    expect_could_not_run(gloam("report {} --json /no/such/folder/a.json", shard("0/1")),
                         "/no/such/folder/a.json");
}

json row(const std::string& equation, int outside) {
    return {{"equation", equation}, {"variant", "strict"}, {"verdict", "rules"},
            {"inputs", 9},          {"outside", outside},  {"fault", ""},
            {"error", ""},          {"reason", ""},        {"width_fraction", 0.5}};
}

json results(const std::string& driver, int outside, int seed = 1) {
    return {{"device",
             {{"name", "Some GPU"}, {"driver", driver}, {"type", "discrete"}, {"api_version", "1.3.1"}}},
            {"inputs", 9},
            {"seed", seed},
            {"results", {row("EQ-1", 0), row("EQ-2", outside)}}};
}

class ReportSummary : public InFolder {};

TEST_F(ReportSummary, AFolderOfResultsBecomesCountsADatabaseAndAPage) {
    for (int i = 0; i < 20; ++i)
        write("in/" + std::to_string(i % 3) + "/" + std::to_string(i) + ".json",
              results("AMD Radeon driver 2" + std::to_string(i % 4) + ".1", i == 5 ? 2 : 0, i).dump());
    write("in/readme.txt", "no results");
    write("in/.unfinished/half.json", "{");
    const CommandResult result =
        gloam("report {} --summary --sqlite {} --html {}", path("in"), path("a.sqlite"), path("a.html"));
    EXPECT_EQ(result.status, 1) << "a check failed";
    EXPECT_THAT(result.out, HasSubstr("4 drivers, 8 checks, 1 failed"));
    EXPECT_THAT(result.out,
                HasSubstr("AMD: AMD Radeon driver 21.1, Vulkan 1.3.1: 5 runs, 1 devices, 2 checks, 1 failed "
                          "(EQ-2 strict)"));
    EXPECT_THAT(read_file(path("a.html")), HasSubstr("1 of 5"));
    // What is added again changes nothing, and what is there needs no files.
    fs::copy(path("in/2/5.json"), path("in/copy.json"));
    EXPECT_EQ(gloam("report {} --summary --sqlite {}", path("in"), path("a.sqlite")).out, result.out);
    EXPECT_EQ(gloam("report --summary --sqlite {}", path("a.sqlite")).out, result.out);

    fs::remove(path("in/copy.json"));
    write("in/2/5.json", results("AMD Radeon driver 21.1", 0, 5).dump());
    write("in/new.json", results("b 24.1", 0, 1).dump());
    const std::string later =
        output_of(gloam("report {} --summary --since {}", path("in"), path("a.sqlite")));
    EXPECT_THAT(later, HasSubstr("1 new drivers: b 24.1, Vulkan 1.3.1"));
    EXPECT_THAT(later, HasSubstr("1 mended: EQ-2 strict on AMD Radeon driver 21.1, Vulkan 1.3.1"));
}

TEST_F(ReportSummary, WhatIsNoResultIsNamedAndTheOthersCount) {
    write("in/good.json", results("b 1", 0).dump());
    write("in/bad.json", "[[[");
    fs::create_symlink("/dev/zero", path("in/endless.json"));
    const CommandResult result = gloam("report {} --summary", path("in"));
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.out, HasSubstr("1 drivers, 2 checks"));
    EXPECT_THAT(result.err, HasSubstr("bad.json is not what `gloam check --json` writes"));
}

TEST_F(ReportSummary, WrongOptionsAreNamed) {
    write("in/bad.json", "{}");
    write("old.sqlite", "nonsense\n");
    write("good.json", results("b 1", 0).dump());
    expect_could_not_run(gloam("report {} --summary --sqlite {}", path("in/bad.json"), path("none.sqlite")),
                         "bad.json is not what `gloam check --json` writes");
    EXPECT_FALSE(fs::exists(path("none.sqlite")));
    expect_could_not_run(gloam("report {} --summary --since {}", path("good.json"), path("old.sqlite")),
                         "old.sqlite cannot be used as a database of results");
    expect_could_not_run(gloam("report {} --since {}", path("good.json"), path("old.sqlite")), "--summary");
    expect_could_not_run(gloam("report {} --summary", path("nowhere")), "nowhere is not what");
    expect_could_not_run(gloam("report --summary"), "expected files, or --sqlite");
    expect_could_not_run(gloam("report --summary --sqlite {}", path("none.sqlite")), "none.sqlite");
}

}  // namespace gloam::test::report_test
