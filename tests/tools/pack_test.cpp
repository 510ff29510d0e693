// SPDX-License-Identifier: MIT
#include "base/version.hpp"
#include "module/texts.hpp"
#include "tools/gloam.hpp"

namespace gloam::test::pack_test {

constexpr const char* halton = "gloam/sampling/halton.glsl";

class Pack : public InFolder {};

TEST_F(Pack, OneSelfContainedTextInEachVersion) {
    for (const auto& [version, first_line] :
         {std::pair("450", "#version 450"), std::pair("430", "#version 430"),
          std::pair("330", "#version 330"), std::pair("300es", "#version 300 es"),
          std::pair("310es", "#version 310 es")}) {
        const std::string result = output_of(gloam("pack {} --version {}", halton, version));
        EXPECT_THAT(result, StartsWith(first_line));
        EXPECT_EQ(result.find("\n// Packed by gloam " + base::version() + " for "), result.find('\n'));
        EXPECT_THAT(result, HasSubstr("float gloam_radical_inverse_base2(uint index)"));
        EXPECT_THAT(result, Not(HasSubstr("#include")));
    }
}

TEST_F(Pack, WritesTheFileItIsTold) {
    const fs::path out = path("packed.glsl");
    expect_success(gloam("pack {} --out {}", halton, out));
    EXPECT_EQ(read_file(out), gloam("pack {}", halton).out);
}

TEST_F(Pack, TakesOnesOwnFile) {
    const fs::path own = path("own.glsl");
    std::ofstream(own) << "#include \"" << halton
                       << "\"\nfloat own() { return gloam_radical_inverse_base2(1u); }\n";
    EXPECT_THAT(output_of(gloam("pack {}", own)), HasSubstr("float own()"));
}

// The engine defines what the library asks for.
TEST_F(Pack, AnEnginesOwnImagesServeThePrototypes) {
    const std::string folder = GLOAM_TOOLS_FIXTURES;
    const auto packed = [&](const char* file, const char* version) {
        return gloam("pack {} --function gloam_camera_normal --version {}", folder + file, version);
    };
    EXPECT_THAT(output_of(packed("/engine_vulkan.glsl", "450")), HasSubstr("vec3 gloam_camera_normal("));
    for (const char* version : {"330", "300es", "310es"}) expect_success(packed("/engine_gl.glsl", version));
}

TEST_F(Pack, OneFunctionAlone) {
    const std::string result = output_of(gloam("pack {} --function gloam_halton_2d", halton));
    EXPECT_THAT(result, AllOf(HasSubstr("vec2 gloam_halton_2d("), Not(HasSubstr("gloam_halton_3d"))));
}

TEST_F(Pack, OtherLanguages) {
    const CommandResult hlsl = gloam("pack {} --target hlsl", halton);
    expect_success(hlsl);
    EXPECT_THAT(hlsl.out, StartsWith("// Packed by gloam "));
    EXPECT_THAT(hlsl.out, HasSubstr("float gloam_radical_inverse_base2(uint index)\n{"));
    const std::string metal =
        output_of(gloam("pack {} --target msl", GLOAM_GLSL_DIR "/passes/study/reproject.comp"));
    EXPECT_THAT(metal, HasSubstr("kernel void main0("));
    const fs::path own = write("own.glsl", "float own(sampler2D s) { return texture(s, vec2(0.5)).x; }\n");
    expect_could_not_run(gloam("pack {} --target msl", own), "sampler2D");
}

// A whole shader, whose stage follows from its name.
TEST_F(Pack, AShaderWithAMain) {
    for (const char* name : {"study/reproject.comp", "study/remap.comp"}) {
        const std::string result = output_of(gloam("pack {}", std::string(GLOAM_GLSL_DIR "/passes/") + name));
        EXPECT_THAT(result, HasSubstr("void main()")) << name;
        EXPECT_THAT(result, Not(HasSubstr("#if"))) << name;
    }
}

TEST_F(Pack, CountsTheLinesOfEveryMethod) {
    const std::string result =
        output_of(run_command(words("pack --lines"), {.timeout = std::chrono::seconds(300)}));
    std::istringstream methods(gloam("list methods").out);
    int counted = 0;
    for (std::string name, meaning; methods >> name && std::getline(methods, meaning); ++counted)
        EXPECT_THAT(result,
                    testing::ContainsRegex("\n\\| " + name + " \\| [1-9][0-9]* \\| [1-9][0-9]* \\|\n"));
    EXPECT_GT(counted, 30);
}

TEST_F(Pack, CountsLines) {
    const std::string result = output_of(gloam("pack --lines {} gloam/temporal/history.glsl", halton));
    EXPECT_THAT(result,
                StartsWith("| file | lines of code |\n| --- | --- |\n| `gloam/sampling/halton.glsl` | "));
    EXPECT_EQ(line_count(result), 5);
    write("both.glsl", "float twice(float x) {\n    return 2.0 * x;\n}\n");
    const std::string text =
        "#version 450\n#include \"both.glsl\"\nlayout(binding = 0) buffer B { float v; };\n";
    for (const char* name : {"a.comp", "b.comp"}) write(name, text + "void main() {\n    v = twice(v);\n}\n");
    EXPECT_THAT(output_of(gloam("pack --lines {} {}", path("a.comp"), path("b.comp"))),
                HasSubstr("b.comp` | 8 |\n| together | 13 |\n"));
}

// Uniforms outside blocks are OpenGL's.
TEST_F(Pack, ATextForOpenGlIsNotForVulkan) {
    const fs::path own =
        write("own.glsl", "uniform float a, b;\nuniform float c;\nfloat own() { return a; }\n");
    const CommandResult result = gloam("pack {}", own);
    expect_could_not_run(result, "own.glsl:1: ");
    EXPECT_THAT(result.err, HasSubstr("--version 430"));
    EXPECT_EQ(line_count(result.err), 1);
    expect_success(gloam("pack {} --version 430", own));
}

TEST_F(Pack, AnErrorNamesTheFileAndItsLine) {
    for (const auto& [text, named] :
         {std::pair{"float own() {\n    return no_such_variable;\n}\n", ":2: 'no_such_variable'"},
          {"#version 450\n#include \"gloam/sampling/halton.glsl\"\n\nfloat own() { return wrong; }\n", ":4:"},
          {"#version banana\nfloat own() { return 1.0; }\n", ":1: #version banana"}}) {
        const fs::path own = write("own.glsl", text);
        const CommandResult result = gloam("pack {}", own);
        expect_could_not_run(result, own.string() + named);
        EXPECT_THAT(result.err, Not(HasSubstr("packed text")));
    }
}

// Each file includes the next one twice: 2^40 lines.
TEST_F(Pack, IncludesThatDoubleAreStopped) {
    for (int i = 0; i < 40; ++i) {
        const std::string next = "#include \"i" + std::to_string(i + 1) + ".glsl\"\n";
        write("i" + std::to_string(i) + ".glsl", next + next);
    }
    write("i40.glsl", "// nothing\n");
    const std::string first = path("i0.glsl").string();
    const CommandResult result = gloam("pack {}", first);
    expect_could_not_run(result, "more than 65536 includes at ");
}

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

constexpr const char* own_presets[] = {"fast", "balanced", "quality", "reference"};

struct Api {
    const char* version;
    const char* name;
    const char* glslang;  // options for SPIR-V; none: the text is only read
};
constexpr Api apis[] = {{"450", "Vulkan", "-V --target-env vulkan1.2 -o /dev/null"},
                        {"430", "OpenGL 4.3", nullptr},
                        {"330", "OpenGL 3.3", nullptr},
                        {"300es", "OpenGL ES 3.0 and WebGL2", nullptr}};

TEST_F(PackEffect, EachPresetIsShortAndCompilesForEachApi) {
    for (const char* preset : own_presets) {
        for (const Api& api : apis) {
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
            EXPECT_EQ(texts.size(), 3U);
            EXPECT_LE(shader::code_lines(texts), 400U);
            fs::remove_all(path(preset));
        }
    }
}

// All presets' headers in one program, and twice.
TEST_F(PackEffect, TheHeaderIsCAndShort) {
    std::string text;
    for (const char* preset : own_presets) {
        pack(preset, {});
        const std::string header = read_file(path(preset) / "gloam_frame.h");
        EXPECT_LE(shader::code_lines(header), 120U);
        for (int i = 0; i < 2; ++i) text += "#include \"" + std::string(preset) + "/gloam_frame.h\"\n";
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

// Each is in the texts or in the preset.
TEST_F(PackEffect, OptionsAreConstants) {
    pack("fast", words("--version 430 --orthographic --normals world-octahedral-unorm --set samples=6 "
                       "--set steps=3 --bent-normals --multi-bounce"));
    const std::string sweep = read_file(path("fast") / "sweep.comp");
    for (const char* constant : {"orthographic = true", "world_normals = true", "octahedral_normals = true",
                                 "unorm_normals = true", "steps = 3", "history = true", "stride = 2"})
        EXPECT_THAT(sweep, HasSubstr(constant));
    EXPECT_THAT(read_file(path("fast") / "join.comp"),
                AllOf(HasSubstr("OUTPUT r8\n"), HasSubstr("bounce(alone("), HasSubstr("bends.xyz += ")));
    pack("quality", words("--normals none --set history=off --set history_range=0.25 --set output=r16f"));
    EXPECT_THAT(read_file(path("quality") / "sweep.comp"),
                AllOf(HasSubstr("position_at("), Not(HasSubstr("octahedral")), HasSubstr("history = false")));
    EXPECT_THAT(read_file(path("quality") / "filter.comp"), HasSubstr("#define GLOAM_OUTPUT r16f\n"));
    EXPECT_THAT(read_file(path("quality") / "gloam_frame.h"),
                AllOf(HasSubstr("gloam_quality = {0, 0.25f, 0.5f};"), HasSubstr(" shown        R16F  ")));
}

}  // namespace gloam::test::pack_test
