// SPDX-License-Identifier: MIT
// Every include compiles alone, as it stands and packed, in every GLSL version that the library promises.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "shader/language.hpp"
#include "shader/pack.hpp"

namespace gloam {
namespace languages_test {

namespace fs = std::filesystem;

const std::vector<fs::path> roots{GLOAM_GLSL_DIR};

std::vector<std::string> library_includes() {
    std::vector<std::string> names;
    for (const auto& file : fs::recursive_directory_iterator(roots.front() / "gloam")) {
        if (file.path().extension() == ".glsl")
            names.push_back(fs::relative(file.path(), roots.front()).string());
    }
    std::ranges::sort(names);
    return names;
}

class Languages : public testing::TestWithParam<shader::Language> {};

TEST_P(Languages, EveryIncludeCompilesAlone) {
    for (const std::string& name : library_includes()) {
        EXPECT_NO_THROW(
            shader::check_compiles({.name = name, .text = "#include \"" + name + "\"\n"}, GetParam(), roots))
            << name;
    }
}

TEST_P(Languages, EveryIncludeCompilesPacked) {
    for (const std::string& name : library_includes()) {
        const std::string packed =
            shader::pack(std::vector{roots.front() / name}, {.language = GetParam()}, roots);
        EXPECT_EQ(packed.find("#include"), std::string::npos) << name;
    }
}

TEST_P(Languages, TheWholeLibraryCompilesPackedIntoOne) {
    std::vector<fs::path> files;
    for (const std::string& name : library_includes()) files.push_back(roots.front() / name);
    EXPECT_NO_THROW((void)shader::pack(files, {.language = GetParam()}, roots));
}

TEST_P(Languages, ABrokenIncludeDoesNot) {
    EXPECT_THROW(shader::check_compiles({.name = "broken", .text = "float f() { return vec2(1.0); }\n"},
                                        GetParam(), roots),
                 shader::CompileError);
}

INSTANTIATE_TEST_SUITE_P(All, Languages,
                         testing::Values(shader::Language::vulkan450, shader::Language::gl330,
                                         shader::Language::es300, shader::Language::es310),
                         [](const auto& info) { return "glsl_" + shader::to_string(info.param); });

}  // namespace languages_test
}  // namespace gloam
