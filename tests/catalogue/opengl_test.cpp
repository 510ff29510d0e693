// SPDX-License-Identifier: MIT
// Every include on an OpenGL device.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <optional>

#include "gl/program.hpp"
#include "shader/pack.hpp"

namespace gloam::catalogue {
namespace opengl_test {

namespace fs = std::filesystem;

class OpenGlIncludes : public testing::TestWithParam<const char*> {};

// As an engine has it: the whole file, packed for the version. Mesa links also what main() does not call.
TEST_P(OpenGlIncludes, EachCompiles) {
    std::optional<gl::Device> device;
    try {
        device.emplace(GetParam());
    } catch (const gl::Unavailable& error) {
        GTEST_SKIP() << error.what();
    }
    const bool es = device->info().name.version.api == gl::Api::es;
    const shader::Language language = es ? shader::Language::es300 : shader::Language::vulkan450;
    const fs::path root = GLOAM_GLSL_DIR;
    for (const auto& file : fs::recursive_directory_iterator(root / "gloam")) {
        if (file.path().extension() != ".glsl") continue;
        const std::string text = shader::pack(std::vector{file.path()}, {.language = language}, {root});
        const gl::ShaderText shader{file.path().filename().string(), text + "\nvoid main() {}\n"};
        try {
            const gl::Program program(*device, gl::Program::Stage::fragment, shader);
        } catch (const gl::LinkFailed& error) {  // of the prototypes, which an engine defines
            EXPECT_THAT(error.what(), testing::HasSubstr("unresolved reference to function")) << file;
        } catch (const gl::CompileFailed& error) {
            ADD_FAILURE() << error.what();
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, OpenGlIncludes, testing::Values("es:llvmpipe-3.0"),
                         [](const auto&) { return std::string("es_llvmpipe_3_0"); });

}  // namespace opengl_test
}  // namespace gloam::catalogue
