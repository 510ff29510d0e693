// SPDX-License-Identifier: MIT
#include "module/support.hpp"
#include "module/texts.hpp"

namespace gloam::module::translate_test {

constexpr const char* functions = R"(// SPDX-License-Identifier: MIT
float fetch_depth(ivec2 pixel);
const vec2 CORNERS[2] = vec2[2](vec2(0.0, 1e18), vec2(1.0, 3.0));
vec2 twice(vec2 v) { return 2.0 * v; }
float twice(float x) {
    x *= 2.0;
    return x;
}
vec2 corner(int index, inout float depth) {
    return fetch_depth(ivec2(index)) > 0.0 ? twice(CORNERS[index]) * twice(depth) : vec2(0.0);
}
)";

constexpr const char* pass = R"(#version 450
layout(local_size_x = 8) in;
layout(binding = 0, r32f) uniform readonly image2D depth_image;
layout(binding = 3, r32f) uniform writeonly image2D result_image;
layout(binding = 10, std430) buffer Lists { uint tiles[]; };
layout(constant_id = 5) const bool listed = false;
layout(push_constant) uniform Parameters { ivec2 size; } parameters;
float value_at(ivec2 pixel) { return imageLoad(depth_image, pixel).x; }
void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (listed) pixel.x = int(tiles[pixel.x]);
    if (pixel.x < parameters.size.x) imageStore(result_image, pixel, vec4(value_at(pixel)));
}
)";

std::string text_of(const std::string& glsl, Target target) {
    const std::string packed = pack({source::Source{"folder/some_file.comp", glsl}}, {}, {});
    return translated({"folder/some_file.comp", packed}, target);
}

TEST(Translate, AWholeShaderIsTheTextOfSpirvCross) {
    EXPECT_THAT(text_of(pass, Target::hlsl),
                AllOf(StartsWith("// HLSL of shader model 6.0 by SPIRV-Cross. "),
                      HasSubstr("float value_at(int2 pixel)\n"), HasSubstr("depth_image : register(t0"),
                      HasSubstr("result_image : register(u3"), HasSubstr("Lists : register(u10"),
                      HasSubstr("cbuffer Parameters : register(b0"), HasSubstr("[numthreads(8, 1, 1)]")));
    EXPECT_THAT(text_of(pass, Target::msl),
                AllOf(HasSubstr(" without fast math.\n"), HasSubstr("kernel void main0("),
                      HasSubstr("[[texture(3)]]"), HasSubstr("[[buffer(10)]]"), HasSubstr("[[buffer(11)]]")));
}

TEST(Translate, AFileOfFunctionsHasThemAll) {
    for (const Target target : {Target::hlsl, Target::msl}) {
        const std::string text = text_of(functions, target);
        EXPECT_THAT(text, StartsWith("// SPDX-License-Identifier: MIT\n// "));
        for (const char* head : {"float fetch_depth(", "float2 twice(", "float twice(", "float2 corner("})
            EXPECT_THAT(text, HasSubstr(head));
    }
}

TEST(Translate, EveryStage) {
    const source::Source fragment{
        "f.frag",
        "#version 450\nlayout(location = 1) in vec2 uv;\nlayout(location = 0) out vec4 c;\n"
        "void main() { c = gl_FragCoord * uv.x; }\n"};
    EXPECT_THAT(translated(fragment, Target::hlsl, source::Stage::fragment), HasSubstr("SV_Target0"));
    EXPECT_THAT(translated(fragment, Target::msl, source::Stage::fragment),
                HasSubstr("fragment main0_out main0("));
}

TEST(Translate, WhatCannotBeTranslatedIsSaid) {
    EXPECT_THAT(
        message_of<std::invalid_argument>([] {
            (void)text_of("float f(sampler2D s) { return texture(s, vec2(0.0)).x; }\n", Target::hlsl);
        }),
        AllOf(HasSubstr("some_file.comp: f has a parameter of type sampler2D"), Not(HasSubstr("\n"))));
    const char* pointers =
        "#version 450\n#extension GL_EXT_buffer_reference : require\n"
        "layout(buffer_reference) buffer Far { float x; };\nlayout(push_constant) uniform P { Far at; };\n"
        "layout(local_size_x = 1) in;\nvoid main() { at.x = 1.0; }\n";
    EXPECT_THAT(
        message_of<std::invalid_argument>([&] { (void)translated({"far.comp", pointers}, Target::hlsl); }),
        HasSubstr("far.comp: SPIRV-Cross cannot write the module as HLSL"));
    EXPECT_THAT(message_of<source::CompileError>(
                    [] { (void)translated({"x", "#version 450\nfloat f() { return y; }\n"}, Target::hlsl); }),
                HasSubstr("y"));
}

}  // namespace gloam::module::translate_test
