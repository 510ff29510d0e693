// SPDX-License-Identifier: MIT
#include "shader/internal/round_trip.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "disassembly.hpp"
#include "shader/internal/cross_text.hpp"
#include "shader/internal/float_controls.hpp"
#include "support.hpp"

namespace gloam::shader {
namespace round_trip_test {

using internal::round_trip;
using internal::to_glsl;
using internal::with_float_controls_of;
using test::Disassembly;
using test::kernel;
using test::message_of;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const Source with_names = kernel(R"(
#extension GL_EXT_spirv_intrinsics : require
spirv_execution_mode(extensions = ["SPV_KHR_float_controls"], capabilities = [4466], 4461, 32);
layout(constant_id = 7) const uint chosen = 3u;
layout(push_constant) uniform Run { uint first_word; float second_word; };
layout(std430, binding = 1) readonly buffer In { uint words[]; };
struct Pair { float lower; vec2 upper; };
float named_function(float x, inout vec2 changed) {
    changed *= x;
    return isnan(x) || x == uintBitsToFloat(0x7f800000u) ? 0.0 : x + float(chosen);
})",
                                 "named_function(uintBitsToFloat(words[first_word]) * second_word, seen)");

Spirv original() {
    Source source = with_names;
    source.text.replace(source.text.find("result[gl"), 0, "vec2 seen = vec2(1.0, 2.0); ");
    return compile(source, {});
}

TEST(RoundTrip, KeepsNamesBindingsAndConstants) {
    const std::string text = to_glsl(original());
    EXPECT_THAT(text, AllOf(HasSubstr("#version 450"), HasSubstr("named_function"), HasSubstr("second_word"),
                            HasSubstr("binding = 1"), HasSubstr("constant_id = 7"),
                            HasSubstr("layout(push_constant")));
    const Spirv back = round_trip(original(), Stage::compute, "test", Variant::Through::glsl);
    EXPECT_NO_THROW(validate(back));
    EXPECT_NE(back, original());
    EXPECT_THAT(disassemble(back), AllOf(HasSubstr("%named_function"), HasSubstr("\"second_word\""),
                                         HasSubstr("SpecId 7"), HasSubstr("Binding 1")));
}

TEST(RoundTrip, FloatControlsSurvive) {
    const std::string back =
        disassemble(round_trip(original(), Stage::compute, "test", Variant::Through::glsl));
    EXPECT_THAT(back, AllOf(HasSubstr("OpExecutionMode %main SignedZeroInfNanPreserve 32"),
                            HasSubstr("OpCapability SignedZeroInfNanPreserve"),
                            HasSubstr("OpExtension \"SPV_KHR_float_controls\"")));
}

TEST(RoundTrip, FloatControlsAreNotMadeUp) {
    const Spirv plain = compile(kernel("", "1.0"), {});
    EXPECT_THAT(disassemble(round_trip(plain, Stage::compute, "test", Variant::Through::glsl)),
                Not(HasSubstr("Preserve")));
    EXPECT_EQ(with_float_controls_of(plain, plain), plain);
}

TEST(RoundTrip, FloatControlsAreThereOnce) {
    EXPECT_EQ(with_float_controls_of(original(), original()), original());
    const Spirv plain = compile(kernel("", "1.0"), {});
    const Spirv patched = with_float_controls_of(original(), plain);
    EXPECT_NO_THROW(validate(patched));
    EXPECT_EQ(with_float_controls_of(original(), patched), patched);
    EXPECT_GT(patched.size(), plain.size());
}

TEST(RoundTrip, ServesEveryStage) {
    const Source vertex{"v",
                        "#version 450\nlayout(location = 1) out vec2 uv;\n"
                        "void main() { uv = vec2(0.5); gl_Position = vec4(0.0); }\n"};
    const Source fragment{"f",
                          "#version 450\nlayout(location = 1) in vec2 uv;\nlayout(location = 0) out vec4 c;\n"
                          "void main() { c = gl_FragCoord * uv.x; }\n"};
    const Variant variant = shader::variant("round_trip");
    EXPECT_THAT(disassemble(compile(vertex, {.stage = Stage::vertex, .variant = variant})),
                HasSubstr("OpEntryPoint Vertex"));
    EXPECT_THAT(disassemble(compile(fragment, {.stage = Stage::fragment, .variant = variant})),
                HasSubstr("OpEntryPoint Fragment"));
}

TEST(RoundTrip, WhatCannotBeWrittenIsSaid) {
    EXPECT_THAT(message_of<std::runtime_error>([] { (void)to_glsl({1, 2, 3}); }), HasSubstr("SPIRV-Cross"));
    EXPECT_THAT(message_of<CompileError>(
                    [] { (void)round_trip({1, 2, 3}, Stage::compute, "the test", Variant::Through::glsl); }),
                AllOf(HasSubstr("the test: "), HasSubstr("SPIRV-Cross cannot write the module as GLSL")));
}

}  // namespace round_trip_test
}  // namespace gloam::shader
