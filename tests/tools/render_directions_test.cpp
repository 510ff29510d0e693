// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tools/expect.hpp"
#include "tools/installation.hpp"

namespace gloam::test {
namespace render_directions_test {

namespace fs = std::filesystem;

CommandResult render(const fs::path& out, std::vector<std::string> more) {
    std::vector<std::string> arguments{"render", "corner", "--size", "40x24", "--out", out.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_command(arguments);
}

TEST(RenderDirections, BentNormalsAndLightAreFiles) {
    const TemporaryDirectory folder;
    const fs::path out = folder.path() / "out";
    expect_success(render(out, {"--bent-normals", "--light", "sky"}));
    for (const char* name : {"bent.pfm", "bent.png", "cone.pfm", "light.pfm", "light.png", "bounce.pfm"})
        EXPECT_GT(fs::file_size(out / (std::string("f0000_") + name)), 100U) << name;
}

TEST(RenderDirections, InterleavedBentNormals) {
    const TemporaryDirectory folder;
    const fs::path out = folder.path() / "out";
    expect_success(render(out, {"--bent-normals", "--bent-interleave", "4"}));
    EXPECT_GT(fs::file_size(out / "f0000_bent.pfm"), 100U);
    EXPECT_EQ(render(out, {"--bent-normals", "--bent-interleave", "9"}).status, 2);
    EXPECT_EQ(render(out, {"--bent-interleave", "4"}).status, 2);
}

// Other cameras see the sides that this one sees edge-on.
TEST(RenderDirections, FurtherViewsRaiseTheOcclusion) {
    const TemporaryDirectory folder;
    const fs::path out = folder.path() / "out";
    const CommandResult result =
        run_command({"render", "knot", "--size", "64x36", "--method", "gtao", "--frames", "1",
                     "--further-views", "4", "--truth", "--truth-rays", "64", "--out", out.string()});
    expect_success(result);
    EXPECT_GT(fs::file_size(out / "f0000_views.pfm"), 100U);
    EXPECT_GT(fs::file_size(out / "f0000_views.png"), 100U);
    EXPECT_THAT(result.out, testing::HasSubstr("by further views"));
    const auto errors = nlohmann::json::parse(read_file(out / "render.json")).at("frames").at(0).at("errors");
    EXPECT_GT(errors.at("further_views").at("bias"), errors.at("raw").at("bias"));
    EXPECT_EQ(render(out, {"--further-views", "7"}).status, 2);
    expect_could_not_run(render(out, {"--further-views", "1", "--method", "mssao"}), "mssao");
}

TEST(RenderDirections, NothingIsWrittenThatWasNotAskedFor) {
    const TemporaryDirectory folder;
    const fs::path out = folder.path() / "out";
    expect_success(render(out, {}));
    EXPECT_FALSE(fs::exists(out / "f0000_bent.pfm"));
    EXPECT_FALSE(fs::exists(out / "f0000_light.pfm"));
}

TEST(RenderDirections, AnEnvironmentFromAFile) {
    const TemporaryDirectory folder;
    const fs::path file = folder.path() / "half.pfm";
    std::ofstream(file, std::ios::binary) << "PF\n1 1\n-1.0\n"
                                          << std::string("\0\0\0\x3f\0\0\0\x3f\0\0\0\x3f", 12);
    expect_success(render(folder.path() / "out", {"--light", file.string()}));
}

TEST(RenderDirections, BadEnvironmentsAreNamed) {
    const TemporaryDirectory folder;
    const fs::path out = folder.path() / "out";
    expect_could_not_run(render(out, {"--light", "/no/such.exr"}), "/no/such.exr");
    expect_could_not_run(render(out, {"--light", "noon"}), "noon");
    const fs::path grey = folder.path() / "grey.pfm";
    std::ofstream(grey, std::ios::binary) << "Pf\n1 1\n-1.0\n" << std::string(4, '\0');
    expect_could_not_run(render(out, {"--light", grey.string()}), "grey.pfm");
    EXPECT_FALSE(fs::exists(out));
}

TEST(RenderDirections, LayersThatAFolderDoesNotHaveAreNamed) {
    const TemporaryDirectory folder;
    const fs::path views = folder.path() / "views";
    expect_success(render(folder.path() / "out", {"--write-gbuffer", views.string(), "--set", "layers=3"}));
    EXPECT_TRUE(fs::exists(views / "f0000_layer2.pfm"));
    const auto again = [&](const char* layers) {
        return run_command({"render", "--gbuffer", views.string(), "--out", (folder.path() / "b").string(),
                            "--set", std::string("layers=") + layers});
    };
    expect_success(again("3"));
    expect_could_not_run(again("4"), "layers 4: the view has 3");
}

}  // namespace render_directions_test
}  // namespace gloam::test
