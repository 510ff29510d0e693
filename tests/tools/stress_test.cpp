// SPDX-License-Identifier: MIT
#include "tools/gloam.hpp"

namespace gloam::test::stress_test {

class Stress : public InFolder {};

TEST_F(Stress, WritesWhatItMeasured) {
    const auto file = path("stress.json");
    const std::string result =
        output_of(gloam("stress --only long-run --brief --frames 400 --seed 5 --json {}", file));
    EXPECT_THAT(result, HasSubstr("0 bounds broken"));
    const json document = json::parse(read_file(file));
    EXPECT_NE(document.at("device").at("name"), "");
    ASSERT_FALSE(document.at("rows").empty());
    for (const json& row : document.at("rows")) {
        EXPECT_EQ(row.at("run"), "long-run");
        EXPECT_EQ(row.at("passed"), true);
        EXPECT_THAT(result, HasSubstr(row.at("varied").get<std::string>()));
    }
}

TEST_F(Stress, ABrokenBoundIsStatusOne) {
    const Installation broken;
    broken.replace("gloam/temporal/blend.glsl", "total < cap ? total : cap", "total");
    const CommandResult result = broken.gloam("stress --only long-run --frames 400");
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.out, HasSubstr("BROKEN"));
}

TEST_F(Stress, BadInputIsOneClearLine) {
    const CommandResult unknown = gloam("stress --only no-such-run");
    expect_could_not_run(unknown, "no-such-run");
    EXPECT_THAT(unknown.err, HasSubstr("long-run, far-away"));
    expect_could_not_run(gloam("stress --frames 0"), "--frames");
    expect_could_not_run(gloam("stress --only worst-inputs --equation no-such"), "no-such");
    expect_could_not_run(gloam("stress --device no-such-device"), "no-such-device");
    expect_could_not_run(gloam("stress --json /no/such/folder/stress.json"), "/no/such/folder");
}

Arguments tiny(const Arguments& more) {
    Arguments arguments{"tune", "--size", "32x18", "--frames", "2",      "--scored",
                        "1",    "--rays", "32",    "--view",   "moving", "room"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

using Tune = InFolder;

// The views `room` and `moving` are of different halves. The preset that is written renders as its own
// settings do.
TEST_F(Tune, WritesAPresetAndAReport) {
    const auto preset = folder.path() / "mine.json";
    const auto report = folder.path() / "report.md";
    const CommandResult result =
        run_command(tiny({"--preset", "balanced", "--method", "alchemy", "--set", "history=off", "--set",
                          "intensity=0.05", "--parameter", "intensity=0.05:2:log", "--evaluations", "6",
                          "--out", preset.string(), "--report", report.string()}));
    expect_success(result);
    EXPECT_EQ(read_file(report), result.out);
    EXPECT_THAT(result.out, HasSubstr("| `intensity` | 0.05 | 2 | 0.05 |"));
    EXPECT_THAT(result.out, HasSubstr("| moving | scene | tuning |"));
    EXPECT_THAT(result.out, HasSubstr("| room | scene | unseen |"));
    const json document = json::parse(read_file(preset));
    EXPECT_EQ(document.at("name"), "mine");
    EXPECT_EQ(document.at("settings").at("method"), "alchemy");
    EXPECT_EQ(document.at("settings").at("history"), false);
    const std::string intensity = document.at("settings").at("intensity").dump();
    const auto rendered = [&](const std::string& name, const Arguments& options) {
        const auto out = folder.path() / name;
        Arguments arguments{"render", "moving", "--frames",    "1",     "--size",
                            "32x18",  "--set",  "history=off", "--out", out.string()};
        arguments.insert(arguments.end(), options.begin(), options.end());
        expect_success(run_command(arguments));
        return read_file(out / "f0000_ao.pfm");
    };
    const std::string by_file = rendered("file", {"--preset", preset.string()});
    EXPECT_TRUE(by_file == rendered("set", {"--method", "alchemy", "--set", "intensity=" + intensity}));
    EXPECT_FALSE(by_file == rendered("start", {"--method", "alchemy", "--set", "intensity=0.05"}));
}

TEST_F(Tune, WrongOptionsAreNamed) {
    const Arguments steps{"--parameter", "steps=2:4"};
    expect_could_not_run(run_command(tiny({})), "--parameter");
    expect_could_not_run(run_command(tiny({"--parameter", "magic=0:1"})), "magic");
    expect_could_not_run(run_command(tiny({"--parameter", "steps=4"})), "steps=4");
    expect_could_not_run(run_command(tiny({"--parameter", "steps=4:2"})), "steps from 4 to 2");
    expect_could_not_run(run_command(tiny({"--parameter", "filter=0:1"})), "filter is not a number");
    const auto with_steps = [&](Arguments more) {
        more.insert(more.end(), steps.begin(), steps.end());
        return run_command(tiny(more));
    };
    expect_could_not_run(with_steps({"--preset", "magic"}), "magic");
    expect_could_not_run(with_steps({"--preset", "/nowhere/magic.json"}), "/nowhere/magic.json");
    const auto deep = folder.path() / "deep.json";
    std::ofstream(deep) << std::string(200'000, '[');
    expect_could_not_run(with_steps({"--preset", deep.string()}), "deep.json: line 1: nested more than");
    expect_could_not_run(with_steps({"--view", "magic"}), "magic");
    expect_could_not_run(with_steps({"--objective", "magic"}), "magic");
    expect_could_not_run(with_steps({"--evaluations", "0"}), "--evaluations");
    expect_could_not_run(run_command({"tune", "--parameter", "steps=2:4", "--frames", "2", "--scored", "3"}),
                         "--scored 3");
    expect_could_not_run(with_steps({"--out", "/nowhere/preset.json"}), "/nowhere");
    expect_could_not_run(
        run_command({"tune", "--view", "moving", "--parameter", "steps=2:4", "--size", "32x18"}),
        "no view of the unseen half");
    expect_could_not_run(run_command({"tune", "--view", "bunny", "horse", "--parameter", "steps=2:4",
                                      "--size", "32x18", "--meshes", "/nowhere"}),
                         "/nowhere/bunny.obj");
}

TEST_F(Tune, AFileThatIsNoPresetIsNamed) {
    const auto file = (folder.path() / "bad.json").string();
    const auto refused = [&](const std::string& text, const std::string& named) {
        std::ofstream(file) << text;
        expect_could_not_run(run_command({"render", "moving", "--preset", file}), named);
    };
    refused("not JSON", "bad.json: expected JSON");
    refused("[]", "bad.json: expected JSON");
    refused(R"({"settings": 3})", "bad.json: expected JSON");
    refused(R"({"settings": {"magic": 3}})", "magic");
    refused(R"({"settings": {"steps": "many"}})", "steps");
    refused(R"({"settings": {"steps": [1, 2]}})", "steps");
    refused(R"({"settings": {"radius": 2}})", "radius 2");
}

// `gloam work`: one list, many machines.

class Work : public InFolder {
  protected:
    // A list of these arguments, in a file.
    template <class... Texts>
    fs::path list(std::string_view line, const Texts&... arguments) const {
        return write("list", output_of(gloam("work list " + std::string(line), arguments...)));
    }
    fs::path small_list() const {
        return list(
            "--each seed=1..2 --each shard=0..1 -- check gloam_radical_* --inputs 64 --seed {seed} "
            "--shard {shard}/2 --device interpreter --json {result}");
    }
    [[nodiscard]] std::set<std::string> results() const {
        std::set<std::string> names;
        for (const fs::directory_entry& entry : fs::directory_iterator(path("results")))
            names.insert(entry.path().filename());
        return names;
    }
    [[nodiscard]] CommandResult run() const {
        return gloam("work run {} --results {}", path("list"), path("results"));
    }
};

TEST_F(Work, AListHasAnItemForEachCombination) {
    write("names", "a\nb c\n");
    const fs::path file = list("--each name=@" + path("names").string() +
                               " --each seed=9..10 -- check --seed {seed} --json {result}{name}");
    std::ifstream lines(file);
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(json::parse(line).at("items"), 4);
    std::vector<std::string> items;
    while (std::getline(lines, line)) items.push_back(line);
    EXPECT_THAT(items, ElementsAre(R"(["check","--seed","9","--json","{result}a"])",
                                   R"(["check","--seed","10","--json","{result}a"])",
                                   R"(["check","--seed","9","--json","{result}b c"])",
                                   R"(["check","--seed","10","--json","{result}b c"])"));
}

TEST_F(Work, AListLeavesToACommandWhatItReplaces) {
    const std::string step = "cp {in} {out}";
    EXPECT_THAT(
        read_file(list("--each seed=1..1 -- check --compiler {} --seed {seed} --json {result}", step)),
        HasSubstr(R"(["check","--compiler","cp {in} {out}","--seed","1","--json","{result}"])"));
    expect_could_not_run(gloam("work list --each in=1..3 -- check {in} --json {result}"),
                         "without {result}, {each}");
}

TEST_F(Work, WhatIsNoListIsSaid) {
    for (const auto& [line, why] : std::vector<std::pair<std::string, std::string>>{
             {"--each seed=1..3 -- check --json {result}", "no argument holds {seed}"},
             {"-- check --seed {seed} --json {result}", "{seed}: no --each names its values"},
             {"-- check --json file", "expected {result} once"},
             {"-- check --json {result} --html {result}", "expected {result} once"},
             {"-- mutate --json {result}", "expected -- and one of the commands audit, bench, check"},
             {"--each seed -- check --json {result}", "expected NAME=VALUES"},
             {"--each seed=3..1 -- check --json {result}{seed}", "expected LOW..HIGH"},
             {"--each seed=, -- check --json {result}{seed}", "at least one value"},
             {"--each a=1..1000 --each b=1..1001 -- check {a} {b} {result}", "at most 1000000 items"},
             {"--each a=@/no/such/file -- check {a} {result}", "/no/such/file"}})
        expect_could_not_run(run_command(words("work list " + line)), why);
}

TEST_F(Work, EachItemRunsOnceWhoeverAsks) {
    (void)small_list();
    EXPECT_EQ(gloam("work missing {} --results {}", path("list"), path("results")).out, "0-3\n");
    EXPECT_THAT(gloam("work run {} --results {} --shard 1/4", path("list"), path("results")).out,
                StartsWith("1 items of 4: 1 done, 0 were there, 0 have no result"));
    const CommandResult missing = gloam("work missing {} --results {}", path("list"), path("results"));
    EXPECT_EQ(missing.out, "0,2-3\n");
    EXPECT_EQ(missing.err, "3 of 4 items have no result\n");
    EXPECT_EQ(gloam("work missing {} --results {} --shards 2", path("list"), path("results")).out, "0-1\n");
    EXPECT_THAT(output_of(run()), StartsWith("4 items of 4: 3 done, 1 were there"));
    EXPECT_EQ(gloam("work missing {} --results {}", path("list"), path("results")).out, "");
    const std::set<std::string> all = results();
    EXPECT_EQ(all.size(), 4U);
    EXPECT_THAT(output_of(run()), StartsWith("4 items of 4: 0 done, 4 were there"));
    EXPECT_EQ(results(), all);
    // The whole is that of one call a seed.
    fs::create_directory(path("whole"));
    expect_success(gloam("report {} --summary --sqlite {}", path("results"), path("all.sqlite")));
    for (const char* seed : {"1", "2"})
        expect_success(gloam("check gloam_radical_* --inputs 64 --device interpreter --seed {} --json {}",
                             seed, path("whole/") / (std::string(seed) + ".json")));
    expect_success(gloam("report {} --summary --sqlite {}", path("whole"), path("whole.sqlite")));
    EXPECT_EQ(gloam("report --summary --sqlite {}", path("all.sqlite")).out,
              gloam("report --summary --sqlite {}", path("whole.sqlite")).out);
}

TEST_F(Work, AListSharesTheResultsOfAnother) {
    (void)small_list();
    expect_success(run());
    (void)list(
        "--each seed=2..3 --each shard=0..1 -- check gloam_radical_* --inputs 64 --seed {seed} "
        "--shard {shard}/2 --device interpreter --json {result}");
    EXPECT_THAT(output_of(run()), StartsWith("4 items of 4: 2 done, 2 were there"));
}

// A file that an item reads is a part of what it is.
TEST_F(Work, AChangedFileIsOtherWork) {
    write("own.glsl", "float own(float x) { return x + 1.0; }\n");
    (void)list("-- check {} --inputs 64 --device interpreter --json {}", path("own.glsl"), "{result}");
    expect_success(run());
    write("own.glsl", "float own(float x) { return x + 2.0; }\n");
    EXPECT_THAT(output_of(run()), StartsWith("1 items of 1: 1 done"));
    EXPECT_EQ(results().size(), 2U);
}

TEST_F(Work, AFolderIsAResultToo) {
    (void)list("-- render corner --size 16x9 --samples 1 --truth --truth-rays 32 --quiet --out {result}");
    expect_success(run());
    ASSERT_EQ(results().size(), 1U);
    EXPECT_TRUE(fs::exists(path("results") / *results().begin() / "render.json"));
    EXPECT_THAT(output_of(run()), StartsWith("1 items of 1: 0 done, 1 were there"));
}

TEST_F(Work, AnItemWithoutAResultIsNamedAndTheOthersRun) {
    (void)list(
        "--each name=HALTON-2D,nonsense -- check {name} --inputs 64 --device interpreter --quiet "
        "--json {result}");
    const CommandResult result = run();
    EXPECT_EQ(result.status, 2);
    EXPECT_THAT(result.out, StartsWith("2 items of 2: 1 done, 0 were there, 1 have no result"));
    EXPECT_EQ(line_count(result.err), 1);
    EXPECT_THAT(result.err, StartsWith("gloam: item 1 (gloam check nonsense"));
    EXPECT_THAT(result.err, HasSubstr("no equation matches"));
    EXPECT_EQ(results().size(), 1U) << "nothing is left of it";
}

TEST_F(Work, AListThatWasChangedIsRefused) {
    const std::string text = read_file(small_list());
    const auto refuses = [&](const std::string& changed, const std::string& why) {
        write("list", changed);
        expect_could_not_run(run(), "work list " + path("list").string() + ": " + why);
        expect_could_not_run(gloam("work missing {} --results {}", path("list"), path("results")), why);
        EXPECT_FALSE(fs::exists(path("results")));
    };
    refuses("", "it is not what `gloam work list` prints");
    refuses("[1, 2]\n", "it is not what `gloam work list` prints");
    refuses(text.substr(0, text.size() - 20), "it was changed after it was made, or its end is missing");
    refuses(text + text.substr(text.find('\n') + 1), "it was changed after it was made");
    std::string other = text;
    refuses(other.replace(text.find("gloam 0."), 8, "gloam 9."), "it was made by gloam 9.");
    write("list", text);
    expect_could_not_run(gloam("work run {} --results {} --shard 4/4", path("list"), path("results")),
                         "--shard");
    expect_could_not_run(gloam("work run {} --results {}", path("nowhere"), path("results")), "nowhere");
    expect_could_not_run(gloam("work run {} --results {}", path("list"), path("list")), "list");
}

}  // namespace gloam::test::stress_test
