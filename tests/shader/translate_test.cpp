// SPDX-License-Identifier: MIT
#include "shader/pack.hpp"
#include "support.hpp"

namespace gloam::shader::translate_test {

constexpr const char* functions = R"(// SPDX-License-Identifier: MIT
// What the file is about.

// Where a point lies.
struct Place {
    vec2 uv;      // texture coordinates
    float depth;  // world units,
                  // positive
};

// Defined by the user: depth of a pixel.
float fetch_depth(ivec2 pixel);

// Half of the corners.
const vec2 CORNERS[2] = vec2[2](vec2(0.0, 1e18), vec2(1.0, 3.0));

// A vector twice as long: the double.
vec2 twice(vec2 v) { return 2.0 * v; }

// A number twice as large.
float twice(float x) {
    x *= 2.0;
    return x;
}

// A corner, or zero.
// index: of the corner.
vec2 corner(int index, Place place) {
    bool inside = place.depth > 0.0 && index >= 0 && fetch_depth(ivec2(index)) > 0.0;
    return inside ? twice(CORNERS[index]) * twice(place.depth) : vec2(0.0);
}
)";

constexpr const char* pass = R"(#version 450
layout(local_size_x = 8) in;
layout(binding = 0, r32f) uniform readonly image2D depth_image;  // world units
layout(binding = 3, r32f) uniform writeonly image2D result_image;
layout(binding = 10, std430) buffer Lists { uint tiles[]; };
layout(constant_id = 5) const bool listed = false;
layout(push_constant) uniform Parameters {
    ivec2 size;  // of all images
} parameters;

// What to store.
float value_at(ivec2 pixel) { return imageLoad(depth_image, pixel).x; }

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (listed) pixel.x = int(tiles[pixel.x]);
    if (pixel.x < parameters.size.x) imageStore(result_image, pixel, vec4(value_at(pixel)));
}
)";

std::string text_of(const std::string& glsl, Target target) {
    const std::string packed = pack({Source{"folder/some_file.comp", glsl}}, {}, {});
    return translated({"folder/some_file.comp", packed}, target);
}

TEST(Translate, AFileOfFunctionsStaysOne) {
    for (const Target target : {Target::hlsl, Target::msl}) {
        const std::string text = text_of(functions, target);
        EXPECT_THAT(text, StartsWith("// SPDX-License-Identifier: MIT\n"));
        EXPECT_THAT(text, AllOf(HasSubstr("\n// What the file is about.\n"), Not(HasSubstr("main")),
                                Not(HasSubstr("WorkGroup")), Not(HasSubstr("gloam_argument"))));
        EXPECT_THAT(text, HasSubstr("// A corner, or zero.\n// index: of the corner.\n" +
                                    std::string(target == Target::msl ? "static inline " : "") +
                                    "float2 corner(int index, Place place"));
        EXPECT_THAT(text, Not(HasSubstr("param")));
    }
}

TEST(Translate, CommentsAreThoseOfTheirOwnOverload) {
    EXPECT_THAT(text_of(functions, Target::hlsl),
                AllOf(HasSubstr("// A vector twice as long: the double.\nfloat2 twice(float2 v)\n"),
                      HasSubstr("// A number twice as large.\nfloat twice(")));
}

// The caller's variable does not change, and a number can be given.
TEST(Translate, AChangedParameterIsStillNoOutput) {
    EXPECT_THAT(text_of(functions, Target::hlsl),
                HasSubstr("float twice(float x_given)\n{\n    float x = x_given;\n    x *= 2.0f;"));
    const char* passed_on =
        "void grow(inout float x) { x += 1.0; }\nfloat f(float y) { grow(y); return y; }\n";
    EXPECT_THAT(text_of(passed_on, Target::msl), HasSubstr("static inline float f(float y_given)\n"));
}

TEST(Translate, MembersKeepTheirComments) {
    for (const Target target : {Target::hlsl, Target::msl}) {
        EXPECT_THAT(
            text_of(functions, target),
            HasSubstr("// Where a point lies.\nstruct Place\n{\n    float2 uv;  // texture coordinates\n"
                      "    // world units,\n    // positive\n    float depth;\n};\n"));
    }
}

TEST(Translate, WhatTheUserDefinesIsDeclared) {
    EXPECT_THAT(text_of(functions, Target::hlsl),
                HasSubstr("// Defined by the user: depth of a pixel.\nfloat fetch_depth(int2 pixel);\n"));
    EXPECT_THAT(text_of(functions, Target::msl),
                AllOf(HasSubstr("\nstruct GloamImages;"),
                      HasSubstr("\nfloat fetch_depth(int2 pixel, thread const GloamImages& gloam_images);\n"),
                      HasSubstr("corner(int index, Place place, thread const GloamImages& gloam_images)"),
                      HasSubstr("fetch_depth(int2(index), gloam_images)")));
}

TEST(Translate, ConstantsKeepTheirNames) {
    EXPECT_THAT(text_of(functions, Target::hlsl),
                HasSubstr("// Half of the corners.\nstatic const float2 CORNERS[2] = { float2(0.0f, 1e+18f), "
                          "float2(1.0f, 3.0f) };"));
    EXPECT_THAT(text_of(functions, Target::msl), HasSubstr("CORNERS[index]"));
}

// HLSL before 2021 would fetch in any case.
TEST(Translate, ConditionsAreWrittenAsTheyWere) {
    EXPECT_THAT(text_of(functions, Target::hlsl), HasSubstr("fetch_depth(index.xx) > 0.0f;\n    }\n"));
    EXPECT_THAT(text_of(functions, Target::msl),
                HasSubstr(" && (fetch_depth(int2(index), gloam_images) > 0.0);"));
    const std::string cheap = "bool f(float a, float b) { return a > 0.0 || max(a, b) < -2.0; }\n";
    EXPECT_THAT(text_of(cheap, Target::hlsl), AllOf(HasSubstr(" || (max("), Not(HasSubstr("else"))));
}

TEST(Translate, APassNamesItsRegisters) {
    EXPECT_THAT(
        text_of(pass, Target::hlsl),
        AllOf(HasSubstr("\n// Registers: b0 Parameters, t0 depth_image, u3 result_image, u10 Lists.\n"),
              HasSubstr("depth_image : register(t0, space0);  // world units\n"),
              HasSubstr("parameters_size : packoffset(c0);  // of all images\n"),
              HasSubstr("#define GLOAM_LISTED false\n"), HasSubstr("[numthreads(8, 1, 1)]\nvoid main("),
              HasSubstr("// What to store.\nfloat value_at(int2 pixel)\n")));
}

TEST(Translate, APassNamesItsIndices) {
    EXPECT_THAT(
        text_of(pass, Target::msl),
        AllOf(HasSubstr("\n// Indices: buffer(10) lists, buffer(11) parameters, texture(0) depth_image, "
                        "texture(3) result_image.\n"),
              HasSubstr("kernel void some_file_main("), HasSubstr("listed_tmp [[function_constant(5)]]"),
              HasSubstr("    int2 size;  // of all images\n")));
}

// texelFetch() needs no sampler, texture() does.
TEST(Translate, OnlySamplersThatAreUsedAreDeclared) {
    const std::string text = R"(#version 450
layout(local_size_x = 8) in;
layout(binding = 0) uniform sampler2D fetched;
layout(binding = 1) uniform sampler2D filtered;
layout(binding = 2, r32f) uniform writeonly image2D result_image;
float fetch(ivec2 pixel) { return texelFetch(fetched, pixel, 0).x; }
float smoothed(vec2 uv) { return textureLod(filtered, uv, 0.0).x; }
void main() { imageStore(result_image, ivec2(0), vec4(fetch(ivec2(1)) + smoothed(vec2(0.5)))); }
)";
    EXPECT_THAT(
        text_of(text, Target::hlsl),
        HasSubstr("\n// Registers: s1 _filtered_sampler, t0 fetched, t1 filtered, u2 result_image.\n"));
    EXPECT_THAT(text_of(text, Target::msl),
                AllOf(HasSubstr("\n// Indices: sampler(1) filteredSmplr, texture(0) fetched, "),
                      HasSubstr("float fetch(int2 pixel, texture2d<float> fetched)\n"),
                      Not(HasSubstr("fetchedSmplr"))));
}

TEST(Translate, EveryStage) {
    const Source fragment{"f.frag",
                          "#version 450\nlayout(location = 1) in vec2 uv;\nlayout(location = 0) out vec4 c;\n"
                          "void main() { c = gl_FragCoord * uv.x; }\n"};
    EXPECT_THAT(translated(fragment, Target::hlsl, Stage::fragment), HasSubstr("SV_Target0"));
    EXPECT_THAT(translated(fragment, Target::msl, Stage::fragment), HasSubstr("fragment f_main_out f_main("));
}

TEST(Translate, WhatCannotBeTranslatedIsSaid) {
    EXPECT_THAT(
        message_of<std::invalid_argument>([] {
            (void)text_of("float f(sampler2D s) { return texture(s, vec2(0.0)).x; }\n", Target::hlsl);
        }),
        AllOf(HasSubstr("some_file.comp: f has a parameter of type sampler2D"), Not(HasSubstr("\n"))));
    EXPECT_THAT(message_of<std::invalid_argument>(
                    [] { (void)text_of("double f(double x) { return 2.0LF * x; }\n", Target::msl); }),
                HasSubstr("some_file.comp: MSL has no double"));
    const char* pointers =
        "#version 450\n#extension GL_EXT_buffer_reference : require\n"
        "layout(buffer_reference) buffer Far { float x; };\nlayout(push_constant) uniform P { Far at; };\n"
        "layout(local_size_x = 1) in;\nvoid main() { at.x = 1.0; }\n";
    EXPECT_THAT(
        message_of<std::invalid_argument>([&] { (void)translated({"far.comp", pointers}, Target::hlsl); }),
        HasSubstr("far.comp: SPIRV-Cross cannot write the module as HLSL"));
    EXPECT_THAT(message_of<CompileError>(
                    [] { (void)translated({"x", "#version 450\nfloat f() { return y; }\n"}, Target::hlsl); }),
                HasSubstr("y"));
}

TEST(Translate, TargetsHaveNames) {
    EXPECT_EQ(target_from("hlsl"), Target::hlsl);
    EXPECT_EQ(target_from("msl"), Target::msl);
    EXPECT_EQ(target_from("cg"), std::nullopt);
    EXPECT_EQ(suffix(Target::hlsl), ".hlsl");
    EXPECT_EQ(suffix(Target::msl), ".metal");
}
}  // namespace gloam::shader::translate_test
