// SPDX-License-Identifier: MIT
#include <fstream>
#include <iterator>
#include <sstream>

#include "tools/expect.hpp"

namespace gloam::test {
namespace pack_test {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr const char* halton = "gloam/sampling/halton.glsl";

std::string read(const std::filesystem::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Pack, OneSelfContainedTextInEachVersion) {
    for (const auto& [version, first_line] :
         {std::pair("450", "#version 450"), std::pair("330", "#version 330"),
          std::pair("300es", "#version 300 es"), std::pair("310es", "#version 310 es")}) {
        const CommandResult result = run_command({"pack", halton, "--version", version});
        expect_success(result);
        EXPECT_THAT(result.out, StartsWith(first_line));
        EXPECT_THAT(result.out, HasSubstr("float gloam_radical_inverse_base2(uint index)"));
        EXPECT_THAT(result.out, Not(HasSubstr("#include")));
    }
}

TEST(Pack, WritesTheFileItIsTold) {
    const TemporaryDirectory folder;
    const std::filesystem::path out = folder.path() / "packed.glsl";
    expect_success(run_command({"pack", halton, "--out", out.string()}));
    EXPECT_EQ(read(out), run_command({"pack", halton}).out);
}

TEST(Pack, TakesOnesOwnFile) {
    const TemporaryDirectory folder;
    const std::filesystem::path own = folder.path() / "own.glsl";
    std::ofstream(own) << "#include \"" << halton
                       << "\"\nfloat own() { return gloam_radical_inverse_base2(1u); }\n";
    const CommandResult result = run_command({"pack", own.string()});
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr("float own()"));
}

// As docs/integration.md shows it: the engine defines what the library asks for.
TEST(Pack, AnEnginesOwnImagesServeThePrototypes) {
    const std::string folder = GLOAM_TOOLS_FIXTURES;
    const auto packed = [&](const char* file, const char* version) {
        return run_command(
            {"pack", folder + file, "--function", "gloam_normal_from_depth", "--version", version});
    };
    const CommandResult vulkan = packed("/engine_vulkan.glsl", "450");
    expect_success(vulkan);
    EXPECT_THAT(vulkan.out, HasSubstr("vec3 gloam_normal_from_depth("));
    for (const char* version : {"330", "300es", "310es"}) expect_success(packed("/engine_gl.glsl", version));
}

TEST(Pack, OneFunctionAlone) {
    const CommandResult result = run_command({"pack", halton, "--function", "gloam_halton_2d"});
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr("vec2 gloam_halton_2d("));
    EXPECT_THAT(result.out, Not(HasSubstr("gloam_halton_3d")));
    expect_could_not_run(run_command({"pack", halton, "--function", "gloam_halton_4d"}), "gloam_halton_4d");
}

TEST(Pack, OtherLanguages) {
    const CommandResult hlsl = run_command({"pack", halton, "--target", "hlsl"});
    expect_success(hlsl);
    EXPECT_THAT(hlsl.out, HasSubstr("float gloam_radical_inverse_base2(uint index)\n{"));
    EXPECT_THAT(hlsl.out, HasSubstr("// index: number of the sample;"));
    EXPECT_THAT(hlsl.out, Not(HasSubstr("main")));
    const CommandResult metal =
        run_command({"pack", GLOAM_GLSL_DIR "/passes/reproject.comp", "--target", "msl"});
    expect_success(metal);
    EXPECT_THAT(metal.out, HasSubstr("kernel void reproject_main("));
    EXPECT_THAT(metal.out, HasSubstr("\n// Indices: buffer(4) tile_lists, "));
    const CommandResult wgsl = run_command({"pack", halton, "--target", "wgsl"});
    expect_success(wgsl);
    EXPECT_THAT(wgsl.out, HasSubstr("fn gloam_radical_inverse_base2(index: u32) -> f32 {\n"));
    EXPECT_THAT(wgsl.out, HasSubstr("// index: number of the sample;"));
    expect_could_not_run(run_command({"pack", GLOAM_GLSL_DIR "/passes/gbuffer.frag", "--target", "wgsl"}),
                         "gbuffer.frag: gloam does not translate to WGSL yet");
    expect_could_not_run(run_command({"pack", halton, "--target", "cg"}), "hlsl, msl or wgsl");
    expect_could_not_run(run_command({"pack", halton, "--target", "hlsl", "--version", "330"}), "--version");
    expect_could_not_run(run_command({"pack", halton, "--lines", "--target", "hlsl"}), "--lines");
    const TemporaryDirectory folder;
    const std::filesystem::path own = folder.path() / "own.glsl";
    std::ofstream(own) << "float own(sampler2D s) { return texture(s, vec2(0.5)).x; }\n";
    expect_could_not_run(run_command({"pack", own.string(), "--target", "msl"}), "sampler2D");
}

// A whole shader, whose stage follows from its name.
TEST(Pack, AShaderWithAMain) {
    for (const char* name : {"reproject.comp", "gbuffer.vert", "gbuffer.frag", "tiles/select.comp"}) {
        const CommandResult result = run_command({"pack", std::string(GLOAM_GLSL_DIR "/passes/") + name});
        expect_success(result);
        EXPECT_THAT(result.out, HasSubstr("void main()")) << name;
        EXPECT_THAT(result.out, Not(HasSubstr("#if"))) << name;
    }
}

TEST(Pack, CountsTheLinesOfEveryMethod) {
    const CommandResult result = run_command({"pack", "--lines"}, {.timeout = std::chrono::seconds(300)});
    expect_success(result);
    std::istringstream methods(run_command({"list", "methods"}).out);
    int counted = 0;
    for (std::string name; std::getline(methods, name); ++counted)
        EXPECT_THAT(result.out,
                    testing::ContainsRegex("\n\\| " + name + " \\| [1-9][0-9]* \\| [1-9][0-9]* \\|\n"));
    EXPECT_GT(counted, 30);
}

TEST(Pack, CountsLines) {
    const CommandResult result = run_command({"pack", "--lines", halton, "gloam/temporal/history.glsl"});
    expect_success(result);
    EXPECT_THAT(result.out,
                StartsWith("| file | lines of code |\n| --- | --- |\n| `gloam/sampling/halton.glsl` | "));
    EXPECT_EQ(line_count(result.out), 4);
}

TEST(Pack, BadInputIsNamed) {
    expect_could_not_run(run_command({"pack"}), "--effect");
    expect_could_not_run(run_command({"pack", "--method", "disc"}), "--effect");
    expect_could_not_run(run_command({"pack", GLOAM_GLSL_DIR "/passes/reproject.comp", "--version", "300es"}),
                         "reproject.comp");
    expect_could_not_run(run_command({"pack", "gloam/no/such.glsl"}), "gloam/no/such.glsl");
    expect_could_not_run(run_command({"pack", halton, "--version", "110"}), "110");
    expect_could_not_run(run_command({"pack", halton, "--out", "/no/such/folder/file"}),
                         "/no/such/folder/file");
    expect_could_not_run(run_command({"pack", halton, "--out", "/dev/full"}), "/dev/full");
}

TEST(Pack, TextThatDoesNotCompileNamesFileAndLine) {
    const TemporaryDirectory folder;
    const std::filesystem::path own = folder.path() / "own.glsl";
    std::ofstream(own) << "float own() {\n    return no_such_variable;\n}\n";
    expect_could_not_run(run_command({"pack", own.string()}), "no_such_variable");
}

TEST(Pack, AnErrorNamesTheFileAndItsLine) {
    const TemporaryDirectory folder;
    const std::filesystem::path own = folder.path() / "own.glsl";
    std::ofstream(own) << "#version 450\n#include \"" << halton << "\"\n\nfloat own() { return wrong; }\n";
    const CommandResult result = run_command({"pack", own.string()});
    expect_could_not_run(result, own.string() + ":4:");
    EXPECT_THAT(result.err, Not(HasSubstr("packed text")));
}

TEST(Pack, AVersionThatIsNoneIsNamed) {
    const TemporaryDirectory folder;
    const std::filesystem::path own = folder.path() / "own.glsl";
    std::ofstream(own) << "#version banana\nfloat own() { return 1.0; }\n";
    expect_could_not_run(run_command({"pack", own.string()}), own.string() + ":1: #version banana");
}

// A chain of includes: each file includes the next one. Returns the first.
std::string chain_of_includes(const std::filesystem::path& folder, int depth) {
    const auto name = [](int i) { return "i" + std::to_string(i) + ".glsl"; };
    for (int i = 0; i < depth; ++i)
        std::ofstream(folder / name(i))
            << "#include \"" << name(i + 1) << "\"\nfloat f" << i << "() { return f" << i + 1 << "(); }\n";
    std::ofstream(folder / name(depth)) << "float f" << depth << "() { return 1.0; }\n";
    return (folder / name(0)).string();
}

TEST(Pack, ManyIncludesDeep) {
    const TemporaryDirectory folder;
    const CommandResult result = run_command({"pack", chain_of_includes(folder.path(), 250)});
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr("float f250()"));
    expect_could_not_run(run_command({"pack", chain_of_includes(folder.path(), 300)}),
                         "i256.glsl:1: includes are nested more than 256 deep");
}

// Each file includes the next one twice: 2^40 lines.
TEST(Pack, IncludesThatDoubleAreStopped) {
    const TemporaryDirectory folder;
    for (int i = 0; i < 40; ++i) {
        const std::string next = "#include \"i" + std::to_string(i + 1) + ".glsl\"\n";
        std::ofstream(folder.path() / ("i" + std::to_string(i) + ".glsl")) << next << next;
    }
    std::ofstream(folder.path() / "i40.glsl") << "// nothing\n";
    const std::string first = (folder.path() / "i0.glsl").string();
    const CommandResult result = run_command({"pack", first});
    expect_could_not_run(result, "more than 65536 includes at ");
}

// Each macro is twice the one before: 2^40 additions, 7 GB on the way there.
TEST(Pack, ACompilerThatGrowsIsStopped) {
    const TemporaryDirectory folder;
    const std::filesystem::path own = folder.path() / "own.glsl";
    std::ofstream stream(own);
    stream << "#define M0 1.0\n";
    for (int i = 1; i <= 40; ++i) stream << "#define M" << i << " M" << i - 1 << " + M" << i - 1 << "\n";
    stream << "float own() { return M40; }\n";
    stream.close();
    const CommandResult result = run_command({"pack", own.string()});
    expect_could_not_run(result, own.string());
    EXPECT_THAT(result.err, HasSubstr("takes more than"));
}

}  // namespace pack_test
}  // namespace gloam::test
