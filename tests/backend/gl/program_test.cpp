// SPDX-License-Identifier: MIT
#include "backend/gl/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "backend/gl/opened.hpp"

namespace gloam::gl {
namespace program_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;

class OpenGlProgram : public Opened {};

constexpr const char* head = "#version 300 es\nprecision highp float;\nout highp uvec4 target;\n";

TEST_F(OpenGlProgram, ARejectedTextIsNamedWithItsLine) {
    GLOAM_OPEN_OR_SKIP("es:llvmpipe-3.0");
    const ShaderText text{"wrong.frag", std::string(head) + "void main() {\n    target = vec3(1.0);\n}\n"};
    EXPECT_THAT(
        [&] { const Program program(device(), Program::Stage::fragment, text); },
        ThrowsMessage<CompileFailed>(AllOf(HasSubstr("wrong.frag: line 5: "), HasSubstr("error"),
                                           HasSubstr("[    target = vec3(1.0);]"), Not(HasSubstr("\n")))));
}

TEST_F(OpenGlProgram, WhatDoesNotLinkIsNamed) {
    GLOAM_OPEN_OR_SKIP("es:llvmpipe-3.0");
    const ShaderText text{
        "unlinked.frag",
        std::string(head) + "float missing(float x);\nvoid main() { target = uvec4(missing(1.0)); }\n"};
    EXPECT_THAT(
        [&] { const Program program(device(), Program::Stage::fragment, text); },
        ThrowsMessage<LinkFailed>(AllOf(HasSubstr("unlinked.frag: does not link: "), HasSubstr("missing"))));
}

TEST_F(OpenGlProgram, AVersionThatTheContextLacksIsRejected) {
    GLOAM_OPEN_OR_SKIP("gl:softpipe-3.3");
    const ShaderText text{"new.comp", "#version 450\nlayout(local_size_x = 1) in;\nvoid main() {}\n"};
    EXPECT_THROW(const Program program(device(), Program::Stage::compute, text), CompileFailed);
}

}  // namespace program_test
}  // namespace gloam::gl
