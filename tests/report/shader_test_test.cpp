// SPDX-License-Identifier: MIT
#include "report/shader_test.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace gloam::report {
namespace shader_test_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr double infinity = std::numeric_limits<double>::infinity();

ShaderReplay replay(bool compute) {
    return {
        .glsl = "#version 310 es\nvoid main() {}\n",
        .compute = compute,
        .version = "GL ES >= 3.1",
        .glsl_version = "GLSL ES >= 3.10",
        .kernel = {
            .comments = {"a comment"},
            .assembly = {},
            .inputs = {0x3f800000U, 0xffffffffU},
            .images = {{.name = "fetch", .words = {1U, 1U, 0U, 9U}}},
            .outputs = {
                {.is_float = true, .allowed = {{.low = 0.5, .high = 2, .nan = false}}, .comment = "c"},
                {.is_float = false, .allowed = {{.low = -1, .high = -1, .nan = false}}, .comment = "d"}}}};
}

TEST(ShaderTest, AComputeShaderIsProbed) {
    const std::string text = to_shader_test(replay(true));
    EXPECT_THAT(text,
                StartsWith("# a comment\n\n[require]\nGL ES >= 3.1\nGLSL ES >= 3.10\n\n[compute shader]\n"
                           "#version 310 es\n"));
    EXPECT_THAT(text, AllOf(HasSubstr("ssbo 0 8\nssbo 0 subdata int 0 1065353216\nssbo 0 subdata int 4 -1\n"),
                            HasSubstr("ssbo 1 12\n"), HasSubstr("ssbo 3 16\nssbo 3 subdata int 0 1\n"),
                            HasSubstr("compute 1 1 1\n")));
    EXPECT_THAT(text, AllOf(HasSubstr("probe ssbo float 1 0 >= 0.5\nprobe ssbo float 1 0 <= 2\n"),
                            HasSubstr("probe ssbo uint 1 4 == 0xffffffff\n"),
                            HasSubstr("probe ssbo uint 1 8 == 0x3f800000\n"),
                            HasSubstr("probe ssbo uint 2 0 == 0x0\n")));
}

TEST(ShaderTest, WhatIsNotJudgedIsNotProbed) {
    ShaderReplay one = replay(true);
    one.kernel.outputs.front().allowed.clear();
    EXPECT_THAT(to_shader_test(one), Not(HasSubstr("probe ssbo float")));
    one.kernel.outputs.front().allowed = {{.low = 1, .high = 2, .nan = true}};
    EXPECT_THAT(to_shader_test(one), Not(HasSubstr("probe ssbo float")));
    one.kernel.outputs.front().allowed = {{.low = 1, .high = infinity, .nan = false}};
    EXPECT_THAT(to_shader_test(one), AllOf(HasSubstr("probe ssbo float 1 0 >= 1\n"), Not(HasSubstr("<="))));
}

TEST(ShaderTest, AFragmentShaderDrawsGreen) {
    const std::string text = to_shader_test(replay(false));
    EXPECT_THAT(text, AllOf(HasSubstr("[vertex shader]\n#version 310 es\n"), HasSubstr("[fragment shader]\n"),
                            HasSubstr("uniform uint gloam_kernel_inputs[1] 4294967295\n"),
                            HasSubstr("uniform uint gloam_kernel_image0[3] 9\n"),
                            HasSubstr("draw rect -1 -1 2 2\nprobe all rgba 0.0 1.0 0.0 1.0\n"),
                            Not(HasSubstr("ssbo"))));
}

}  // namespace shader_test_test
}  // namespace gloam::report
