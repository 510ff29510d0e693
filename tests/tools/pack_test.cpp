// SPDX-License-Identifier: MIT
#include <fstream>
#include <iterator>

#include "effect/methods.hpp"
#include "shader/compile.hpp"
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
    const CommandResult vulkan = run_command({"pack", folder + "/engine_vulkan.glsl"});
    expect_success(vulkan);
    EXPECT_THAT(vulkan.out, HasSubstr("vec3 gloam_normal_from_depth("));
    for (const char* version : {"330", "300es", "310es"}) {
        expect_success(run_command({"pack", folder + "/engine_gl.glsl", "--version", version}));
    }
}

// What the front end makes of the packed text is what it makes of the pass in the library, to the word: so is
// the module after the optimiser, and every image.
TEST(Pack, AWholePassIsThePassItself) {
    const std::string pass = GLOAM_GLSL_DIR "/passes/ambient_occlusion.comp";
    const std::string include = "methods/hemisphere.glsl";
    const std::string text = read(pass);
    const std::size_t at = text.find(include);
    ASSERT_NE(at, std::string::npos);
    for (const effect::MethodInfo& method : effect::methods()) {
        const CommandResult result = run_command({"pack", "--method", method.name});
        expect_success(result);
        EXPECT_THAT(result.out, Not(HasSubstr("#include"))) << method.name;
        const std::string other = "methods/" + method.name + ".glsl";
        EXPECT_EQ(
            shader::compile({.name = "packed", .text = result.out}, {}),
            shader::compile({.name = pass, .text = std::string(text).replace(at, include.size(), other)},
                            {.include_roots = {GLOAM_GLSL_DIR}}))
            << method.name;
    }
}

TEST(Pack, APresetBringsItsSettings) {
    const CommandResult result = run_command({"pack", "--preset", "gtao-quality"});
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr("gloam_gtao_add"));
    EXPECT_THAT(result.out, HasSubstr("//   steps = 3\n"));
    const CommandResult other = run_command({"pack", "--method", "disc", "--preset", "balanced"});
    EXPECT_THAT(other.out, HasSubstr("//   samples = 8\n"));
    EXPECT_THAT(other.out, HasSubstr("//   method = disc\n"));
}

TEST(Pack, BadInputIsNamed) {
    expect_could_not_run(run_command({"pack"}), "--method");
    expect_could_not_run(run_command({"pack", "--method", "magic"}), "magic");
    expect_could_not_run(run_command({"pack", "--preset", "magic"}), "magic");
    expect_could_not_run(run_command({"pack", halton, "--method", "disc"}), "give no files");
    expect_could_not_run(run_command({"pack", "--method", "disc", "--version", "330"}), "330");
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
