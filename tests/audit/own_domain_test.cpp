// SPDX-License-Identifier: MIT
// What the inputs of a function of a file are drawn from.
#include "audit/audited.hpp"

namespace gloam::audit::own_domain_test {

std::vector<std::string> described(const std::vector<OrdinaryValues>& all) {
    std::vector<std::string> texts;
    for (const OrdinaryValues& values : all)
        texts.push_back(values.parameter + ": " + values.text + " (" + values.reason + ")");
    return texts;
}

TEST(OrdinaryValues, FollowRangeCommentNameArrayAndType) {
    EXPECT_THAT(described(fixture().values("meanings", {{"count", {2.0, 9.0}}, {"lamp.radius", {1.0, 2.0}}})),
                ElementsAre("lamp.color: 0 to 1 (name)", "lamp.radius: 1 to 2 (--range)", "uv: 0 to 1 (name)",
                            "view_dir: unit vectors (name)", "rotation: unit quaternions (name)",
                            "NdotL: 0 to 1 (name)", "other: -1000 to 1000, half of them 0 to 1 (type)",
                            "count: 2 to 9 (--range)", "t: 2 to 3 (comment)"));
    EXPECT_THAT(described(fixture().values("table")),
                ElementsAre("index: 0 to 3 (array)", "second: false, true (type)"));
}

TEST(OrdinaryValues, DescribeArraysSamplersAndWhatStandsAtFileScope) {
    const Audited file(
        "uniform sampler2D image;\nuniform float exposure;\nstruct Lamp { vec3 color; };\n"
        "float f(float weights[3], Lamp lamps[2], vec2 uv) {\n"
        "    return textureLod(image, uv, 0.0).x * exposure * lamps[0].color.x / (weights[0] + weights[1] + "
        "weights[2]);\n"
        "}\n");
    EXPECT_THAT(described(file.values("f", {{"weights", {0.0, 1.0}}})),
                ElementsAre("weights: 3 of 0 to 1 (--range)", "lamps: 2 of 0 to 1 (name)",
                            "uv: 0 to 1 (name)", "exposure: 0.001 to 1000 (name)"));
    const Audit audit = file.audit("f", {{"weights", {0.0, 1.0}}});
    const AuditFinding* const finding = find(audit, Concern::not_finite);
    ASSERT_NE(finding, nullptr) << to_text(audit);
    EXPECT_THAT(finding->values, StartsWith("weights = (0, 0, 0), lamps[0].color = ("));
    EXPECT_THAT(finding->values, HasSubstr("exposure = 1"));
}

TEST(OrdinaryValues, ReadComments) {
    const auto of = [](const std::string& comment) {
        return described(Audited(comment + "float f(float x, vec3 q) { return x + q.x; }").values("f"));
    };
    EXPECT_THAT(of("/* q: -2 .. 2;\n   x >= 5. */\n"),
                ElementsAre("x: 5 to 1000 (comment)", "q: -2 to 2 (comment)"));
    EXPECT_THAT(of("// x in [0, 1]\n\nfloat g() { return 1.0; }\n"), Contains(HasSubstr("x: -1000")))
        << "not above f";
    struct Row {
        const char *comment, *a, *b, *v, *w;  // "": nothing is said of it
    };
    for (const Row& row :
         {Row{"Maps a to [0, 1].", "", "", "", ""},
          {"a in (0, 2pi], w one unit vector", "1.401298e-45 to 6.283185", "", "", "unit vectors"},
          {"a is positive, b in [3, 1]", "0.001 to 1000", "", "", ""},
          {"Wraps a to [-pi, pi]; a to 0 .. 1", "", "", "", ""},
          {"Remaps a from [b, 2] to [0, 1].", "", "", "", ""},
          {"the root of a, which gives [0, 1]", "", "", "", ""},
          {"a, b in [0, 1]", "0 to 1", "0 to 1", "", ""},
          {"a and b in [0, 1], w: direction", "0 to 1", "0 to 1", "", "unit vectors"},
          {"v, w: unit vectors", "", "", "unit vectors", "unit vectors"},
          {"the sine between unit vectors v and w", "", "", "unit vectors", "unit vectors"},
          {"0 <= a <= 1, 0 < b < 1", "0 to 1", "1.401298e-45 to 0.9999999", "", ""},
          {"0 < a; b > 2", "1.401298e-45 to 1000", "2 to 1000", "", ""},
          {"b between 0 and 1", "", "0 to 1", "", ""},
          {"a non-negative, b not positive", "0 to 1000", "", "", ""},
          {"a in [-PI/2, PI/2], b: -2*pi to 2pi", "-1.570796 to 1.570796", "-6.283185 to 6.283185", "",
           ""}}) {
        const auto values =
            Audited("// " + std::string(row.comment) +
                    "\nfloat f(float a, float b, vec3 v, vec3 w) { return a + b + v.x + w.x; }")
                .values("f");
        const char* said[] = {row.a, row.b, row.v, row.w};
        for (std::size_t i = 0; i < values.size(); ++i)
            EXPECT_EQ(values[i].reason == "comment" ? values[i].text : "", said[i])
                << row.comment << " " << values[i].parameter;
    }
    for (const char* text : {"float f(float x /* 0 to 4 */) { return x; }",
                             "uniform float k;\n// x in [0, 4]\nfloat\nf(float x) { return x * k; }"})
        EXPECT_THAT(described(Audited(text).values("f")), Contains("x: 0 to 4 (comment)"));
}

TEST(OrdinaryValues, AreAnyWordWhereTheTextTakesItApart) {
    const std::string parts = "uint mixed(float x, uint a) { return a ^ (a >> 16); }\n";
    for (const char* text : {
             "float f(uint w) { return float((w & 0x8000u) << 16); }",
             "uint f(uint w) { return w >> 10; }",
             "uint f(uint w) { return 255u & w; }",
             "float f(uint w) { return uintBitsToFloat(w); }",
             "vec2 f(uint w) { return unpackHalf2x16(w); }",
             "uint f(uvec2 w) { return w.x >> 4u; }",
             "uint f(uint w) { return mixed(1.0, w); }",
             "uint f(uint w) { w ^= w >> 3; return w; }",
             "uint f(uint w) { uint s = w + 1u; uint t = s; return t >> 2; }",
             "uint f(uint w) { uint n = w & 3u, s = 0u; for (uint i = 0u; i < n; ++i) s += i; return s; }",
         })
        EXPECT_THAT(described(Audited(parts + text).values("f")), ElementsAre("w: 0 to 4294967295 (bits)"))
            << text;
    for (const char* text :
         {"uint f(uint w) { return mixed(2.0, 3u) << w; }", "uint f(uint w) { return w + 1u; }",
          "bool f(uint w) { return w > 1u && w < 3u; }", "uint f(int w) { return uint(w) & 1u; }",
          "uint f(uint w) { uint s = 0u; for (uint i = 0u; i < w; ++i) s += w & 1u; return s; }"})
        EXPECT_THAT(described(Audited(parts + text).values("f")), ElementsAre("w: 0 to 7 (type)")) << text;
    const char* property =
        "bool test_f(uint w, int i, uint n) { for (uint k = 0; k < n; ++k) ++i; return i > 0; }";
    EXPECT_THAT(
        described(Audited(property).values("test_f")),
        ElementsAre("w: 0 to 4294967295, half of them 0 to 7 (property)",
                    "i: -2147483648 to 2147483647, half of them 0 to 7 (property)", "n: 0 to 7 (type)"));
}

TEST(OrdinaryValues, DrawNoSubnormalNumbers) {
    const auto own = fixture().function("gamma_curve");
    const Domain domain = ordinary_domain(own.function, fixture().values("gamma_curve"));
    const Domain::Inputs inputs = domain.draw(512, 1);
    for (std::size_t i = 0; i < inputs.count(); ++i)
        EXPECT_NE(std::fpclassify(from_word<float>(inputs.row(i)[0])), FP_SUBNORMAL);
}

}  // namespace gloam::audit::own_domain_test
