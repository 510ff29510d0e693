// SPDX-License-Identifier: MIT
// `gloam render --truth`: the traced truth, the metrics against it, and the messages for invalid options.
#include <fstream>
#include <nlohmann/json.hpp>

#include "scene/image_files.hpp"
#include "tools/expect.hpp"

namespace gloam::test {
namespace render_truth_test {

namespace fs = std::filesystem;
using nlohmann::json;

class RenderTruth : public testing::Test {
  protected:
    [[nodiscard]] fs::path file(const std::string& name) const { return scratch_.path() / name; }

    // 48 x 27 pixels into a folder of that name, with a cache of its own.
    [[nodiscard]] CommandResult render(const std::string& out, std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "render");
        arguments.insert(arguments.end(), {"--size", "48x27", "--out", file(out).string()});
        return run_command(arguments, {.environment = {"GLOAM_CACHE_DIR=" + file("cache").string()}});
    }

    [[nodiscard]] json report(const std::string& out) const {
        std::ifstream stream(file(out) / "render.json");
        return json::parse(stream);
    }

    void expect_refused(const std::vector<std::string>& arguments, const std::string& named) const {
        expect_could_not_run(render("out", arguments), named);
        EXPECT_FALSE(fs::exists(file("out"))) << named;
    }

  private:
    TemporaryDirectory scratch_;
};

TEST_F(RenderTruth, IsTracedAndComparedWith) {
    expect_success(render("out", {"corner", "--truth", "--truth-rays", "64", "--frames", "2"}));
    for (const char* name : {"truth.png", "truth.pfm", "truth_depth.png", "truth_depth.pfm",
                             "truth_error.pfm", "f0001_error.png"})
        EXPECT_TRUE(fs::is_regular_file(file("out") / name)) << name;
    const json frame = report("out").at("frames").at(1);
    EXPECT_EQ(frame.at("truth").at("rays"), 64);
    EXPECT_EQ(frame.at("truth").at("pixels"), 48 * 27);
    EXPECT_LT(frame.at("truth").at("standard_error"), 0.02);
    EXPECT_GT(frame.at("truth").at("standard_error"), 0.0);
    EXPECT_GT(frame.at("flicker"), 0.0);
    const json errors = frame.at("errors");
    EXPECT_EQ(errors.at("compared"), 48 * 27);
    EXPECT_LT(errors.at("filtered").at("rmse"), 0.15);
    EXPECT_LE(errors.at("filtered_metrics").at("remapped").at("rmse"), errors.at("filtered").at("rmse"));
    EXPECT_GT(errors.at("filtered_metrics").at("ssim"), 0.3);
    EXPECT_TRUE(errors.contains("filtered_against_depth"));
    EXPECT_TRUE(report("out").at("frames").at(0).at("errors").contains("raw"));
}

// The image that was traced, given back as a file, gives the same errors; so does what the cache kept.
TEST_F(RenderTruth, FromAFileAndFromTheCacheIsTheSame) {
    const std::vector<std::string> traced{"moving", "--frame", "3", "--truth", "--truth-rays", "32"};
    expect_success(render("first", traced));
    expect_success(render("second", traced));
    const std::string image = (file("first") / "truth.pfm").string();
    expect_success(render("third", {"moving", "--frame", "3", "--truth", image}));
    const json errors = report("first").at("frames").at(0).at("errors");
    EXPECT_EQ(report("second").at("frames").at(0).at("errors"), errors);
    EXPECT_EQ(report("third").at("frames").at(0).at("errors").at("filtered"), errors.at("filtered"));
    EXPECT_EQ(scene::read_pfm(file("second") / "truth.pfm").texels, scene::read_pfm(image).texels);
    EXPECT_TRUE(fs::is_directory(file("cache") / "truth"));
}

TEST_F(RenderTruth, OfAnotherFrameIsAnother) {
    expect_success(render("first", {"moving", "--truth", "--truth-rays", "32"}));
    expect_success(render("second", {"moving", "--frame", "40", "--truth", "--truth-rays", "32"}));
    EXPECT_NE(scene::read_pfm(file("first") / "truth.pfm").texels,
              scene::read_pfm(file("second") / "truth.pfm").texels);
}

// Of an engine's buffers only the depth is known.
TEST_F(RenderTruth, OfAGBufferIsThatOfItsDepth) {
    const std::string folder = file("gbuffer").string();
    expect_success(render("first", {"knot", "--truth", "--truth-rays", "32", "--write-gbuffer", folder}));
    expect_success(render("second", {"--gbuffer", folder, "--truth", "--truth-rays", "32"}));
    EXPECT_EQ(scene::read_pfm(file("second") / "truth.pfm").texels,
              scene::read_pfm(file("first") / "truth_depth.pfm").texels);
    EXPECT_EQ(report("second").at("truth"), "traced depth buffer");
}

TEST_F(RenderTruth, WithoutGeometryInViewIsNotToBeHad) {
    const std::string folder = file("gbuffer").string();
    expect_success(render("first", {"sky", "--write-gbuffer", folder}));
    std::ofstream(fs::path(folder) / "f0000_depth.pfm", std::ios::binary)
        << "Pf\n48 27\n-1.0\n"
        << std::string(std::size_t{4} * 48 * 27, '\0');
    expect_refused({"--gbuffer", folder, "--truth"}, "no geometry");
}

TEST_F(RenderTruth, OptionsThatCannotBe) {
    expect_refused({"corner", "--truth", "--truth-rays", "0"}, "0 rays");
    expect_refused({"corner", "--truth", "--truth-falloff", "cubic"}, "cubic");
    expect_refused({"corner", "--truth", "--truth-thickness", "0"}, "--truth-thickness");
    expect_refused({"corner", "--frame", "-1"}, "--frame");
    expect_refused({"--gbuffer", file("none").string(), "--frame", "2"}, "--frame");
}

TEST_F(RenderTruth, EveryBuiltInSceneIsListed) {
    const CommandResult list = run_command({"list", "scenes"});
    expect_success(list);
    for (const char* scene : {"columns", "corner", "far", "grass", "knot", "moving", "room", "sky"})
        EXPECT_THAT(list.out, testing::HasSubstr(scene));
}

}  // namespace render_truth_test
}  // namespace gloam::test
