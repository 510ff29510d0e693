// SPDX-License-Identifier: MIT
// What `gloam pack --effect` writes, as its reader takes it: compiled by glslang's own program, the header by
// a C compiler.
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "tools/expect.hpp"

namespace gloam::test {
namespace pack_effect_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

std::string read(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

class PackEffect : public testing::Test {
  protected:
    void pack(std::vector<std::string> options) {
        fs::remove_all(out());
        options.insert(options.begin(), {"pack", "--effect", "--out", out().string()});
        expect_success(run_command(options));
    }

    [[nodiscard]] fs::path out() const { return folder_.path() / "effect"; }
    [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(read(out() / "effect.json")); }

    // Every pass by glslangValidator, the header as C and as C++.
    void expect_compiles() const {
        for (const auto& entry : fs::directory_iterator(out())) {
            const std::string file = entry.path().string();
            if (entry.path().extension() == ".comp") {
                const CommandResult result =
                    run_program("/usr/bin/glslangValidator", {"-V", "--target-env", "vulkan1.2", file, "-o",
                                                              (folder_.path() / "module.spv").string()});
                EXPECT_EQ(result.status, 0) << file << "\n" << result.out;
                EXPECT_THAT(read(entry.path()), Not(HasSubstr("#include")));
            } else if (entry.path().extension() == ".h") {
                for (const std::vector<std::string>& language :
                     {std::vector<std::string>{"-xc", "-std=c11"}, {"-xc++", "-std=c++20"}}) {
                    std::vector<std::string> arguments = language;
                    arguments.insert(arguments.end(),
                                     {"-Wall", "-Wextra", "-Werror", "-Wno-unused", "-fsyntax-only", file});
                    const CommandResult result = run_program("/usr/bin/c++", arguments);
                    EXPECT_EQ(result.status, 0) << result.err;
                }
            }
        }
    }

  private:
    TemporaryDirectory folder_;
};

nlohmann::json named(const nlohmann::json& list, const std::string& name) {
    for (const nlohmann::json& each : list)
        if (each["name"] == name) return each;
    ADD_FAILURE() << "no " << name;
    return {};
}

// One of each kind: with and without a table of samples, with and without preparation.
TEST_F(PackEffect, EveryKindOfMethodIsWholeAndCompiles) {
    for (const char* method : {"hemisphere", "gtao", "dual_resolution", "mssao", "sao_chain", "separable"}) {
        SCOPED_TRACE(method);
        pack({"--method", method, "--preset", "paper", "--size", "640x360"});
        expect_compiles();
    }
}

// The passes in another language stand beside those in GLSL.
TEST_F(PackEffect, AnotherLanguageBesideGlsl) {
    for (const auto& [target, suffix, first] :
         {std::tuple("hlsl", ".hlsl", "// Registers: b0 Parameters"),
          std::tuple("msl", ".metal", "// Indices: buffer(4) tile_states"),
          std::tuple("wgsl", ".wgsl", "@group(0) @binding(0) var depth_image: texture_2d<f32>;")}) {
        SCOPED_TRACE(target);
        pack({"--target", target});
        for (const nlohmann::json& pass : json()["passes"]) {
            const std::string name = pass["name"];
            EXPECT_TRUE(fs::exists(out() / (name + ".comp"))) << name;
            EXPECT_THAT(read(out() / (name + suffix)),
                        HasSubstr(name == "ambient_occlusion" ? first : "main("))
                << name;
        }
        const std::string last = json()["passes"].back()["name"];
        EXPECT_THAT(read(out() / "README.md"), HasSubstr("as `" + last + suffix + "`"));
    }
}

// With whatever else there is in the passes.
TEST_F(PackEffect, EveryOptionCompiles) {
    for (const std::vector<std::string>& options :
         {std::vector<std::string>{"--tiles", "--preset", "moving"},
          {"--moving-objects", "--orthographic", "--reconstruct-normals"},
          {"--set", "layers=3", "--set", "remap_b=2", "--preset", "sao-quality"},
          {"--set", "remap_b=2", "--tiles", "--set", "precision=float16", "--set", "table_size=2048"},
          {"--set", "resolution=half", "--moving-objects", "--set", "layers=2", "--depth", "buffer"},
          {"--set", "resolution=half", "--orthographic", "--reconstruct-normals", "--preset", "moving",
           "--tiles"}}) {
        pack(options);
        expect_compiles();
    }
}

// "balanced" holds its history packed: so say the shaders, the header and the tables.
TEST_F(PackEffect, FormatsAreThoseOfThePreset) {
    pack({"--preset", "balanced"});
    EXPECT_THAT(read(out() / "ambient_occlusion.comp"), HasSubstr("#define GLOAM_HISTORY rgba16ui\n"));
    EXPECT_EQ(named(json()["images"], "history_after")["format"], "VK_FORMAT_R16G16B16A16_UINT");
    EXPECT_THAT(read(out() / "gloam_effect.h"),
                HasSubstr("{\"history_after\", VK_FORMAT_R16G16B16A16_UINT,"));
    const nlohmann::json all = json();
    for (const nlohmann::json& pass : all.at("passes")) {
        for (const nlohmann::json& binding : pass.at("bindings")) {
            if (!binding["resource"].get<std::string>().starts_with("history")) continue;
            if (binding["writes"])
                EXPECT_EQ(binding["format"], "rgba16ui") << pass["name"];
            else
                EXPECT_EQ(binding["type"], "VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER") << pass["name"];
        }
    }
    pack({"--preset", "paper"});
    EXPECT_EQ(named(json()["images"], "history_after")["format"], "VK_FORMAT_R32G32B32A32_SFLOAT");
}

// Each binding is to a resource that is listed, each image is used, and what one pass writes and another
// reads has a barrier.
TEST_F(PackEffect, TheTablesAgree) {
    for (const char* method : {"hemisphere", "mssao", "separable"}) {
        pack({"--method", method, "--preset", "moving", "--tiles"});
        const nlohmann::json all = json();
        std::set<std::string> resources;
        for (const char* kind : {"images", "buffers"})
            for (const nlohmann::json& each : all[kind]) EXPECT_TRUE(resources.insert(each["name"]).second);
        std::set<std::string> bound{all["result"]["image"]};
        std::set<std::string> written;
        for (const nlohmann::json& pass : all["passes"]) {
            std::set<std::string> guarded;
            for (const nlohmann::json& barrier : pass["barriers"]) guarded.insert(barrier["resource"]);
            for (const nlohmann::json& binding : pass["bindings"]) {
                const std::string name = binding["resource"];
                bound.insert(name);
                EXPECT_TRUE(!written.contains(name) || guarded.contains(name)) << pass["name"] << " " << name;
            }
            for (const nlohmann::json& binding : pass["bindings"]) {
                const std::string name = binding["resource"];
                if (binding["writes"] && !name.starts_with("nothing") && pass["turn"] != "once")
                    written.insert(name);
            }
        }
        EXPECT_EQ(bound, resources) << method;
    }
}

// mssao cannot do without its preparation passes: they are there, in their order, before the samples.
TEST_F(PackEffect, PreparationComesWithTheMethod) {
    pack({"--method", "mssao"});
    const std::string page = read(out() / "README.md");
    EXPECT_LT(page.find("`surface_1.comp`"), page.find("`occlusion_4.comp`"));
    EXPECT_LT(page.find("`occlusion_1.comp`"), page.find("`ambient_occlusion.comp`"));
    EXPECT_TRUE(fs::exists(out() / "occlusion_1.comp"));
    EXPECT_FALSE(named(json()["images"], "prepared").is_null());
}

// tests/effect/opengl_passes_test.cpp compiles them with a driver.
TEST_F(PackEffect, PassesInES) {
    pack({"--version", "310es", "--tiles", "--preset", "moving"});
    const std::string shader = read(out() / "reproject.comp");
    EXPECT_THAT(shader, testing::StartsWith("#version 310 es\n"));
    EXPECT_THAT(shader, HasSubstr("layout(binding = 0, std140) uniform Parameters {"));
    EXPECT_THAT(shader, HasSubstr("const bool listed = true;"));
    EXPECT_THAT(shader, Not(HasSubstr("constant_id")));
    EXPECT_THAT(read(out() / "README.md"), HasSubstr("GLSL ES file"));
}

TEST_F(PackEffect, SettingsStandAtTheHead) {
    pack({"--preset", "crytek-quality", "--radius", "0.25", "--set", "weight_max=77"});
    const std::string page = read(out() / "README.md");
    EXPECT_LT(page.find("| samples | 200 |"), page.find("## Order of calls"));
    EXPECT_THAT(page, HasSubstr("| weight_max | 77 |"));
    EXPECT_THAT(read(out() / "gloam_effect.h"), HasSubstr("    0.25f,  /* radius */\n"));
    const std::string shader = read(out() / "ambient_occlusion.comp");
    EXPECT_THAT(shader, HasSubstr("const bool keeps_history = false;"));
    // What holds a history comes first, since the types of the bindings are made of it.
    EXPECT_LT(shader.find("uniform Parameters"), shader.find("GloamEstimate gloam_crytek("));
    EXPECT_LT(shader.find("uniform Parameters"), shader.find("vec3 gloam_view_position_perspective("));
}

TEST_F(PackEffect, BadInputLeavesNothing) {
    const auto refused = [&](std::vector<std::string> options, const std::string& named) {
        options.insert(options.begin(), {"pack", "--effect"});
        expect_could_not_run(run_command(options), named);
        EXPECT_FALSE(fs::exists(out()));
    };
    const std::string folder = out().string();
    refused({}, "--out");
    refused({"--out", folder, "--preset", "magic"}, "magic");
    refused({"--out", folder, "--method", "magic"}, "magic");
    refused({"--out", folder, "--size", "0x3"}, "--size 0x3");
    refused({"--out", folder, "--version", "330"}, "--version 330");
    refused({"--out", folder, "--set", "samples=0"}, "samples");
    refused({"--out", "/dev/null/effect"}, "/dev/null");
}

}  // namespace pack_effect_test
}  // namespace gloam::test
