// SPDX-License-Identifier: MIT
#include "base/version.hpp"
#include "module/texts.hpp"
#include "tools/gloam.hpp"

namespace gloam::test::pack_test {

// What `gloam pack --effect` writes, as its reader takes it: compiled by glslang's own program, the header by
// a C compiler.

class PackEffect : public InFolder {
  protected:
    void pack(const std::string& preset, std::vector<std::string> options) {
        options.insert(options.begin(),
                       {"pack", "--effect", "--preset", preset, "--out", path(preset).string()});
        expect_success(run_command(options));
    }

    // What a compiler says of a C file, as C99 and as C++.
    [[nodiscard]] std::string compiled(const std::string& text) {
        const std::string file = write("engine.c", text).string();
        std::string errors;
        for (const auto& [language, standard] :
             {std::pair("-xc", "-std=c99"), std::pair("-xc++", "-std=c++20")})
            errors +=
                run_program("/usr/bin/c++", words("-Wall -Wextra -Wpedantic -Werror -fsyntax-only {} {} {}",
                                                  language, standard, file))
                    .err;
        return errors;
    }
};

struct OwnPreset {
    const char* name;
    std::size_t passes, fragment_files;  // the latter with tiles.vert
    std::size_t most_lines;
    bool one_api;
};
constexpr OwnPreset own_presets[] = {{"fast", 3, 3, 425, true},
                                     {"balanced", 3, 3, 425, false},
                                     {"quality", 6, 8, 600, false},
                                     {"reference", 6, 8, 600, true}};

struct Api {
    const char* version;
    const char* name;
    const char* glslang;  // options for SPIR-V; none: the text is only read
    bool fragment = false;
};
constexpr Api apis[] = {{"450", "Vulkan", "-V --target-env vulkan1.2 -o /dev/null"},
                        {"430", "OpenGL 4.3", nullptr},
                        {"330", "OpenGL 3.3", nullptr, true},
                        {"300es", "OpenGL ES 3.0 and WebGL2", nullptr, true}};

// Each preset for one API, and one of each resolution for each.
TEST_F(PackEffect, EachPresetIsShortAndCompilesForEachApi) {
    for (const auto& [preset, passes, fragment_files, most_lines, one_api] : own_presets) {
        for (const Api& api : apis) {
            if (one_api && &api != &apis[0]) continue;
            SCOPED_TRACE(std::string(preset) + " " + api.version);
            pack(preset, words("--version {}", api.version));
            std::vector<std::string> texts;
            for (const auto& entry : fs::directory_iterator(path(preset))) {
                if (entry.path().extension() == ".h") continue;
                texts.push_back(read_file(entry.path()));
                std::vector<std::string> options;
                if (api.glslang != nullptr) options = words(api.glslang);
                options.push_back(entry.path().string());
                const CommandResult result = run_program("/usr/bin/glslangValidator", options);
                EXPECT_EQ(result.status, 0) << result.out;
                EXPECT_THAT(texts.back(), HasSubstr("\n// Packed by gloam " + base::version() + " for " +
                                                    api.name + ".\n"));
                EXPECT_THAT(texts.back(), Not(HasSubstr("#include")));
            }
            EXPECT_EQ(texts.size(), api.fragment ? fragment_files : passes);
            EXPECT_LE(shader::code_lines(texts), most_lines);
            fs::remove_all(path(preset));
        }
    }
}

// All presets' headers in one program, and twice.
TEST_F(PackEffect, TheHeaderIsCAndShort) {
    std::string text;
    for (const OwnPreset& preset : own_presets) {
        pack(preset.name, {});
        const std::string header = read_file(path(preset.name) / "gloam_frame.h");
        EXPECT_LE(shader::code_lines(header), 175U);
        for (int i = 0; i < 2; ++i) text += "#include \"" + std::string(preset.name) + "/gloam_frame.h\"\n";
    }
    text +=
        "gloam_frame next(gloam_settings settings, gloam_camera camera) {\n"
        "    gloam_frame frame;\n"
        "    memset(&frame, 0, sizeof frame);\n"
        "    settings.preset = settings.size[0] > 640 ? gloam_fast : gloam_quality;\n"
        "    gloam_next(&frame, settings, camera, NULL);\n"
        "    gloam_cut(&frame);\n"
        "    return frame;\n}\n";
    EXPECT_EQ(compiled(text), "");
    fs::copy_file(path("fast") / "gloam_frame.h", path("quality") / "gloam_fast.h");
    pack("fast", words("--set history_range=0.5"));
    EXPECT_EQ(compiled(text), "");
    EXPECT_THAT(compiled("#include \"fast/gloam_frame.h\"\n#include \"quality/gloam_fast.h\"\n" + text),
                HasSubstr("gloam_fast"));
}

// Cameras by perspectives and orthographic ones, standard and reversed, off their centre: left-handed ones
// give the parameters of right-handed ones but for the sign of normals, and those written row by row, or of
// the other kind than the pack is for, are errors.
TEST_F(PackEffect, CamerasAreOfEitherHandOrAreErrors) {
    pack("fast", {});
    pack("quality", {"--orthographic"});
    write("cameras.c", read_file(fs::path(GLOAM_TOOLS_FIXTURES) / "cameras.c"));
    expect_success(run_program("/usr/bin/cc", words("-std=c99 -Wall -Wextra -Werror -o {} {} -lm",
                                                    path("cameras"), path("cameras.c"))));
    std::string expected;
    for (int i = 0; i < 5; ++i) expected += "0000 2 1 1 01 12340 0\n";
    EXPECT_EQ(run_program(path("cameras").string(), {}).out, expected);
}

// docs/integration.md: the effect in one pass of SuperTuxKart, and of a material of Filament, whose compilers
// add what stands here above it.
constexpr const char* kart_head = R"(
uniform sampler2D dtex;
out float AO;

float engine_depth(ivec2 pixel, int level) {
    return texelFetch(dtex, pixel, 0).x;
}
)";
constexpr const char* kart_main = R"(
void main() {
    vec2 p00_p11 = vec2(u_projection_matrix[0][0], u_projection_matrix[1][1]);
    AO = 1.0 - occlusion_at(ivec2(gl_FragCoord.xy), ivec2(u_screen), p00_p11, 1.0);
}
)";
constexpr const char* material_head = R"(
float engine_depth(ivec2 pixel, int level) {
    return materialParams.near / texelFetch(materialParams_depth, pixel, 0).x;
}
)";
constexpr const char* material_main = R"(
out float seen;
void main() { seen = occlusion_at(ivec2(gl_FragCoord), ivec2(1920, 1080), materialParams.p00_p11, 0.5); }
)";

class PackOnePass : public InFolder {
  protected:
    void pack(const std::string& options) {
        fs::remove_all(path("out"));
        expect_success(run_command(words("pack --one-pass --out {} " + options, path("out"))));
    }
    void expect_compiles(const std::string& text) {
        const CommandResult result =
            run_program("/usr/bin/glslangValidator", {write("pass.frag", text).string()});
        EXPECT_EQ(result.status, 0) << result.out << text;
    }
};

TEST_F(PackOnePass, CompilesForEachVersion) {
    for (const std::string version : {"330", "300es", "none"}) {
        for (const char* others : {"--normals none --taps 4", "--normals view"}) {
            pack("--version " + version + " " + others);
            for (const char* name : {"occlusion.frag", "blur_x.frag", "blur_y.frag"}) {
                const std::string text = read_file(path("out") / name);
                EXPECT_EQ(text.starts_with("#version"), version != "none") << name;
                expect_compiles((version == "none" ? "#version 330\n" : "") + text);
            }
        }
    }
}

TEST_F(PackOnePass, IsTakenIntoProgramsByTheirText) {
    pack("--version none --normals none");
    const std::string text =
        run_program("/usr/bin/sed",
                    {"/^uniform /d; /^layout(/d; /^float engine_depth(/,/^}/d; /^void main/,$d",
                     path("out/occlusion.frag").string()})
            .out;
    const std::string kart = "uniform mat4 u_projection_matrix;\nuniform vec2 u_screen;\n";
    expect_compiles("#version 330\n" + kart + kart_head + text + kart_main);
    const std::string material =
        "uniform sampler2D materialParams_depth;\n"
        "uniform struct { vec2 p00_p11; float near; } materialParams;\n";
    expect_compiles("#version 330\n" + material + material_head + text + material_main);
}

}  // namespace gloam::test::pack_test
