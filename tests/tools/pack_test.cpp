// SPDX-License-Identifier: MIT
#include "base/version.hpp"
#include "tools/gloam.hpp"

namespace gloam::test::pack_test {

constexpr const char* halton = "gloam/sampling/halton.glsl";

class Pack : public InFolder {};

TEST_F(Pack, OneSelfContainedTextInEachVersion) {
    for (const auto& [version, first_line] :
         {std::pair("450", "#version 450"), std::pair("330", "#version 330"),
          std::pair("300es", "#version 300 es"), std::pair("310es", "#version 310 es")}) {
        const std::string result = output_of(gloam("pack {} --version {}", halton, version));
        EXPECT_THAT(result, StartsWith(first_line));
        EXPECT_EQ(result.find("\n// Packed by gloam " + base::version() + ".\n"), result.find('\n'));
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

// As docs/integration.md shows it: the engine defines what the library asks for.
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
    EXPECT_THAT(result, HasSubstr("vec2 gloam_halton_2d("));
    EXPECT_THAT(result, Not(HasSubstr("gloam_halton_3d")));
    expect_could_not_run(gloam("pack {} --function gloam_halton_4d", halton), "gloam_halton_4d");
}

TEST_F(Pack, OtherLanguages) {
    const CommandResult hlsl = gloam("pack {} --target hlsl", halton);
    expect_success(hlsl);
    EXPECT_THAT(hlsl.out, StartsWith("// Packed by gloam "));
    EXPECT_THAT(hlsl.out, HasSubstr("float gloam_radical_inverse_base2(uint index)\n{"));
    const std::string metal =
        output_of(gloam("pack {} --target msl", GLOAM_GLSL_DIR "/passes/study/reproject.comp"));
    EXPECT_THAT(metal, HasSubstr("kernel void main0("));
    expect_could_not_run(gloam("pack {} --target cg", halton), "expected hlsl or msl");
    expect_could_not_run(gloam("pack {} --target hlsl --version 330", halton), "--version");
    expect_could_not_run(gloam("pack {} --lines --target hlsl", halton), "--lines");
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

TEST_F(Pack, BadInputIsNamed) {
    expect_could_not_run(gloam("pack"), "--effect");
    expect_could_not_run(gloam("pack --method disc"), "--effect");
    expect_could_not_run(gloam("pack {} --version 300es", GLOAM_GLSL_DIR "/passes/study/reproject.comp"),
                         "reproject.comp");
    expect_could_not_run(gloam("pack {} --npm {}", halton, path("npm").string()), "file excludes --npm");
    expect_could_not_run(gloam("pack --effect --npm {}", path("npm").string()), "--effect excludes --npm");
    expect_could_not_run(gloam("pack --npm /proc/npm"), "/proc/npm");
    EXPECT_FALSE(fs::exists(path("npm")));
    expect_could_not_run(gloam("pack gloam/no/such.glsl"), "gloam/no/such.glsl");
    expect_could_not_run(gloam("pack {} --version 110", halton), "110");
    expect_could_not_run(gloam("pack {} --out /no/such/folder/file", halton), "/no/such/folder/file");
    expect_could_not_run(gloam("pack {} --out /dev/full", halton), "/dev/full");
}

TEST_F(Pack, TextThatDoesNotCompileNamesFileAndLine) {
    const fs::path own = write("own.glsl", "float own() {\n    return no_such_variable;\n}\n");
    expect_could_not_run(gloam("pack {}", own), "no_such_variable");
}

TEST_F(Pack, AnErrorNamesTheFileAndItsLine) {
    const fs::path own = path("own.glsl");
    std::ofstream(own) << "#version 450\n#include \"" << halton << "\"\n\nfloat own() { return wrong; }\n";
    const CommandResult result = gloam("pack {}", own);
    expect_could_not_run(result, own.string() + ":4:");
    EXPECT_THAT(result.err, Not(HasSubstr("packed text")));
}

TEST_F(Pack, AVersionThatIsNoneIsNamed) {
    const fs::path own = write("own.glsl", "#version banana\nfloat own() { return 1.0; }\n");
    expect_could_not_run(gloam("pack {}", own), own.string() + ":1: #version banana");
}

// A chain of includes: each file includes the next one. Returns the first.
std::string chain_of_includes(const fs::path& folder, int depth) {
    const auto name = [](int i) { return "i" + std::to_string(i) + ".glsl"; };
    for (int i = 0; i < depth; ++i)
        std::ofstream(folder / name(i))
            << "#include \"" << name(i + 1) << "\"\nfloat f" << i << "() { return f" << i + 1 << "(); }\n";
    std::ofstream(folder / name(depth)) << "float f" << depth << "() { return 1.0; }\n";
    return (folder / name(0)).string();
}

TEST_F(Pack, ManyIncludesDeep) {
    EXPECT_THAT(output_of(gloam("pack {}", chain_of_includes(path(""), 250))), HasSubstr("float f250()"));
    expect_could_not_run(gloam("pack {}", chain_of_includes(path(""), 300)),
                         "i256.glsl:1: includes are nested more than 256 deep");
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
    void pack(std::vector<std::string> options) {
        fs::remove_all(out());
        options.insert(options.begin(), {"pack", "--effect", "--out", out().string()});
        expect_success(run_command(options));
    }

    [[nodiscard]] fs::path out() const { return path("effect"); }
    [[nodiscard]] json description() const { return json::parse(read_file(out() / "effect.json")); }

    // Every pass by glslangValidator, the header as C and as C++.
    void expect_compiles() const {
        for (const auto& entry : fs::directory_iterator(out())) {
            const std::string file = entry.path().string();
            if (entry.path().extension() == ".comp") {
                const CommandResult result =
                    run_program("/usr/bin/glslangValidator",
                                words("-V --target-env vulkan1.2 {} -o {}", file, path("module.spv")));
                EXPECT_EQ(result.status, 0) << file << "\n" << result.out;
                EXPECT_THAT(read_file(entry.path()), Not(HasSubstr("#include")));
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
};

json named(const json& list, const std::string& name) {
    for (const json& each : list)
        if (each["name"] == name) return each;
    ADD_FAILURE() << "no " << name;
    return {};
}

// One of each kind: with and without a table of samples, with and without preparation.
TEST_F(PackEffect, EveryKindOfMethodIsWholeAndCompiles) {
    for (const char* method : {"hemisphere", "gtao", "dual_resolution", "mssao", "sao_chain", "separable"}) {
        SCOPED_TRACE(method);
        pack(words("--method {} --preset tssao-paper --size 640x360", method));
        expect_compiles();
    }
}

// The passes in another language stand beside those in GLSL.
TEST_F(PackEffect, AnotherLanguageBesideGlsl) {
    for (const auto& [target, suffix, first] :
         {std::tuple("hlsl", ".hlsl", "cbuffer Parameters : register(b0"),
          std::tuple("msl", ".metal", "kernel void main0(")}) {
        SCOPED_TRACE(target);
        pack(words("--target {}", target));
        for (const json& pass : description()["passes"]) {
            const std::string name = pass["name"];
            EXPECT_TRUE(fs::exists(out() / (name + ".comp"))) << name;
            EXPECT_THAT(read_file(out() / (name + suffix)),
                        HasSubstr(name == "ambient_occlusion" ? first : "main"))
                << name;
        }
        const std::string last = description()["passes"].back()["name"];
        EXPECT_THAT(read_file(out() / "README.md"), HasSubstr("as `" + last + suffix + "`"));
    }
}

// With whatever else there is in the passes.
TEST_F(PackEffect, EveryOptionCompiles) {
    for (const std::vector<std::string>& options :
         {std::vector<std::string>{"--moving-objects", "--orthographic", "--reconstruct-normals"},
          {"--method", "ssdo", "--set", "layers=3", "--set", "remap_b=2"},
          {"--moving-objects", "--preset", "tssao-paper", "--set", "layers=2", "--depth", "buffer"}}) {
        pack(options);
        expect_compiles();
    }
}

// Each binding is to a resource that is listed, each image is used, and what one pass writes and another
// reads has a barrier.
TEST_F(PackEffect, TheTablesAgree) {
    for (const char* method : {"hemisphere", "mssao", "separable"}) {
        pack(words("--method {} --preset tssao-paper", method));
        const json all = description();
        std::set<std::string> resources;
        for (const char* kind : {"images", "buffers"})
            for (const json& each : all[kind]) EXPECT_TRUE(resources.insert(each["name"]).second);
        std::set<std::string> bound{all["result"]["image"]};
        std::set<std::string> written;
        for (const json& pass : all["passes"]) {
            std::set<std::string> guarded;
            for (const json& barrier : pass["barriers"]) guarded.insert(barrier["resource"]);
            for (const json& binding : pass["bindings"]) {
                const std::string name = binding["resource"];
                bound.insert(name);
                EXPECT_TRUE(!written.contains(name) || guarded.contains(name)) << pass["name"] << " " << name;
            }
            for (const json& binding : pass["bindings"]) {
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
    pack(words("--method mssao"));
    const std::string page = read_file(out() / "README.md");
    EXPECT_LT(page.find("`surface_1.comp`"), page.find("`occlusion_4.comp`"));
    EXPECT_LT(page.find("`occlusion_1.comp`"), page.find("`ambient_occlusion.comp`"));
    EXPECT_TRUE(fs::exists(out() / "occlusion_1.comp"));
    EXPECT_FALSE(named(description()["images"], "prepared").is_null());
}

// tests/effect/opengl_passes_test.cpp compiles them with a driver.
TEST_F(PackEffect, PassesInES) {
    pack(words("--version 310es --moving-objects --preset tssao-paper"));
    const std::string shader = read_file(out() / "reproject.comp");
    EXPECT_THAT(shader, StartsWith("#version 310 es\n"));
    EXPECT_THAT(shader, HasSubstr("layout(binding = 0, std140) uniform Parameters {"));
    EXPECT_THAT(shader, HasSubstr("const bool moving_objects = true;"));
    EXPECT_THAT(shader, Not(HasSubstr("constant_id")));
    EXPECT_THAT(read_file(out() / "README.md"), HasSubstr("GLSL ES file"));
}

TEST_F(PackEffect, SettingsStandAtTheHead) {
    pack(words("--preset study-crytek-quality --radius 0.25 --set weight_max=77"));
    const std::string page = read_file(out() / "README.md");
    EXPECT_LT(page.find("| samples | 200 |"), page.find("## Order of calls"));
    EXPECT_THAT(page, HasSubstr("| weight_max | 77 |"));
    EXPECT_THAT(read_file(out() / "gloam_effect.h"), HasSubstr("    0.25f,  /* radius */\n"));
    const std::string shader = read_file(out() / "ambient_occlusion.comp");
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
    refused(words("--out {} --preset magic", folder), "magic");
    refused(words("--out {} --method magic", folder), "magic");
    refused(words("--out {} --size 0x3", folder), "--size 0x3");
    refused(words("--out {} --version 330", folder), "--version 330");
    refused(words("--out {} --set samples=0", folder), "samples");
    refused(words("--out /dev/null/effect"), "/dev/null");
}

}  // namespace gloam::test::pack_test
