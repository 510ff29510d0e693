// SPDX-License-Identifier: MIT
// Every equation of the catalogue on OpenGL devices.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <optional>

#include "catalogue/catalogue.hpp"
#include "check/run.hpp"
#include "gl/program.hpp"
#include "shader/pack.hpp"
#include "support/lab.hpp"

namespace gloam::catalogue {
namespace opengl_test {

namespace fs = std::filesystem;

constexpr std::size_t inputs_per_equation = 128;

class OpenGlSweep : public testing::TestWithParam<const char*> {};

TEST_P(OpenGlSweep, EveryEquationStaysWithinItsBudget) {
    std::optional<check::Lab> lab;
    try {
        lab.emplace(check::LabOptions{.device = GetParam(),
                                      .include_roots = {GLOAM_GLSL_DIR},
                                      .cache_directory = test::cache_directory()});
    } catch (const gl::Unavailable& error) {
        GTEST_SKIP() << error.what();
    }
    std::size_t judged = 0;
    for (const Entry& entry : all_entries()) {
        const std::string& id = entry.description.id;
        try {
            const check::Answer answer = check::run(*lab, entry.question, {.inputs = inputs_per_equation});
            EXPECT_TRUE(answer.passed()) << id << ": " << answer;
            if (!answer.recorded_only()) ++judged;
        } catch (const check::Unsupported& error) {
            // Wrappers of built-ins and probes only: the library compiles in every version.
            EXPECT_TRUE(entry.description.file.starts_with("builtin/")) << id << ": " << error.what();
        }
    }
    EXPECT_GT(judged, 300U);
}

// As an engine has it: the whole file, packed for the version. Mesa links also what main() does not call.
TEST_P(OpenGlSweep, EveryIncludeCompiles) {
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

INSTANTIATE_TEST_SUITE_P(All, OpenGlSweep, testing::Values("es:llvmpipe-3.0"),
                         [](const auto&) { return std::string("es_llvmpipe_3_0"); });

}  // namespace opengl_test
}  // namespace gloam::catalogue
