// SPDX-License-Identifier: MIT
// `gloam render` on scenes that move and on sequences of G-buffers: the history follows them, and dies where
// it must.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "scene/image_files.hpp"
#include "tools/expect.hpp"

namespace gloam::test {
namespace render_sequence_test {

namespace fs = std::filesystem;
using nlohmann::json;

class RenderSequence : public testing::Test {
  protected:
    [[nodiscard]] fs::path file(const std::string& name) const { return scratch_.path() / name; }

    // 64 x 36 pixels into a folder of that name.
    [[nodiscard]] CommandResult render(const std::string& out, std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "render");
        arguments.insert(arguments.end(), {"--size", "64x36", "--out", file(out).string()});
        return run_command(arguments);
    }

    [[nodiscard]] json report(const std::string& out) const {
        std::ifstream stream(file(out) / "render.json");
        return json::parse(stream);
    }

    [[nodiscard]] std::vector<float> picture(const std::string& out, const std::string& frame) const {
        return scene::read_pfm(file(out) / (frame + "_ao.pfm")).texels;
    }

    // A folder of four frames of a scene that moves, and what was made of them in "drawn".
    [[nodiscard]] std::string sequence(std::vector<std::string> more = {}) const {
        const std::string folder = file("gbuffer").string();
        more.insert(more.begin(), {"moving", "--frame", "20", "--frames", "4", "--write-gbuffer", folder});
        expect_success(render("drawn", more));
        return folder;
    }

    void change_json(const std::string& frame, const std::function<void(json&)>& change) const {
        const fs::path path = file("gbuffer") / (frame + ".json");
        json description = json::parse(std::ifstream(path));
        change(description);
        std::ofstream(path) << description.dump();
    }

    [[nodiscard]] std::vector<json> cuts(const std::string& out) const {
        std::vector<json> reasons;
        const json frames = report(out).at("frames");
        for (const json& frame : frames) reasons.push_back(frame.at("history").at("cut"));
        return reasons;
    }

  private:
    TemporaryDirectory scratch_;
};

TEST_F(RenderSequence, AMovingSceneIsFollowed) {
    expect_success(render("out", {"moving", "--frame", "20", "--frames", "4"}));
    const json frames = report("out").at("frames");
    ASSERT_EQ(frames.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(frames[i].at("frame"), i);
        EXPECT_EQ(frames[i].at("scene_frame"), 20 + i);
        EXPECT_EQ(frames[i].contains("flicker"), i > 0);
        const double kept = frames[i].at("history").at("kept");
        EXPECT_EQ(kept > 0.95, i > 0) << kept;
        EXPECT_EQ(frames[i].at("times_ms").contains("reproject"), i > 0);
    }
    EXPECT_GT(frames[3].at("history").at("samples"), 80.0);
}

TEST_F(RenderSequence, StillHoldsOneFrame) {
    expect_success(render("out", {"moving", "--frame", "20", "--frames", "3", "--still"}));
    const json last = report("out").at("frames").at(2);
    EXPECT_EQ(last.at("scene_frame"), 20);
    EXPECT_EQ(last.at("history").at("kept"), 1.0);
    EXPECT_FALSE(last.at("times_ms").contains("reproject"));
    expect_success(render("mesh", {"corner", "--frames", "3"}));  // nothing moves in it
    EXPECT_EQ(report("mesh").at("frames").at(2).at("scene_frame"), 0);
    EXPECT_EQ(report("mesh").at("frames").at(2).at("history").at("samples"), 64.0);
}

TEST_F(RenderSequence, WrittenAndReadBackItIsTheSame) {
    for (const std::vector<std::string>& options : {std::vector<std::string>{}, {"--guard", "0.1"}}) {
        const std::string folder = sequence(options);
        expect_success(render("read", {"--gbuffer", folder}));
        for (const char* frame : {"f0000", "f0001", "f0002", "f0003"}) {
            const std::vector<float> drawn = picture("drawn", frame);
            const std::vector<float> read = picture("read", frame);
            ASSERT_EQ(read.size(), 64U * 36U);
            ASSERT_EQ(read.size(), drawn.size());
            for (std::size_t i = 0; i < read.size(); ++i)
                ASSERT_NEAR(read[i], drawn[i], 1e-5) << frame << " " << i;
        }
        fs::remove_all(folder);
    }
}

TEST_F(RenderSequence, CutsStartAfresh) {
    const std::string folder = sequence();
    change_json("f0002", [](json& frame) { frame["camera"]["prev_view"] = nullptr; });
    change_json("f0002", [](json& frame) { frame["camera"].erase("previous_from_current"); });
    expect_success(render("cut", {"--gbuffer", folder}));
    EXPECT_THAT(cuts("cut"),
                testing::ElementsAre("the first frame", nullptr, "there is no prev_view", nullptr));
    EXPECT_EQ(report("cut").at("frames").at(2).at("history").at("kept"), 0.0);
    EXPECT_FALSE(report("cut").at("frames").at(2).contains("flicker"));

    change_json("f0002", [](json& frame) { frame["camera"]["prev_view"] = frame["camera"]["view"]; });
    change_json("f0003", [](json& frame) { frame["ao_radius"] = 0.2; });
    expect_success(render("other", {"--gbuffer", folder}));
    EXPECT_THAT(cuts("other"),
                testing::ElementsAre("the first frame", nullptr, "prev_view is not the view before",
                                     "the radius has changed"));
    for (const char* name : {".json", "_depth.pfm", "_normal.pfm", "_motion.pfm", "_previous_depth.pfm"})
        fs::remove(fs::path(folder) / (std::string("f0001") + name));
    expect_success(render("gap", {"--gbuffer", folder, "--radius", "0.4"}));
    EXPECT_EQ(cuts("gap").at(1), "frames are missing before it");
}

// Single frames, each as it would be alone.
TEST_F(RenderSequence, WithoutMatricesEachFrameIsItsOwn) {
    const std::string folder = sequence();
    for (const char* frame : {"f0001", "f0002", "f0003"}) {
        change_json(frame, [](json& description) {
            description["camera"].erase("prev_view");
            description["camera"].erase("previous_from_current");
        });
    }
    expect_success(render("out", {"--gbuffer", folder}));
    EXPECT_THAT(cuts("out"), testing::ElementsAre("the first frame", "there is no prev_view",
                                                  "there is no prev_view", "there is no prev_view"));
    expect_success(render("alone", {"moving", "--frame", "23"}));
    EXPECT_EQ(picture("out", "f0003"), picture("alone", "f0000"));
}

TEST_F(RenderSequence, TruthOfTheLastFrameOrOfEach) {
    const std::vector<std::string> some{"moving", "--frame", "20",           "--frames",
                                        "3",      "--truth", "--truth-rays", "32"};
    expect_success(render("last", some));
    std::vector<std::string> every = some;
    every.emplace_back("--truth-every");
    expect_success(render("every", every));
    const json last = report("last").at("frames");
    const json each = report("every").at("frames");
    EXPECT_FALSE(last[1].contains("errors"));
    EXPECT_EQ(last[2].at("errors"), each[2].at("errors"));
    EXPECT_TRUE(last[2].at("errors").contains("filtered_by_class"));
    EXPECT_TRUE(each[0].contains("errors") && each[1].contains("errors"));
    EXPECT_EQ(scene::read_pfm(file("last") / "truth.pfm").texels,
              scene::read_pfm(file("every") / "f0002_truth.pfm").texels);
    EXPECT_NE(scene::read_pfm(file("every") / "f0001_truth.pfm").texels,
              scene::read_pfm(file("every") / "f0002_truth.pfm").texels);
}

// What is set by name is what was used, and what is listed is what can be set.
TEST_F(RenderSequence, SettingsByName) {
    const CommandResult listed = run_command({"list", "settings", "--json"});
    expect_success(listed);
    const json settings = json::parse(listed.out);
    expect_success(render("plain", {"corner", "--radius", "1"}));
    const json used = report("plain").at("settings");
    ASSERT_EQ(used.size(), settings.size());
    for (const json& setting : settings) {
        for (const char* key : {"description", "unit", "expected"}) EXPECT_TRUE(setting.at(key).is_string());
        EXPECT_EQ(used.at(setting.at("name")), setting.at("default")) << setting;
    }
    expect_success(render("out", {"corner", "--set", "samples=7", "--set", "taps=nearest", "--set",
                                  "filter=off", "--samples", "9", "--set", "guard=0.25"}));
    const json changed = report("out").at("settings");
    EXPECT_EQ(changed.at("samples"), 7);
    EXPECT_EQ(changed.at("taps"), "nearest");
    EXPECT_EQ(changed.at("filter"), "none");
    EXPECT_EQ(report("out").at("frames").at(0).at("samples"), 7 * 96 * 54) << "with the guard band";
}

TEST_F(RenderSequence, OptionsThatDoNotGoTogether) {
    const std::string folder = sequence();
    expect_could_not_run(render("out", {"--gbuffer", folder, "--still"}), "--still");
    expect_could_not_run(render("out", {"--gbuffer", folder, "--frames", "9"}), "--frames 9");
    expect_could_not_run(render("out", {"moving", "--truth-every"}), "--truth-every");
    expect_could_not_run(render("out", {"moving", "--frames", "10000"}), "--frames");
    EXPECT_FALSE(fs::exists(file("out")));
}

}  // namespace render_sequence_test
}  // namespace gloam::test
