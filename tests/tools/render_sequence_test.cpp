// SPDX-License-Identifier: MIT
// `gloam render` on scenes that move and on sequences of G-buffers: the history follows them, and dies where
// it must.
#include "tools/rendering.hpp"

namespace gloam::test::render_sequence_test {

class RenderSequence : public Rendering {
  protected:
    RenderSequence() { always_ = words("--size 64x36"); }

    // A folder of four frames of a scene that moves, and what was made of them in "drawn".
    [[nodiscard]] std::string sequence(std::vector<std::string> more = {}) const {
        const std::string folder = path("gbuffer").string();
        // From frame 20 a sample lies on the border of a pixel, and the rounding of a motion vector decides.
        more.insert(more.begin(), {"moving", "--frame", "21", "--frames", "4", "--write-gbuffer", folder});
        expect_success(render("drawn", more));
        return folder;
    }

    void change_json(const std::string& frame, const std::function<void(json&)>& change) const {
        const fs::path file = path("gbuffer") / (frame + ".json");
        json description = json::parse(read_file(file));
        change(description);
        std::ofstream(file) << description.dump();
    }

    [[nodiscard]] std::vector<json> cuts(const std::string& out) const {
        std::vector<json> reasons;
        const json frames = report(out).at("frames");
        for (const json& frame : frames) reasons.push_back(frame.at("history").at("cut"));
        return reasons;
    }
};

TEST_F(RenderSequence, AMovingSceneIsFollowed) {
    expect_success(render("out", "moving --frame 20 --frames 4 --preset tssao-paper"));
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
    EXPECT_GT(frames[3].at("history").at("samples"), 85.0);  // of 96 before it
}

TEST_F(RenderSequence, StillHoldsOneFrame) {
    expect_success(render("out", "moving --frame 20 --frames 3 --still --preset tssao-paper"));
    const json last = report("out").at("frames").at(2);
    EXPECT_EQ(last.at("scene_frame"), 20);
    EXPECT_EQ(last.at("history").at("kept"), 1.0);
    EXPECT_FALSE(last.at("times_ms").contains("reproject"));
    expect_success(render("mesh", "corner --method hemisphere --frames 3"));  // nothing moves in it
    EXPECT_EQ(report("mesh").at("frames").at(2).at("scene_frame"), 0);
    EXPECT_EQ(report("mesh").at("frames").at(2).at("history").at("samples"), 64.0);
}

TEST_F(RenderSequence, WrittenAndReadBackItIsTheSame) {
    for (const std::vector<std::string>& options : {std::vector<std::string>{}, {"--guard", "0.1"}}) {
        const std::string folder = sequence(options);
        expect_success(render("read", "--gbuffer {}", folder));
        for (const char* frame : {"f0000", "f0001", "f0002", "f0003"}) {
            const std::vector<float> drawn = picture("drawn", std::string(frame) + "_ao.pfm");
            const std::vector<float> read = picture("read", std::string(frame) + "_ao.pfm");
            ASSERT_EQ(read.size(), 64U * 36U);
            ASSERT_EQ(read.size(), drawn.size());
            for (std::size_t i = 0; i < read.size(); ++i)
                ASSERT_NEAR(read[i], drawn[i], 1e-5) << frame << " " << i;
        }
        fs::remove_all(folder);
    }
}

// The left half of the picture, by a camera whose axis is at its right edge. A jitter, here up to half a
// pixel, leaves its place.
TEST_F(RenderSequence, AViewportOfACameraOffCentreIsThatPartOfThePicture) {
    const std::string folder = sequence();
    expect_success(render("whole", "--gbuffer {} --radius 0.2 --preset tssao-paper", folder));
    for (const auto& [frame, jitter] :
         {std::pair{"f0000", 0.0}, {"f0001", 0.4}, {"f0002", -0.5}, {"f0003", 0.3}}) {
        change_json(frame, [pixels = jitter](json& description) {
            description["viewport"] = {0, 0, 32, 36};
            json& projection = description["camera"]["proj_vk"];
            projection[0] = 2.0 * projection[0].get<double>();
            projection[8] = -1.0 + 2.0 * pixels / 32.0;
        });
    }
    expect_success(
        render("part", "--gbuffer {} --radius 0.2 --preset tssao-paper --truth --truth-rays 32", folder));
    EXPECT_EQ(cuts("part"), cuts("whole"));
    const std::vector<float> whole = picture("whole", "f0003_ao.pfm");
    const std::vector<float> part = picture("part", "f0003_ao.pfm");
    ASSERT_EQ(part.size(), 32U * 36U);
    for (std::size_t y = 0; y < 36; ++y)
        for (std::size_t x = 0; x < 16; ++x) EXPECT_EQ(part[32 * y + x], whole[64 * y + x]) << x << ' ' << y;
    change_json("f0000", [](json& description) { description["camera"]["proj_vk"][8] = 1800.0; });
    expect_refused(words("--gbuffer {}", folder), "with background up to a centred projection");
}

TEST_F(RenderSequence, CutsStartAfresh) {
    const std::string folder = sequence();
    change_json("f0002", [](json& frame) { frame["camera"]["prev_view"] = nullptr; });
    change_json("f0002", [](json& frame) { frame["camera"].erase("previous_from_current"); });
    expect_success(render("cut", "--gbuffer {}", folder));
    EXPECT_THAT(cuts("cut"), ElementsAre("the first frame", nullptr, "there is no prev_view", nullptr));
    EXPECT_EQ(report("cut").at("frames").at(2).at("history").at("kept"), 0.0);
    EXPECT_FALSE(report("cut").at("frames").at(2).contains("flicker"));

    change_json("f0002", [](json& frame) { frame["camera"]["prev_view"] = frame["camera"]["view"]; });
    change_json("f0003", [](json& frame) { frame["ao_radius"] = 0.2; });
    expect_success(render("other", "--gbuffer {}", folder));
    EXPECT_THAT(cuts("other"), ElementsAre("the first frame", nullptr, "prev_view is not the view before",
                                           "the radius has changed"));
    for (const char* name : {".json", "_depth.pfm", "_normal.pfm", "_motion.pfm", "_previous_depth.pfm"})
        fs::remove(fs::path(folder) / (std::string("f0001") + name));
    expect_success(render("gap", "--gbuffer {} --radius 0.4", folder));
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
    expect_success(render("out", "--gbuffer {}", folder));
    EXPECT_THAT(cuts("out"), ElementsAre("the first frame", "there is no prev_view", "there is no prev_view",
                                         "there is no prev_view"));
    expect_success(render("alone", "moving --frame 24"));
    EXPECT_EQ(picture("out", "f0003_ao.pfm"), picture("alone", "f0000_ao.pfm"));
}

TEST_F(RenderSequence, TruthOfTheLastFrameOrOfEach) {
    expect_success(render("last", "moving --frame 20 --frames 3 --truth --truth-rays 32"));
    expect_success(render("every", "moving --frame 20 --frames 3 --truth --truth-rays 32 --truth-every"));
    const json last = report("last").at("frames");
    const json each = report("every").at("frames");
    EXPECT_FALSE(last[1].contains("errors"));
    EXPECT_EQ(last[2].at("errors"), each[2].at("errors"));
    EXPECT_TRUE(last[2].at("errors").contains("filtered_by_class"));
    EXPECT_TRUE(each[0].contains("errors") && each[1].contains("errors"));
    EXPECT_EQ(picture("last", "truth.pfm"), picture("every", "f0002_truth.pfm"));
    EXPECT_NE(picture("every", "f0001_truth.pfm"), picture("every", "f0002_truth.pfm"));
}

// What is set by name is what was used, and what is listed is what can be set.
TEST_F(RenderSequence, SettingsByName) {
    const json settings = json::parse(output_of(gloam("list settings --json"))).at("settings");
    expect_success(render("plain", "corner --radius 1"));
    const json used = report("plain").at("settings");
    EXPECT_GT(used.size(), 10U);  // those that the frame reads
    for (const json& setting : settings) {
        for (const char* key : {"description", "unit", "expected"}) EXPECT_TRUE(setting.at(key).is_string());
        const json name = setting.at("name");
        EXPECT_EQ(used.contains(name), setting.at("default_of") == "balanced") << setting;
        if (used.contains(name)) {
            EXPECT_EQ(used.at(name), setting.at("default")) << setting;
        }
    }
    expect_success(render("out",
                          "corner --method hemisphere --set samples=7 --set taps=nearest --set filter=off "
                          "--samples 9 --set guard=0.25"));
    const json changed = report("out").at("settings");
    EXPECT_EQ(changed.at("samples"), 7);
    EXPECT_EQ(changed.at("taps"), "nearest");
    EXPECT_EQ(changed.at("filter"), "none");
    EXPECT_EQ(report("out").at("frames").at(0).at("samples"), 7);
}

TEST_F(RenderSequence, EachFrameHasALitPicture) {
    expect_success(render("out", "moving --frame 20 --frames 4"));
    std::set<std::string> pictures;
    for (const char* name : {"f0000", "f0001", "f0002", "f0003"})
        for (const char* kind : {"_plain.png", "_shaded.png"})
            pictures.insert(read_file(path("out") / (std::string(name) + kind)));
    EXPECT_EQ(pictures.size(), 8U);
    expect_success(render("two", "moving --frame 20 --frames 4 --preset fast,balanced"));
    EXPECT_TRUE(fs::exists(path("two") / "fast_f0003_shaded.png"));
    EXPECT_FALSE(fs::exists(path("two") / "fast_f0002_shaded.png")) << "of several runs the last frame alone";
}

TEST_F(RenderSequence, OptionsThatDoNotGoTogether) {
    const std::string folder = sequence();
    expect_could_not_run(render("out", "--gbuffer {} --still", folder), "--still");
    expect_could_not_run(render("out", "--gbuffer {} --frames 9", folder), "--frames 9");
    EXPECT_FALSE(fs::exists(path("out")));
}

}  // namespace gloam::test::render_sequence_test
