// SPDX-License-Identifier: MIT
// Errors of `gloam render` for invalid input: one line, status 2, and nothing left in --out.
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tools/expect.hpp"

namespace gloam::test {
namespace render_errors_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

class RenderErrors : public testing::Test {
  protected:
    [[nodiscard]] fs::path file(const std::string& name) const { return scratch_.path() / name; }
    [[nodiscard]] fs::path out() const { return file("out"); }

    fs::path write(const std::string& name, const std::string& text) const {
        std::ofstream(file(name), std::ios::binary) << text;
        return file(name);
    }

    [[nodiscard]] CommandResult render(std::vector<std::string> arguments,
                                       std::vector<std::string> environment = {}) const {
        arguments.insert(arguments.begin(), "render");
        arguments.insert(arguments.end(), {"--out", out().string()});
        return run_command(arguments, {.environment = std::move(environment)});
    }

    void expect_refused(const std::vector<std::string>& arguments, const std::string& named) const {
        expect_could_not_run(render(arguments), named);
        EXPECT_FALSE(fs::exists(out())) << named;
    }

    // A G-buffer of one small frame, as gloam writes it.
    [[nodiscard]] fs::path gbuffer() const {
        const fs::path folder = file("gbuffer");
        expect_success(run_command({"render", "corner", "--size", "16x9", "--samples", "1", "--write-gbuffer",
                                    folder.string(), "--out", file("first").string()}));
        return folder;
    }

  private:
    TemporaryDirectory scratch_;
};

TEST_F(RenderErrors, Names) {
    expect_refused({"no-such-scene"}, "no-such-scene");
    EXPECT_THAT(render({"no-such-scene"}).err, HasSubstr("corner"));
    expect_refused({"corner", "--method", "no-such-method"}, "no-such-method");
    expect_refused({"corner", "--preset", "no-such-preset"}, "no-such-preset");
    expect_refused({"corner", "--device", "no-such-device"}, "no-such-device");
    expect_refused({"corner", "--no-such-option"}, "--no-such-option");
    expect_refused({}, "corner");
}

TEST_F(RenderErrors, Numbers) {
    for (const char* size : {"0x0", "99999x99999", "16", "-1x5", "16x9x3", "16x"}) {
        expect_refused({"corner", "--size", size}, size);
    }
    expect_refused({"corner", "--size", "16x9", "--radius", "0"}, "0");
    expect_refused({"corner", "--size", "16x9", "--radius", "nan"}, "radius");
    expect_refused({"corner", "--size", "16x9", "--bias", "-1"}, "-1");
    expect_refused({"corner", "--samples", "0"}, "--samples");
    for (const char* guard : {"-0.1", "0.6", "nan"})
        expect_refused({"corner", "--size", "16x9", "--guard", guard}, "guard");
    expect_refused({"corner", "--frames", "0"}, "--frames");
}

TEST_F(RenderErrors, Settings) {
    expect_refused({"corner", "--set", "samples"}, "NAME=VALUE");
    expect_refused({"corner", "--set", "no_such=1"}, "no_such");
    expect_refused({"corner", "--set", "samples=0"}, "samples 0: expected a whole number, 1 to 2048");
    expect_refused({"corner", "--set", "taps=all"}, "nearest, bilinear or validated");
    expect_refused({"corner", "--set", "guard=1"}, "guard 1: expected 0 to 0.5");
    expect_refused({"corner", "--set", "radius=1"}, "--radius");
    expect_refused({"corner", "--set", "method=disc"}, "--method");
    expect_refused({"corner", "--set", "precision=float16"}, "at most 2048");
}

TEST_F(RenderErrors, Meshes) {
    expect_refused({write("empty.obj", "").string()}, "empty.obj");
    expect_refused({write("nonsense.obj", "this is no mesh\n").string()}, "nonsense.obj");
    expect_refused({write("nan.obj", "v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n").string()}, "nan.obj");
    expect_refused({file("missing.obj").string()}, "missing.obj");
    if (geteuid() == 0) return;  // root reads everything
    const fs::path secret = write("secret.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    fs::permissions(secret, fs::perms::none);
    expect_refused({secret.string()}, "secret.obj");
}

TEST_F(RenderErrors, GBuffers) {
    expect_refused({"--gbuffer", file("missing").string()}, "missing");
    const fs::path folder = gbuffer();
    expect_refused({"corner", "--gbuffer", folder.string()}, "--gbuffer");
    expect_refused({"--gbuffer", folder.string(), "--guard", "0.1"}, "no guard band");

    const fs::path depth = folder / "f0000_depth.pfm";
    const auto whole = fs::file_size(depth);
    fs::resize_file(depth, whole - 4);
    expect_refused({"--gbuffer", folder.string()}, "f0000_depth.pfm");
    fs::remove(depth);
    expect_refused({"--gbuffer", folder.string()}, "f0000_depth");
    write("gbuffer/f0000_depth.pfm", "Pf\n1 1\n-1.0\n" + std::string(4, '\0'));
    expect_refused({"--gbuffer", folder.string()}, "f0000_depth.pfm");
}

TEST_F(RenderErrors, Truth) {
    const fs::path small = write("small.pfm", "Pf\n1 1\n-1.0\n" + std::string(4, '\0'));
    expect_refused({"corner", "--size", "16x9", "--truth", small.string()}, "small.pfm");
    expect_refused({"corner", "--size", "16x9", "--truth", file("missing.pfm").string()}, "missing.pfm");
}

TEST_F(RenderErrors, OutputThatCannotBeWritten) {
    const fs::path in_the_way = write("in_the_way", "");
    expect_could_not_run(run_command({"render", "corner", "--out", in_the_way.string()}), "in_the_way");
    expect_could_not_run(run_command({"render", "corner", "--out", "/proc/gloam"}), "/proc/gloam");
}

TEST_F(RenderErrors, AFullDiskLeavesNothing) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the sanitizer wants to be the first library of a program";
#endif
    fs::create_directory(out());
    const CommandResult result =
        render({"corner", "--size", "16x9", "--frames", "2"}, {"LD_PRELOAD=" GLOAM_FULL_DISK});
    expect_could_not_run(result, "_ao.pfm");
    EXPECT_THAT(result.err, HasSubstr("No space left on device"));
    EXPECT_TRUE(fs::is_empty(out()));
}

TEST_F(RenderErrors, TheSameGBufferGivesTheSamePictures) {
    const fs::path folder = gbuffer();
    expect_success(render({"--gbuffer", folder.string(), "--samples", "1"}));
    const auto bytes = [](const fs::path& path) {
        std::ifstream stream(path, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(stream), {});
    };
    EXPECT_EQ(bytes(out() / "f0000_ao.pfm"), bytes(file("first") / "f0000_ao.pfm"));
    const auto json = nlohmann::json::parse(bytes(out() / "render.json"));
    EXPECT_EQ(json.at("frames").size(), 1U);
    EXPECT_EQ(json.at("frames")[0].at("pixels"), 16 * 9);
}

}  // namespace render_errors_test
}  // namespace gloam::test
