// SPDX-License-Identifier: MIT
// Vertex and fragment shaders in WGSL.
#include "shader/wgsl.hpp"
#include "support.hpp"
#include "support/matchers.hpp"

namespace gloam::shader::wgsl_stage_test {

using test::message_of;

std::string shader_of(const std::string& rest, Stage stage) {
    return to_wgsl(compile({"s.glsl", "#version 450\n" + rest}, {.stage = stage}));
}

// WGSL has y of the clip space up: the sign keeps the picture that Vulkan draws.
TEST(WgslStage, AVertexShaderGivesItsPositionAndItsOutputs) {
    EXPECT_THAT(
        shader_of("layout(location = 1) in vec3 at; layout(location = 0) out vec2 uv;\n"
                  "layout(location = 3) flat out uint number;\n"
                  "void main() { uv = at.xy; number = uint(gl_VertexIndex); gl_Position = vec4(at, 1.0); }",
                  Stage::vertex),
        AllOf(HasSubstr("var<private> uv: vec2f;\n"), HasSubstr("number = u32(gl_VertexIndex);\n"),
              HasSubstr("@location(0) uv: vec2f,\n    @location(3) @interpolate(flat) number: u32,\n"
                        "    @builtin(position) position: vec4f,\n"),
              HasSubstr("@vertex\nfn main(@location(1) at_given: vec3f, @builtin(vertex_index) "
                        "gl_VertexIndex_given: u32)"),
              HasSubstr(
                  "    at = at_given;\n    gl_VertexIndex = i32(gl_VertexIndex_given);\n    main_body();\n"),
              HasSubstr(".gl_Position * vec4f(1.0, -1.0, 1.0, 1.0));\n}\n")));
}

TEST(WgslStage, AFragmentShaderGivesItsOutputsAfterEveryReturn) {
    const std::string text = shader_of(
        "layout(location = 0) in vec3 shade; layout(location = 1) flat in uint number;\n"
        "layout(location = 2) noperspective in vec2 window; layout(location = 0) out vec4 color;\n"
        "layout(location = 1) out vec4 unset; layout(binding = 0) uniform sampler2D image;\n"
        "vec4 fetched() { return texelFetch(image, ivec2(gl_FragCoord.xy), 0); }\n"
        "void main() { color = vec4(shade, float(number) + window.x); if (number == 0u) return;\n"
        "if (!gl_FrontFacing) discard; color = fetched(); gl_FragDepth = 0.5; }",
        Stage::fragment);
    EXPECT_THAT(text,
                AllOf(HasSubstr("textureLoad(image, vec2i(gl_FragCoord.xy), 0)"), HasSubstr("discard;\n"),
                      HasSubstr("@location(0) color: vec4f,\n    @builtin(frag_depth) frag_depth: f32,\n"
                                "    @location(1) unset: vec4f,\n"),
                      HasSubstr("@fragment\nfn main("),
                      HasSubstr("@location(1) @interpolate(flat) number_given: u32"),
                      HasSubstr("@location(2) @interpolate(linear) window_given: vec2f"),
                      HasSubstr("@builtin(position) gl_FragCoord_given: vec4f"),
                      HasSubstr("@builtin(front_facing) gl_FrontFacing_given: bool"),
                      HasSubstr("    main_body();\n    return Outputs(color, gl_FragDepth, unset);\n}\n")));
    EXPECT_THAT(text, Not(HasSubstr("diagnostic")));
}

// Their results depend on the neighbours that run, so they stay where they stand.
TEST(WgslStage, DerivativesAreEvaluatedWhereTheyStand) {
    EXPECT_THAT(
        shader_of("layout(location = 0) in vec2 at; layout(location = 0) out vec4 color;\n"
                  "layout(binding = 0) uniform sampler2D image;\n"
                  "void main() { vec2 d = dFdx(at) + fwidth(at); vec4 t = texture(image, at);\n"
                  "vec4 b = texture(image, at, 1.5); color = at.x > 0.5 ? t + b : vec4(d, dFdyFine(at)); }",
                  Stage::fragment),
        AllOf(HasSubstr("diagnostic(off, derivative_uniformity);\n"), HasSubstr(" = dpdx(at);\n"),
              HasSubstr(" = fwidth(at);\n"), HasSubstr(" = textureSample(image, image_sampler, at);\n"),
              HasSubstr(" = textureSampleBias(image, image_sampler, at, 1.5);\n"),
              HasSubstr(" = dpdyFine(at);\n")));
}

TEST(WgslStage, WhatAStageCannotHaveIsOneLine) {
    const auto refusal = [](const std::string& glsl, Stage stage) {
        return message_of<WgslError>([&] { (void)shader_of(glsl, stage); });
    };
    EXPECT_EQ(refusal("layout(location = 0) out vec4 c; void main() { c = vec4(1.0); }", Stage::vertex),
              "a vertex shader that sets no gl_Position");
    EXPECT_EQ(refusal("layout(location = 0) in mat2 m; layout(location = 0) out vec4 c;\n"
                      "void main() { c = vec4(m[0], m[1]); }",
                      Stage::fragment),
              "an input or output of a stage that is no number or vector: m");
    EXPECT_EQ(refusal("layout(location = 0) centroid in vec4 m; layout(location = 0) out vec4 c;\n"
                      "void main() { c = m; }",
                      Stage::fragment),
              "a part of a location, or an interpolation within the pixel: m");
    EXPECT_EQ(refusal("layout(location = 0) out vec4 c; void main() { c = vec4(gl_PointCoord, 0.0, 1.0); }",
                      Stage::fragment),
              "the builtin value gl_PointCoord");
}

}  // namespace gloam::shader::wgsl_stage_test
