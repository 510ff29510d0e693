// SPDX-License-Identifier: MIT
// `gloam render` on sequences of G-buffers: the history follows them, and dies where it must.
#include "base/image_files.hpp"
#include "tools/gloam.hpp"

namespace gloam::test::render_test {

class Render : public InFolder {
  protected:
    // Those words at a small size, into the folder of that name.
    template <class... Texts>
    void render(const std::string& out, const std::string& line, const Texts&... arguments) const {
        const bool drawn = line.find("--gbuffer ") == std::string::npos;  // an engine's buffers have a size
        expect_success(
            gloam("render " + line + (drawn ? " --size 64x36" : "") + " --out {}", arguments..., path(out)));
    }

    // A folder of four frames of a scene that moves, and what was made of them in "drawn".
    [[nodiscard]] fs::path sequence(const std::string& more = "") const {
        const fs::path folder = path("gbuffer");
        // From frame 20 a sample lies on the border of a pixel, and the rounding of a motion vector decides.
        render("drawn", "moving --frame 21 --frames 4 --write-gbuffer {}" + more, folder);
        return folder;
    }

    void change_json(const std::string& frame, const std::function<void(json&)>& change) const {
        json description = json::parse(read_file(path("gbuffer/" + frame + ".json")));
        change(description);
        write("gbuffer/" + frame + ".json", description.dump());
    }

    [[nodiscard]] json frames(const std::string& out) const {
        return json::parse(read_file(path(out) / "render.json")).at("frames");
    }
    [[nodiscard]] std::vector<json> cuts(const std::string& out) const {
        std::vector<json> reasons;
        for (const json& frame : frames(out)) reasons.push_back(frame.at("history").at("cut"));
        return reasons;
    }

    [[nodiscard]] std::vector<float> picture(const std::string& name) const {
        return base::read_pfm(path(name)).texels;
    }
};

TEST_F(Render, ASequenceThatIsWrittenAndReadBackIsTheSame) {
    for (const char* options : {"", " --guard 0.1"}) {
        const fs::path folder = sequence(options);
        render("read", "--gbuffer {}", folder);
        for (const char* file : {"/f0000_ao.pfm", "/f0003_ao.pfm"}) {
            const std::vector<float> read = picture(std::string("read") + file);
            ASSERT_EQ(read.size(), 64U * 36U);
            EXPECT_THAT(read,
                        testing::Pointwise(testing::FloatNear(1e-5F), picture(std::string("drawn") + file)));
        }
        fs::remove_all(folder);
    }
}

// The left half of the picture, by a camera whose axis is at its right edge. A jitter, here up to half a
// pixel, leaves its place.
TEST_F(Render, AViewportOfACameraOffCentreIsThatPartOfThePicture) {
    const fs::path folder = sequence();
    render("whole", "--gbuffer {} --radius 0.2 --preset tssao-paper", folder);
    for (const auto& [frame, jitter] :
         {std::pair{"f0000", 0.0}, {"f0001", 0.4}, {"f0002", -0.5}, {"f0003", 0.3}}) {
        change_json(frame, [pixels = jitter](json& description) {
            description["viewport"] = {0, 0, 32, 36};
            json& projection = description["camera"]["proj_vk"];
            projection[0] = 2.0 * projection[0].get<double>();
            projection[8] = -1.0 + 2.0 * pixels / 32.0;
        });
    }
    render("part", "--gbuffer {} --radius 0.2 --preset tssao-paper --truth --truth-rays 32", folder);
    EXPECT_EQ(cuts("part"), cuts("whole"));
    const std::vector<float> whole = picture("whole/f0003_ao.pfm");
    const std::vector<float> part = picture("part/f0003_ao.pfm");
    ASSERT_EQ(part.size(), 32U * 36U);
    for (std::size_t y = 0; y < 36; ++y)
        for (std::size_t x = 0; x < 16; ++x) EXPECT_EQ(part[32 * y + x], whole[64 * y + x]) << x << ' ' << y;
    change_json("f0000", [](json& description) { description["camera"]["proj_vk"][8] = 1800.0; });
    expect_could_not_run(gloam("render --gbuffer {} --out {}", folder, path("out")),
                         "with background up to a centred projection");
}

TEST_F(Render, CutsStartAfresh) {
    const fs::path folder = sequence();
    change_json("f0002", [](json& frame) {
        frame["camera"]["prev_view"] = nullptr;
        frame["camera"].erase("previous_from_current");
    });
    render("cut", "--gbuffer {}", folder);
    EXPECT_THAT(cuts("cut"), ElementsAre("the first frame", nullptr, "there is no prev_view", nullptr));
    EXPECT_EQ(frames("cut").at(2).at("history").at("kept"), 0.0);
    EXPECT_FALSE(frames("cut").at(2).contains("flicker"));

    change_json("f0002", [](json& frame) { frame["camera"]["prev_view"] = frame["camera"]["view"]; });
    change_json("f0003", [](json& frame) { frame["ao_radius"] = 0.2; });
    render("other", "--gbuffer {}", folder);
    EXPECT_THAT(cuts("other"), ElementsAre("the first frame", nullptr, "prev_view is not the view before",
                                           "the radius has changed"));
    for (const char* name : {".json", "_depth.pfm", "_normal.pfm", "_motion.pfm", "_previous_depth.pfm"})
        fs::remove(folder / (std::string("f0001") + name));
    render("gap", "--gbuffer {} --radius 0.4", folder);
    EXPECT_EQ(cuts("gap").at(1), "frames are missing before it");
    for (const char* frame : {"f0000", "f0002", "f0003"})
        write("gbuffer/" + std::string(frame) + "_depth.pfm",
              "Pf\n64 36\n-1.0\n" + std::string(std::size_t{4} * 64 * 36, '\0'));
    for (const char* option : {" --frames 1", " --truth"})
        expect_could_not_run(gloam("render --gbuffer {} --out {}" + std::string(option), folder, path("out")),
                             "no geometry");
}

// The list says which settings a frame reads, and the defaults that it has.
TEST_F(Render, SettingsAreAsTheyAreListed) {
    const json settings = json::parse(output_of(gloam("list settings --json"))).at("settings");
    render("plain", "corner --radius 1");
    const json used = json::parse(read_file(path("plain/render.json"))).at("settings");
    EXPECT_GT(used.size(), 10U);  // those that the frame reads
    for (const json& setting : settings) {
        for (const char* key : {"description", "unit", "expected"}) EXPECT_TRUE(setting.at(key).is_string());
        const json name = setting.at("name");
        EXPECT_EQ(used.contains(name), setting.at("default_of") == "balanced") << setting;
        EXPECT_EQ(used.value(name, setting.at("default")), setting.at("default")) << setting;
    }
}

// A unit is a metre, a millimetre or a hundred kilometres: powers of two, so that the pictures are equal to
// the bit.
TEST_F(Render, AMeshOfAnyUnitHasTheSameOcclusion) {
    std::set<std::string> shown;
    for (const std::string unit : {"1", "0.0009765625", "131072", "16777216"}) {
        std::string text;
        for (const std::string& x : {std::string("0"), unit})
            for (const std::string& y : {std::string("0"), unit})
                for (const std::string& z : {std::string("0"), unit})
                    text += "v " + x + " " + y + " " + z + "\n";
        const fs::path box = write("box.obj", text + "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\n");
        render(unit, "{} --fovy 60 --samples 4 --frames 2", box);
        shown.insert(read_file(path(unit) / "f0001_ao.pfm"));
    }
    EXPECT_EQ(shown.size(), 1U);
}

}  // namespace gloam::test::render_test
