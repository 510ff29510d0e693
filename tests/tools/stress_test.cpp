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

}  // namespace gloam::test::stress_test
