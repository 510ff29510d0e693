// SPDX-License-Identifier: MIT
// Every include compiles alone, unchanged and packed, in every GLSL version that the library supports.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "shader/language.hpp"
#include "shader/pack.hpp"
#include "shader/translate.hpp"
#include "support/library_files.hpp"

namespace gloam {
namespace languages_test {

namespace fs = std::filesystem;

const std::vector<fs::path> roots{GLOAM_GLSL_DIR};

constexpr shader::Language languages[] = {shader::Language::vulkan450, shader::Language::gl330,
                                          shader::Language::es300, shader::Language::es310,
                                          shader::Language::es320};

class EveryInclude : public testing::TestWithParam<std::string> {};

TEST_P(EveryInclude, CompilesAlone) {
    const shader::Source source{.name = GetParam(), .text = "#include \"" + GetParam() + "\"\n"};
    for (const shader::Language language : languages)
        EXPECT_NO_THROW(shader::check_compiles(source, language, roots)) << shader::to_string(language);
}

TEST_P(EveryInclude, CompilesPacked) {
    for (const shader::Language language : languages) {
        const std::string packed =
            shader::pack(std::vector{roots.front() / GetParam()}, {.language = language}, roots);
        EXPECT_EQ(packed.find("#include"), std::string::npos) << shader::to_string(language);
    }
}

TEST_P(EveryInclude, IsTranslated) {
    const std::string packed = shader::pack(std::vector{roots.front() / GetParam()}, {}, roots);
    for (const shader::Target target : {shader::Target::hlsl, shader::Target::msl})
        EXPECT_NO_THROW((void)shader::translated({.name = GetParam(), .text = packed}, target));
}

INSTANTIATE_TEST_SUITE_P(Library, EveryInclude, testing::ValuesIn(test::library_files()),
                         test::library_file_name);

// Each shader of passes/ in its stage, as a whole shader.
TEST(EveryPass, IsTranslated) {
    const std::map<std::string, shader::Stage> stages{{".comp", shader::Stage::compute},
                                                      {".vert", shader::Stage::vertex},
                                                      {".frag", shader::Stage::fragment}};
    std::size_t count = 0;
    for (const auto& file : fs::recursive_directory_iterator(roots.front() / "passes")) {
        const auto stage = stages.find(file.path().extension().string());
        if (stage == stages.end()) continue;
        const std::string packed = shader::pack(std::vector{file.path()}, {.stage = stage->second}, roots);
        for (const shader::Target target : {shader::Target::hlsl, shader::Target::msl}) {
            const std::string text =
                shader::translated({file.path().string(), packed}, target, stage->second);
            EXPECT_NE(text.find(target == shader::Target::hlsl ? " main(" : "_main("), std::string::npos)
                << file.path();
        }
        ++count;
    }
    EXPECT_GE(count, 30U);
}

class Languages : public testing::TestWithParam<shader::Language> {};

TEST_P(Languages, TheWholeLibraryCompilesPackedIntoOne) {
    std::vector<fs::path> files;
    for (const std::string& name : test::library_files()) files.push_back(roots.front() / name);
    EXPECT_NO_THROW((void)shader::pack(files, {.language = GetParam()}, roots));
}

TEST_P(Languages, ABrokenIncludeDoesNot) {
    EXPECT_THROW(shader::check_compiles({.name = "broken", .text = "float f() { return vec2(1.0); }\n"},
                                        GetParam(), roots),
                 shader::CompileError);
}

INSTANTIATE_TEST_SUITE_P(All, Languages, testing::ValuesIn(languages),
                         [](const auto& info) { return "glsl_" + shader::to_string(info.param); });

}  // namespace languages_test
}  // namespace gloam
