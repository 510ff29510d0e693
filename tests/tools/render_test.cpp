// SPDX-License-Identifier: MIT
// `gloam render`: errors for invalid input, the truth, directions and light.
#include <unistd.h>

#include "tools/rendering.hpp"

namespace gloam::test::render_test {

class RenderErrors : public Rendering {
  protected:
    // A G-buffer of one small frame, as gloam writes it.
    [[nodiscard]] fs::path gbuffer() const {
        expect_success(render("first", "corner --size 16x9 --samples 1 --write-gbuffer {}", path("gbuffer")));
        return path("gbuffer");
    }
};

TEST_F(RenderErrors, Meshes) {
    if (geteuid() == 0) return;  // root reads everything
    const fs::path secret = write("secret.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    fs::permissions(secret, fs::perms::none);
    expect_refused(words("{}", secret), "secret.obj");
}

TEST_F(RenderErrors, GBuffers) {
    const fs::path folder = gbuffer();
    expect_refused(words("corner --gbuffer {}", folder), "--gbuffer");
    expect_refused(words("--gbuffer {} --guard 0.1", folder), "no guard band");

    expect_refused(words("--gbuffer {} --depth buffer", folder), "from 0 to 1");
    expect_refused(words("--gbuffer {} --normals view-unorm", folder), "another length");
    expect_refused(words("--gbuffer {} --radius 1e6", folder), "radius 1e+06");
    expect_refused(words("--gbuffer {} --radius 1e-6", folder), "below a pixel");

    const fs::path depth = folder / "f0000_depth.pfm";
    const auto whole = fs::file_size(depth);
    fs::resize_file(depth, whole - 4);
    expect_refused(words("--gbuffer {}", folder), "f0000_depth.pfm");
    write("gbuffer/f0000_depth.pfm", "Pf\n16 9\n-1.0\n" + std::string(std::size_t{4} * 16 * 9, '\0'));
    expect_refused(words("--gbuffer {}", folder), "no geometry");
    fs::remove(depth);
    expect_refused(words("--gbuffer {}", folder), "f0000_depth");
    write("gbuffer/f0000_depth.pfm", "Pf\n1 1\n-1.0\n" + std::string(4, '\0'));
    expect_refused(words("--gbuffer {}", folder), "f0000_depth.pfm");
}

TEST_F(RenderErrors, AFullDiskLeavesNothing) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the sanitizer wants to be the first library of a program";
#endif
    fs::create_directory(path("out"));
    const CommandResult result =
        render("out", words("corner --size 16x9 --frames 2"), {"LD_PRELOAD=" GLOAM_FULL_DISK});
    expect_could_not_run(result, "_ao.pfm");
    EXPECT_THAT(result.err, HasSubstr("No space left on device"));
    EXPECT_TRUE(fs::is_empty(path("out")));
}

TEST_F(RenderErrors, TheSameGBufferGivesTheSamePictures) {
    const fs::path folder = gbuffer();
    expect_success(render("out", "--gbuffer {} --samples 1", folder));
    EXPECT_EQ(read_file(path("out") / "f0000_ao.pfm"), read_file(path("first") / "f0000_ao.pfm"));
    EXPECT_EQ(report("out").at("frames").size(), 1U);
    EXPECT_EQ(report("out").at("frames")[0].at("width"), 16);
}

// The traced truth, the metrics against it, and the messages for invalid options.
class RenderTruth : public Rendering {
  protected:
    RenderTruth() {
        always_ = words("--size 48x27");
        environment_ = {"GLOAM_CACHE_DIR=" + path("cache").string()};  // of its own
    }
};

TEST_F(RenderTruth, IsTracedAndComparedWith) {
    expect_success(render("out", "corner --truth --truth-rays 64 --frames 2"));
    for (const char* name : {"truth.png", "truth.pfm", "truth_depth.png", "truth_depth.pfm",
                             "truth_error.pfm", "f0001_error.png"})
        EXPECT_TRUE(fs::is_regular_file(path("out") / name)) << name;
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
    for (const char* out : {"first", "second"})
        expect_success(render(out, "moving --frame 3 --truth --truth-rays 32"));
    const fs::path image = path("first") / "truth.pfm";
    expect_success(render("third", "moving --frame 3 --truth {}", image));
    const json errors = report("first").at("frames").at(0).at("errors");
    EXPECT_EQ(report("second").at("frames").at(0).at("errors"), errors);
    EXPECT_EQ(report("third").at("frames").at(0).at("errors").at("filtered"), errors.at("filtered"));
    EXPECT_EQ(picture("second", "truth.pfm"), picture("first", "truth.pfm"));
    EXPECT_TRUE(fs::is_directory(path("cache") / "truth"));
}

TEST_F(RenderTruth, OfAnotherFrameIsAnother) {
    expect_success(render("first", "moving --truth --truth-rays 32"));
    expect_success(render("second", "moving --frame 40 --truth --truth-rays 32"));
    EXPECT_NE(picture("first", "truth.pfm"), picture("second", "truth.pfm"));
}

// Of an engine's buffers only the depth is known.
TEST_F(RenderTruth, OfAGBufferIsThatOfItsDepth) {
    const fs::path folder = path("gbuffer");
    expect_success(render("first", "knot --truth --truth-rays 32 --write-gbuffer {}", folder));
    expect_success(render("second", "--gbuffer {} --truth --truth-rays 32", folder));
    EXPECT_EQ(picture("second", "truth.pfm"), picture("first", "truth_depth.pfm"));
    EXPECT_EQ(report("second").at("truth"), "traced depth buffer");
}

TEST_F(RenderTruth, WithoutGeometryInViewIsNotToBeHad) {
    const fs::path folder = path("gbuffer");
    expect_success(render("first", "sky --write-gbuffer {}", folder));
    write("gbuffer/f0000_depth.pfm", "Pf\n48 27\n-1.0\n" + std::string(std::size_t{4} * 48 * 27, '\0'));
    expect_refused(words("--gbuffer {} --truth", folder), "no geometry");
}

// Directions and light.
class RenderDirections : public Rendering {
  protected:
    [[nodiscard]] CommandResult corner(const std::vector<std::string>& more) const {
        std::vector<std::string> all = words("corner --size 40x24");
        all.insert(all.end(), more.begin(), more.end());
        return render("out", all);
    }

    [[nodiscard]] std::uintmax_t bytes_of(const std::string& name) const {
        return fs::file_size(path("out") / ("f0000_" + name));
    }
};

TEST_F(RenderDirections, BentNormalsAndLightAreFilesWhereAskedFor) {
    expect_success(corner({}));
    for (const char* name : {"f0000_bent.pfm", "f0000_light.pfm"})
        EXPECT_FALSE(fs::exists(path("out") / name));
    expect_success(corner(words("--bent-normals --bent-interleave 4")));
    EXPECT_GT(bytes_of("bent.pfm"), 100U);
    expect_success(corner(words("--bent-normals --light sky")));
    for (const char* name : {"bent.pfm", "bent.png", "cone.pfm", "light.pfm", "light.png", "bounce.pfm"})
        EXPECT_GT(bytes_of(name), 100U) << name;
}

TEST_F(RenderDirections, LayersThatAFolderDoesNotHaveAreNamed) {
    const fs::path views = path("views");
    expect_success(corner(words("--write-gbuffer {} --method hemisphere --set layers=3", views)));
    EXPECT_TRUE(fs::exists(views / "f0000_layer2.pfm"));
    expect_success(render("b", "--gbuffer {} --method hemisphere --set layers=3", views));
    expect_could_not_run(render("b", "--gbuffer {} --method hemisphere --set layers=4", views),
                         "layers 4: the view has 3");
}

}  // namespace gloam::test::render_test
