// SPDX-License-Identifier: MIT
#include "shader/wgsl.hpp"

#include <fmt/format.h>

#include "shader/pack.hpp"
#include "shader/spirv.hpp"
#include "shader/steps.hpp"
#include "support.hpp"

namespace gloam::shader::wgsl_test {

// The functions of a text.
std::string functions_of(const std::string& glsl) {
    return translated({"f.glsl", pack({Source{"f.glsl", glsl}}, {}, {})}, Target::wgsl);
}

// What stands behind the first line of the last function.
std::string body_of(const std::string& glsl) {
    const std::string text = functions_of(glsl);
    const std::size_t head = text.rfind("\nfn ");
    return text.substr(text.find("{\n", head) + 2);
}

std::string shader_of(const std::string& rest) {
    return to_wgsl(compile({"s.comp", "#version 450\n" + rest}, {}));
}

std::string refusal_of(const std::string& glsl) {
    return message_of<WgslError>([&] { (void)shader_of(glsl); });
}

// An optimiser leaves such operations on constants.
TEST(Wgsl, TheBitsOfAConstantAreAnInteger) {
    const Spirv module = compile({"s.comp",
                                  "#version 450\nlayout(binding = 0) buffer B { uint u; };\n"
                                  "void main() { float x = 1.5; u = floatBitsToUint(x); }"},
                                 {});
    EXPECT_THAT(to_wgsl(with_passes(module, {"--eliminate-local-single-store"})),
                HasSubstr("bitcast<u32>(1.5f)"));
}

// Changed without a change of meaning, it has loops in `continue` parts, and indices that change behind them.
TEST(Wgsl, WhatMeansTheSameIsTranslatedAsWell) {
    const Spirv module = compile({"s.comp", R"(#version 450
        layout(binding = 0) buffer B { float elements[]; };
        float sum_of(uint count) {
            float sum = 0.0;
            for (uint i = 0u; i < count; ++i) sum += elements[i];
            return sum;
        }
        void main() {
            uint at = gl_GlobalInvocationID.x;
            float sum = sum_of(at);
            elements[at] = sum > 1.0 ? sum : sin(sum);
        })"},
                                 {});
    for (int seed = 1; seed <= 40; ++seed)
        EXPECT_NO_THROW((void)to_wgsl(taken(fmt::format("metamorphic {}", seed), {.module = module})))
            << seed;
}

// What a function is about, its text, and its body in WGSL.
struct Body {
    const char* name;
    const char* glsl;
    const char* wgsl;
};
constexpr Body bodies[] = {
    {"ExpressionsAreWrittenWhereTheyAreUsed",
     "float f(vec2 v, float s) { float t = v.x * s; return max(t, -v.y) / (t - (s - 1.0)); }",
     "    let t = v.x * s;\n    return max(t, -v.y) / (t - (s - 1.0));\n}\n"},
    {"AValueIsReadBeforeItsVariableChanges",
     "float f(float x) { float a = x; float b = a++ * a; return a - b; }",
     "    var a = x;\n    let t = a;\n    a += 1.0;\n    let b = t * a;\n    return a - b;\n}\n"},
    {"CountsOfBitsAreSignedAsInTheText1", "int f(uint x) { return bitCount(x); }",
     "    return bitcast<i32>(countOneBits(x));\n}\n"},
    {"CountsOfBitsAreSignedAsInTheText2", "int f(int x) { return bitCount(x); }",
     "    return countOneBits(x);\n}\n"},
    {"CountsOfBitsAreSignedAsInTheText3", "int f(uint x) { return findMSB(x); }",
     "    return bitcast<i32>(firstLeadingBit(x));\n}\n"},
    {"BracketsKeepTheOrder1", "float f(float a, float b, float c) { return a - (b - c) * (a / (b / c)); }",
     "    return a - (b - c) * (a / (b / c));\n}\n"},
    {"BracketsKeepTheOrder2", "uint f(uint a, uint b) { return ((a & b) | (a ^ 3u)) + (b << 2u); }",
     "    return ((a & b) | (a ^ 3u)) + (b << 2u);\n}\n"},
    {"BracketsKeepTheOrder3", "bool f(float a, bool b, bool c) { return (a > 1.0 || b) && !c; }",
     "    return (a > 1.0 || b) && !c;\n}\n"},
    // Without brackets WGSL reads `a < b, c > d` as a list of types.
    {"BracketsKeepTheOrder4", "float f(float a, float b) { return a < b ? float(a > 2.0) : 3.0; }",
     "    return select(3.0, select(0.0, 1.0, a > 2.0), a < b);\n}\n"},
    {"LoopsAreTheseOfTheText",
     "int f(int n) { int s = 0; for (int i = 1; i < n; i += 2) { if (i == 5) continue; s += i; }"
     " while (s > 9 && n > 0) { s -= 3; if (s == 4) break; } do { ++s; } while (s < 3);"
     " return s; }",
     "    var s = 0;\n"
     "    for (var i = 1; i < n; i += 2) {\n"
     "        if (i == 5) {\n            continue;\n        }\n"
     "        s += i;\n    }\n"
     "    while (s > 9 && n > 0) {\n"
     "        s -= 3;\n"
     "        if (s == 4) {\n            break;\n        }\n    }\n"
     "    loop {\n        s += 1;\n        continuing {\n            break if !(s < 3);\n        }\n    "
     "}\n"
     "    return s;\n}\n"},
    {"CasesThatFallThroughAreRepeated",
     "int f(int n) { int s = n; switch (n) { case 1: case -2: s = 7; case 3: s *= 2; break;"
     " default: s = 0; } return s; }",
     "    var s = n;\n"
     "    switch (n) {\n"
     "        case 1, -2: {\n            s = 7;\n            s *= 2;\n        }\n"
     "        case 3: {\n            s *= 2;\n        }\n"
     "        default: {\n            s = 0;\n        }\n    }\n"
     "    return s;\n}\n"},
    // A variable that is declared outside of a loop keeps its value from one round to the next.
    {"VariablesAreDeclaredWhereTheyKeepTheirValues",
     "float f(int n) { float last; float s = 0.0; for (int i = 0; i < n; ++i) {"
     " if (i == 0) last = 1.0; float x = last * 2.0; last = x; s += x; } return s; }",
     "    var s = 0.0;\n"
     "    var last: f32;\n"
     "    for (var i = 0; i < n; i += 1) {\n"
     "        if (i == 0) {\n            last = 1.0;\n        }\n"
     "        let x = last * 2.0;\n"
     "        last = x;\n        s += x;\n    }\n"
     "    return s;\n}\n"},
    {"TheBranchesOfAChoiceWithCallsStayBranches",
     "float g(float x) { return sin(x); } float f(float x) { float y = x > 0.0 ? g(x) : 1.0;"
     " return x < 9.0 && g(y) > 0.0 ? y : x; }",
     "    var y: f32;\n"
     "    if (x > 0.0) {\n        y = g(x);\n    } else {\n        y = 1.0;\n    }\n"
     "    return select(x, y, x < 9.0 && g(y) > 0.0);\n}\n"},
    {"ConstantParametersAreValues", "float f(const in float x, const in vec2 v) { return x * v.y; }",
     "    return x * v.y;\n}\n"},
    {"FunctionsWithTwoResultsGiveBoth1", "float f(float x, out float whole) { return modf(x, whole); }",
     "    let t = modf(x);\n    *whole = t.whole;\n    return t.fract;\n}\n"},
    {"FunctionsWithTwoResultsGiveBoth2",
     "uint f(uint a, uint b, out uint carry) { return uaddCarry(a, b, carry); }",
     "    let t = add_carry(a, b);\n    *carry = t.y;\n    return t.x;\n}\n"},
    {"NamesThatWgslKeepsAreChanged",
     "float f(float target, float abs_) { float from = target; { float step = from * abs_;"
     " return step + abs(from); } }",
     "    let from_ = target_;\n    let step = from_ * abs_;\n    return step + abs(from_);\n}\n"}};

class WgslBody : public testing::TestWithParam<Body> {};

TEST_P(WgslBody, IsThatOfTheText) {
    EXPECT_EQ(body_of(GetParam().glsl), GetParam().wgsl);
}

INSTANTIATE_TEST_SUITE_P(Functions, WgslBody, testing::ValuesIn(bodies),
                         [](const auto& info) { return info.param.name; });

TEST(Wgsl, OutputsArePointersAndOtherParametersAreNot) {
    EXPECT_THAT(
        functions_of("void g(inout float a, out vec2 b, float c) { c += a; a = c; b = vec2(c); }\n"
                     "float f(float x) { float y = x; vec2 z; g(y, z, 3.0); return y + z.x; }"),
        AllOf(HasSubstr("fn g(a: ptr<function, f32>, b: ptr<function, vec2f>, c_given: f32) {\n"
                        "    var c = c_given;\n    c += *a;\n    *a = c;\n    *b = vec2f(c);\n}\n"),
              HasSubstr("    var y = x;\n    var z: vec2f;\n    g(&y, &z, 3.0);\n    return y + z.x;\n")));
}

TEST(Wgsl, WhatWgslLacksIsWrittenByHelpers) {
    EXPECT_THAT(functions_of("bool f(vec3 v, float x) { return any(isnan(v)) || isinf(x); }"),
                AllOf(HasSubstr("fn is_nan_vec3(x: vec3f) -> vec3<bool> {\n    return (bitcast<vec3u>(x) & "
                                "vec3u(0x7fffffffu)) > vec3u(0x7f800000u);\n"),
                      HasSubstr("any(is_nan_vec3(v)) || is_inf(x)")));
    EXPECT_EQ(body_of("float f() { return uintBitsToFloat(0x7f800000u); }"),
              "    return float_of_bits(0x7f800000u);\n}\n");
    EXPECT_EQ(
        body_of("float f(float x, inout int e) { return ldexp(frexp(x, e), -e) + mod(x, 2.0); }"),
        "    let t = frexp(x);\n    *e = t.exp;\n    return ldexp(t.fract, -(*e)) + float_mod(x, 2.0);\n}\n");
    EXPECT_EQ(body_of("int f(int a, int b) { return (a % b) >> 2; }"),
              "    return int_mod(a, b) >> 2u;\n}\n");
}

constexpr const char* resources = R"(
layout(local_size_x = 8, local_size_y = 4) in;
layout(binding = 2, r32f) uniform readonly image2D depth;
layout(binding = 1, rgba16f) uniform writeonly image2D result;
layout(binding = 4) uniform sampler2D sampled;
layout(set = 1, binding = 0, std430) buffer Counts { uint least; uint of_tile[]; } counts;
layout(constant_id = 3) const uint taps = 2u;
layout(push_constant) uniform Parameters { vec3 eye; float radius; ivec2 size; };
shared float row[8];
void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    row[gl_LocalInvocationID.x] = imageLoad(depth, pixel).x * radius;
    barrier();
    atomicMin(counts.least, uint(pixel.x) + taps);
    counts.of_tile[1] += uint(counts.of_tile.length());
    imageStore(result, pixel, vec4(eye, row[0]) + texelFetch(sampled, pixel, 0) * float(imageSize(depth).x + size.x));
}
)";

TEST(Wgsl, ResourcesHaveTheirBindings) {
    const std::string text = shader_of(resources);
    EXPECT_THAT(text, HasSubstr("@id(3) override taps: u32 = 2u;\n"
                                "@group(0) @binding(1) var result: texture_storage_2d<rgba16float, write>;\n"
                                "@group(0) @binding(2) var depth: texture_2d<f32>;\n"
                                "@group(0) @binding(4) var sampled: texture_2d<f32>;\n"
                                "@group(1) @binding(0) var<storage, read_write> counts: Counts;\n"));
    EXPECT_THAT(text, HasSubstr("@group(2) @binding(0) var<uniform> parameters: Parameters;\n"));
    EXPECT_THAT(text, HasSubstr("var<workgroup> row: array<f32, 8>;\n"));
    EXPECT_THAT(text, HasSubstr("struct Counts {\n    least: atomic<u32>,\n    of_tile: array<u32>,\n}\n"));
    EXPECT_THAT(text, HasSubstr("@compute @workgroup_size(8, 4)\nfn main("));
}

TEST(Wgsl, ResourcesAreReadAndWritten) {
    EXPECT_THAT(
        shader_of(resources),
        AllOf(HasSubstr("    row[gl_LocalInvocationID.x] = textureLoad(depth, pixel, 0).x * "),
              HasSubstr("    workgroupBarrier();\n    atomicMin(&counts.least, u32(pixel.x) + taps);\n"),
              HasSubstr("arrayLength(&counts.of_tile)"), HasSubstr("vec2i(textureDimensions(depth)).x")));
}

TEST(Wgsl, BranchesByConstantsAreLeftOut) {
    const std::string text = shader_of(
        "layout(local_size_x = 1) in; layout(binding = 0) buffer B { float x; } b;\n"
        "void main() { if (false) b.x = 1.0; else b.x = 2.0; if (true && b.x > 3.0)"
        " b.x = 4.0; }");
    EXPECT_THAT(text,
                AllOf(Not(HasSubstr("1.0")), Not(HasSubstr("false")),
                      EndsWith("    b.x = 2.0;\n    if (b.x > 3.0) {\n        b.x = 4.0;\n    }\n}\n")));
}

TEST(Wgsl, WhatItCannotExpressIsOneLine) {
    const std::string head = "layout(local_size_x = 1) in;\n";
    EXPECT_EQ(
        refusal_of(head + "layout(binding = 0, rgba32f) uniform image2D i;\n"
                          "void main() { imageStore(i, ivec2(0), imageLoad(i, ivec2(1))); }"),
        "the image i is read and written in the format rgba32float: WGSL allows that for formats of one "
        "channel of 32 bits");
    EXPECT_EQ(refusal_of(head + "layout(binding = 0, rgb10_a2) uniform writeonly image2D i;\n"
                                "void main() { imageStore(i, ivec2(0), vec4(1.0)); }"),
              "the image i has a format that storage textures of WGSL lack");
    EXPECT_EQ(
        refusal_of(
            head +
            "layout(binding = 0, std140) uniform B { float x[4]; };\n"
            "layout(binding = 1) buffer C { float y; };\nvoid main() { y = x[gl_LocalInvocationID.x]; }"),
        "an array of f32 with a stride of 16 bytes: WGSL has 4");
    EXPECT_EQ(refusal_of(head + "layout(binding = 0) buffer B { double x; };\nvoid main() { x *= 2.0LF; }"),
              "floats of 64 bits");
}

std::string translated_fixture(const std::string& name) {
    const std::filesystem::path file = fixture("wgsl/" + name);
    return translated({name, pack(std::vector{file}, {}, {})}, Target::wgsl);
}

TEST(Wgsl, ImagesOfEveryKind) {
    const std::string text = translated_fixture("images.comp");
    EXPECT_THAT(
        text,
        AllOf(HasSubstr("@group(0) @binding(0) var line: texture_1d<f32>;\n"
                        "@group(0) @binding(14) var line_sampler: sampler;\n"),
              HasSubstr("var layers: texture_2d_array<f32>;\n"), HasSubstr("var volume: texture_3d<f32>;\n"),
              HasSubstr("var sky: texture_cube<f32>;\n"), HasSubstr("var skies: texture_cube_array<f32>;\n"),
              HasSubstr("var samples: texture_multisampled_2d<f32>;\n"),
              HasSubstr("var cells: texture_3d<u32>;\n"), Not(HasSubstr("cells_sampler")),
              HasSubstr("var volume_out: texture_storage_3d<r32float, write>;\n"),
              HasSubstr("var layers_out: texture_storage_2d_array<rgba16float, write>;\n")));
    EXPECT_THAT(text,
                AllOf(HasSubstr("textureSampleLevel(picture, picture_sampler, at.xy, 0.0)"),
                      HasSubstr("textureSampleLevel(apart, filtered, at.yx, 0.0)"),
                      HasSubstr("textureGather(1, picture, picture_sampler, at.xy)"),
                      HasSubstr("textureLoad(layers, cell.xy, cell.z, 0)"),
                      HasSubstr("textureLoad(samples, cell.xy, 2)"),
                      HasSubstr("vec3i(vec3u(textureDimensions(layers, 0), textureNumLayers(layers)))")));
}

TEST(Wgsl, AnExchangeIsRepeatedUntilItIsThatOfGlsl) {
    EXPECT_THAT(translated_fixture("exchange.comp"),
                AllOf(HasSubstr("    var exchange = atomicCompareExchangeWeak(&owner, 0u, key);\n"
                                "    while (!exchange.exchanged && exchange.old_value == 0u) {\n"
                                "        exchange = atomicCompareExchangeWeak(&owner, 0u, key);\n    }\n"),
                      HasSubstr("let place = &table.keys[slot + table.at[i & 3]];\n"),
                      HasSubstr("let before = exchange.old_value;\n")));
}

TEST(Wgsl, ExtensionsAreEnabled) {
    EXPECT_THAT(
        translated_fixture("half.comp"),
        AllOf(HasSubstr("\nenable f16;\n"), HasSubstr("scale: f16,\n    offset: vec2h,\n"),
              HasSubstr("fn curve(x: vec2h, most: ptr<function, f16>) -> vec2h {\n"),
              HasSubstr("(vec2h(3.0h) - x * 2.0h)"), HasSubstr("mat2x2h("), HasSubstr("var most = -1.5h;")));
    EXPECT_THAT(translated_fixture("subgroups.comp"),
                AllOf(HasSubstr("\nenable subgroups;\ndiagnostic(off, subgroup_uniformity);\n"),
                      HasSubstr("subgroupExclusiveAdd(x)"), HasSubstr("quadSwapDiagonal(x)"),
                      HasSubstr("@builtin(subgroup_size)")));
    EXPECT_THAT(functions_of("float f(float x) { return x; }"), Not(HasSubstr("enable")));
}

TEST(Wgsl, AFunctionOfTheUserMayHaveAStructureOfItsOwn) {
    EXPECT_THAT(
        functions_of("struct Hit { float at; }; Hit trace(vec3 ray);\n"
                     "float f(vec3 ray) { return trace(ray).at; }"),
        AllOf(HasSubstr("struct Hit {\n    at: f32,\n}\n"), HasSubstr("// fn trace(ray: vec3f) -> Hit\n")));
}

TEST(Wgsl, AMemoryBarrierIsPartOfTheBarrierBesideIt) {
    const auto text = [](const std::string& barriers) {
        return shader_of(
            "layout(local_size_x = 4) in; layout(binding = 0) buffer B { float x; } b; shared float s;\n"
            "void main() { s = b.x; " +
            barriers + " b.x = s; }");
    };
    const std::string shared = "    s = b.x;\n    workgroupBarrier();\n    b.x = s;\n";
    EXPECT_THAT(text("memoryBarrierShared(); barrier();"), HasSubstr(shared));
    EXPECT_THAT(text("barrier(); memoryBarrierShared();"), HasSubstr(shared));
    EXPECT_THAT(text("memoryBarrierBuffer(); memoryBarrierShared(); barrier();"),
                HasSubstr("    storageBarrier();\n    workgroupBarrier();\n"));
    EXPECT_THAT(message_of<WgslError>([&] { (void)text("memoryBarrierBuffer();"); }),
                HasSubstr("a barrier of memory alone"));
}

TEST(Wgsl, ImagesAndSamplersAsParameters) {
    EXPECT_THAT(
        functions_of("vec4 g(sampler2D a, vec2 at) { return texture(a, at); }\n"
                     "vec4 f(sampler2D a, sampler3D b, vec2 at) {"
                     " return g(a, at) + texelFetch(b, ivec3(at, 1), 0); }\n"),
        AllOf(HasSubstr("fn g(a: texture_2d<f32>, a_sampler: sampler, at: vec2f) -> vec4f {\n"
                        "    return textureSampleLevel(a, a_sampler, at, 0.0);\n"),
              HasSubstr("fn f(a: texture_2d<f32>, a_sampler: sampler, b: texture_3d<f32>, at: vec2f)"),
              HasSubstr("g(a, a_sampler, at)")));
    EXPECT_THAT(
        shader_of("layout(local_size_x = 1) in; layout(binding = 3) uniform sampler2D s;\n"
                  "layout(binding = 1) buffer B { vec4 x; };\n"
                  "vec4 f(sampler2D t) { return texture(t, vec2(0.5)); } void main() { x = f(s); }"),
        AllOf(HasSubstr("@group(0) @binding(4) var s_sampler: sampler;\n"), HasSubstr("f(s, s_sampler)")));
}

// Two kinds of refusal: what the language lacks, and what the translator does not know.
TEST(Wgsl, WhatItDoesNotTranslateItSays) {
    const std::string head = "#version 450\nlayout(local_size_x = 1) in;\n";
    const auto refusal = [&](const std::string& rest) {
        return message_of<std::invalid_argument>(
            [&] { (void)translated({"s.comp", head + rest}, Target::wgsl); });
    };
    EXPECT_EQ(
        refusal("layout(binding = 0) uniform sampler2DShadow s; layout(binding = 1) buffer B { float x; };\n"
                "void main() { x = textureLod(s, vec3(0.5), 0.0); }"),
        "s.comp: gloam does not translate to WGSL yet: a depth comparison, a projective read or derivatives "
        "of a texture");
    EXPECT_EQ(
        refusal("layout(binding = 0) uniform sampler2D s[2]; layout(binding = 1) buffer B { vec4 x; };\n"
                "void main() { x = texture(s[1], vec2(0.5)); }"),
        "s.comp: gloam does not translate to WGSL yet: an image or a sampler in an array");
    EXPECT_EQ(
        refusal("layout(constant_id = 0) const int n = 4; layout(binding = 1) buffer B { float x[n + 1]; };\n"
                "void main() { x[2] = 1.0; }"),
        "s.comp: WGSL cannot express an array whose length is a specialization constant, in a variable that "
        "is "
        "not shared");
    EXPECT_EQ(refusal("layout(binding = 0) buffer B { double x; };\nvoid main() { x *= 2.0LF; }"),
              "s.comp: WGSL cannot express floats of 64 bits");
}

// An optimised module has values of several blocks, and few names: the text is another one, but whole.
TEST(Wgsl, OptimizedModulesAreWrittenToo) {
    const Source source{"s.comp", std::string("#version 450\n") + resources};
    const std::string text = to_wgsl(compile(source, {.variant = variant("optimized")}));
    EXPECT_THAT(text, AllOf(HasSubstr("fn main("), HasSubstr("textureStore(")));
}

}  // namespace gloam::shader::wgsl_test
