// SPDX-License-Identifier: MIT
// Where a function itself goes wrong. One that is sound, and NaN beyond its domain:
// tests/tools/stories/own_files.txt.
#include "audit/audited.hpp"
#include "audit/internal/search.hpp"

namespace gloam::audit::audit_test {

using testing::Field;

TEST(Audit, NamesTheOperationAndTheShareOfInputs) {
    const Audit audit = fixture().audit("undefined_root");
    const AuditFinding* const finding = find(audit, Concern::not_finite);
    ASSERT_NE(finding, nullptr);
    EXPECT_EQ(finding->values, "x = 0") << "the simplest input that shows it";
    EXPECT_NEAR(finding->share, 0.5, 0.08);
    EXPECT_EQ(finding->place.line, 6U);
}

// Zero to a power is zero on every driver, though Vulkan states no precision.
TEST(Audit, TellsUnspecifiedFromUndefined) {
    const Audit audit = fixture().audit("gamma_curve");
    EXPECT_EQ(find(audit, Concern::undefined), nullptr) << to_text(audit);
    const AuditFinding* const finding = find(audit, Concern::unspecified);
    ASSERT_NE(finding, nullptr);
    EXPECT_EQ(finding->values, "x = 0");
    EXPECT_FALSE(audit.is_broken());
    EXPECT_NE(find(fixture().audit("gamma_curve", {{"x", {-1.0, 1.0}}}), Concern::not_finite), nullptr)
        << "a negative number has no power";
}

// Random numbers are never there.
TEST(Audit, TriesMiddlesQuartersZerosAndDiagonals) {
    for (const char* text :
         {"float f(vec2 uv) { vec2 p = uv * 2.0 - 1.0; return atan(p.y, p.x); }",
          "vec2 f(vec2 uv) { return normalize(uv + uv - vec2(1.0)); }",
          "// a in [0, 8], b in [-3, 1]\nvec2 f(float a, float b) { return normalize(vec2(a - 4, b + 1)); }",
          "vec2 f(vec2 uv) { return normalize(uv - vec2(0.3, 0.7)); }",
          "vec2 f(vec2 uv) { return normalize(uv * 5.0 - 2.0); }",
          "// a in [0, 4]\nvec3 f(vec3 a) { return normalize(a - 3.0); }",
          "// a in [-8, 8], b in [0, 1]\nfloat f(float a, float b) { return 1.0 / (abs(a - 4.0) + abs(b - "
          "0.75)); }",
          "float f(vec3 n) { return 1.0 / (abs(n.x - n.y) + abs(n.z)); }",
          "// a in [2, 6], b in [7, 11]\nvec2 f(float a, float b) { return normalize(sqrt(vec2(a, b)) - "
          "vec2(2, 3)); }",
          "// p in [0, 1]\nvec3 f(vec3 p) { return normalize(p * 4.0 - vec3(1.0, 2.0, 3.0)); }",
          "// n in [0, 65535]\nfloat f(uint n) { return 1.0 / (float(n) - 40000.0); }"}) {
        const Audit audit = Audited(text).audit("f", {}, 1024);
        EXPECT_TRUE(audit.is_broken()) << text << "\n" << to_text(audit);
    }
}

// The bounds of the two factors of a square include both signs; the square has one.
TEST(Audit, KnowsThatASquareIsNotNegative) {
    const std::string noise = "vec2 noise(vec2 uv) { return fract(sin(uv * 12.9898) * 43758.5453) - 0.5; }\n";
    for (const char* root : {"length(n)", "distance(n, vec2(0.1))", "sqrt(n.x * n.x)", "sqrt(dot(n, n))"}) {
        const Audit audit =
            Audited(noise + "float f(vec2 uv) { vec2 n = noise(uv); return " + root + "; }").audit("f");
        EXPECT_EQ(find(audit, Concern::undefined), nullptr) << to_text(audit);
    }
    EXPECT_NE(find(Audited(noise + "float f(vec2 uv) { return sqrt(noise(uv).x * noise(uv).y); }").audit("f"),
                   Concern::not_finite),
              nullptr);
}

// Near 0.5 some drivers have y at or below 0, but none of them takes the logarithm there.
TEST(Audit, BelievesAGuard) {
    const std::string y = "float f(float x) { float y = x / 3.0 * 3.0 - 0.5; ";
    const Ranges range{{"x", {0.5, 0.500001}}};
    const Audit guarded = Audited(y + "if (y > 0.0) return log2(y); return 0.0; }").audit("f", range);
    EXPECT_EQ(find(guarded, Concern::undefined), nullptr) << to_text(guarded);
    EXPECT_EQ(find(guarded, Concern::not_finite), nullptr) << to_text(guarded);
    const Audit inexact = Audited(y + "if (x > 0.5) return log2(y); return 0.0; }").audit("f", range);
    EXPECT_NE(find(inexact, Concern::undefined), nullptr)
        << "a quotient may be off by 2.5 ULP, and y then at or below 0";
}

TEST(Audit, FindsWhereDigitsAreLostAndWhatHelps) {
    const Audit lost = fixture().audit("cancelling", {{"x", {1.0, 1e4}}});
    const AuditFinding* const finding = find(lost, Concern::digits);
    ASSERT_NE(finding, nullptr) << to_text(lost);
    EXPECT_GT(finding->lost, 6.0);
    EXPECT_TRUE(finding->cancels);
    EXPECT_EQ(finding->place.line, 17U);
    EXPECT_EQ(finding->place.operation, "OpFSub");
    const auto line = std::ranges::find(lost.lines, 17U, &AuditLine::line);
    ASSERT_NE(line, lost.lines.end());
    EXPECT_GT(line->lost, 6.0);

    const Audit arc = fixture().audit("arc");
    EXPECT_THAT(arc.rewrites, Contains(AllOf(Field(&AuditRewrite::line, 22U),
                                             Field(&AuditRewrite::before, "sqrt(1.0 - x * x)"),
                                             Field(&AuditRewrite::after, "sqrt((1.0 - x) * (1.0 + x))"))))
        << to_text(arc);
}

// A loss is where the error grows by the largest factor, and what was never written where the function ends.
TEST(Audit, BlamesTheOperationAndNotWhatFollows) {
    const Audit lost = Audited(
                           "float f(float n, float a) {\n    float d = n * n * (a - 1.0) + 1.0;\n"
                           "    return a / (3.14159 * d * d);\n}\n")
                           .audit("f", {{"n", {0.0, 1.0}}, {"a", {1e-6, 1.0}}});
    ASSERT_NE(find(lost, Concern::digits), nullptr) << to_text(lost);
    EXPECT_EQ(find(lost, Concern::digits)->place.line, 2U) << to_text(lost);
    EXPECT_EQ(find(lost, Concern::drivers)->place.line, 2U) << to_text(lost);
    const Audit unwritten = Audited(
                                "bool f(float x, out float t) {\n    if (x < 0.0) return false;\n    t = "
                                "sqrt(x);\n    return true;\n}\n")
                                .audit("f", {{"x", {-1.0, 1.0}}});
    ASSERT_NE(find(unwritten, Concern::undefined), nullptr) << to_text(unwritten);
    EXPECT_EQ(to_text(find(unwritten, Concern::undefined)->place), "audit.glsl:2 (\"t\" was never written)");
}

TEST(Audit, FindsWhereAPropertyIsFalse) {
    const Audited audited(
        "// x in [0, 1]\nbool test_small(float x) { return x < 0.9; }\n"
        "bool is_small(float x) { return x < 0.9; }\n");
    const Audit audit = audited.audit("test_small");
    ASSERT_NE(find(audit, Concern::is_false), nullptr) << to_text(audit);
    EXPECT_NEAR(find(audit, Concern::is_false)->share, 0.1, 0.05);
    EXPECT_TRUE(audit.is_broken());
    EXPECT_FALSE(audited.audit("is_small").is_broken());
}

TEST(Audit, FindsHowFarDriversMayBeApart) {
    const Audit audit = fixture().audit("arc");
    const AuditFinding* const finding = find(audit, Concern::drivers);
    ASSERT_NE(finding, nullptr);
    EXPECT_LE(finding->permitted.low, finding->exact);
    EXPECT_GE(finding->permitted.high, finding->exact);
    EXPECT_GT(finding->permitted.high - finding->permitted.low, 1e-5);
}

TEST(Audit, FindsFaultsAndWhatNothingReaches) {
    const Audit fault = fixture().audit("table");
    ASSERT_NE(find(fault, Concern::fault), nullptr) << to_text(fault);
    EXPECT_EQ(find(fault, Concern::fault)->values, "index = 3, second = true");
    EXPECT_THAT(find(fault, Concern::fault)->message, HasSubstr("element 4 of 4"));
    EXPECT_TRUE(fault.is_broken());
    EXPECT_THAT(
        missed(fixture().audit("unreached").coverage),
        testing::UnorderedElementsAre(HasSubstr("audit.glsl:32: never true"), HasSubstr("audit.glsl:33")));
    EXPECT_THAT(
        find(Audited("float spin(float x) { while (x < 2.0) x *= 1.0; return x; }").audit("spin", {}, 64),
             Concern::fault)
            ->message,
        HasSubstr("instructions"));
}

TEST(Audit, IsThatOfAFunctionInCpp) {
    const Lab lab = test::make_lab(FIXTURES);
    const judge::Function<float(float)> root(lab, "audit.glsl", "undefined_root");
    EXPECT_FALSE(audit::audit(root, {uniform(51, 52)}, {.inputs = 512}).is_broken());
    EXPECT_TRUE(audit::audit(root, {uniform(0, 100)}, {.inputs = 512}).is_broken());
}

// Decisions on inexact numbers.

TEST(AuditDecisions, ADerivativeOfSomeInvocationsIsUndefined) {
    const Ranges ranges{{"x", {0.4, 0.6}}};
    const Audited some("float f(float x) { if (x > 0.5) return dFdx(x); return 0.0; }");
    EXPECT_NE(find(some.audit("f", ranges, 512), Concern::undefined), nullptr);
    const Audited all("float f(float x) { return fwidth(x); }");
    EXPECT_EQ(find(all.audit("f", ranges, 512), Concern::undefined), nullptr);
}

// (x + 0.1) - 0.1 is x in double, and less for some floats.
TEST(AuditDecisions, FollowsADecisionOnAnInexactNumberBothWays) {
    const auto parting = [](const std::string& text, const Ranges& ranges = {}) {
        const Audit audit = Audited(text).audit("f", ranges);
        const AuditFinding* const finding = find(audit, Concern::parting);
        EXPECT_FALSE(audit.is_broken()) << to_text(audit);
        return finding == nullptr ? AuditFinding{} : *finding;
    };
    const AuditFinding compared =
        parting("float f(float x) { return (x + 0.1) - 0.1 < x ? 1.0 : 2.0; }", {{"x", {0.0, 1.0}}});
    EXPECT_GT(compared.share, 0.05);
    EXPECT_EQ(compared.place.line, 1U);
    EXPECT_EQ(std::abs(compared.value - compared.exact), 1.0);
    const AuditFinding counted = parting(
        "float f(float a) { float n = 0.0; for (float i = a; i < a + 10.0; i += 1.0) n += 1.0; return n; }",
        {{"a", {0.0, 1.0}}});
    EXPECT_GT(counted.share, 0.02);
    const AuditFinding equal =
        parting("float f(float x) { return x / 3.0 * 3.0 == x ? 1.0 : 0.0; }", {{"x", {1.0, 2.0}}});
    EXPECT_GT(equal.share, 0.2);
    const AuditFinding whole =
        parting("int f(float x) { return int(x / 10.0 * 10.0); }", {{"x", {1.0, 100.0}}});
    EXPECT_EQ(std::abs(whole.value - whole.exact), 1.0);
    EXPECT_GT(whole.place.line, 0U);
    for (const char* decimal :
         {"int f(float x) { return int(x * 10.0); }", "int f(float x) { return int(x / 0.1); }",
          "bool f(float x) { return fract(x * 10.0) < 0.5; }",
          "float f(float x) { return x * 10.0 >= 7.0 ? 1.0 : 0.0; }"})
        EXPECT_EQ(parting(decimal, {{"x", {0.0, 1.0}}}).place.line, 1U) << decimal;
    const AuditFinding index = parting(
        "const float TABLE[4] = float[4](0.0, 1.0, 2.0, 3.0);\n"
        "float f(int i) { return TABLE[int(mod(float(i), 4.0))]; }",
        {{"i", {0.0, 64.0}}});
    EXPECT_TRUE(std::isnan(index.exact)) << "mod(4.0, 4.0) may be 4.0";
    for (const char* exact : {"float f(float x) { return x < 0.5 ? 1.0 : 2.0; }",
                              "float f(float x) { return x * 2.0 < 0.5 ? 1.0 : 2.0; }",
                              "float f(float x) { return abs(x / 3.0); }"})
        EXPECT_EQ(parting(exact, {{"x", {0.0, 1.0}}}).share, 0.0) << exact;
}

// The ways of mod(6.0, 6.0) are 0 and 6, and both are red.
TEST(AuditDecisions, TakesNothingBetweenTwoWholeNumbers) {
    for (const char* text :
         {"float f(float h) { return clamp(abs(mod(h * 6.0, 6.0) - 3.0) - 1.0, 0.0, 1.0); }",
          "float f(float h) { float t = fract(h * 6.0); t = t * t * (3.0 - 2.0 * t); return t * (1.0 - t) + "
          "1.0; }"}) {
        const Audit audit = Audited(text).audit("f", {{"h", {0.0, 1.0}}});
        const AuditFinding* const differ = find(audit, Concern::drivers);
        EXPECT_LT(differ == nullptr ? 0.0 : differ->lost, 5.0) << to_text(audit);
        EXPECT_EQ(find(audit, Concern::parting), nullptr) << to_text(audit);
    }
}

// What is tried.

std::vector<std::string> afters(const std::string& text) {
    std::vector<std::string> all;
    for (const auto& [place, change] : internal::candidates_of(text)) all.push_back(change.after);
    return all;
}

TEST(Rewrites, AreNotFoundWhereTheTextMeansAnotherThing) {
    EXPECT_THAT(afters("return y * 1.0 - cos(x);"), Not(Contains(HasSubstr("sin("))))
        << "the one belongs to a product";
    EXPECT_THAT(afters("y = a.x * a.x - b.x * b.x;"), ElementsAre("((a.x - b.x) * (a.x + b.x))"));
    EXPECT_THAT(afters("y = pow(f(a, b), 2.0);"), Contains("((f(a, b)) * (f(a, b)))"));
    for (const char* text : {"y = c - a * a - b * b;", "float acos(float x) { return x; }", "acos("})
        EXPECT_THAT(afters(text), IsEmpty()) << text;
}

TEST(Rewrites, Help) {
    const std::tuple<const char*, const char*, Ranges> rows[] = {
        // a function f, the change of its text
        {"float f(float x) { return 1.0 - cos(x); }",
         "(2.0 * sin(0.5 * (x)) * sin(0.5 * (x)))",
         {{"x", {0, 3}}}},
        {"vec3 f(vec3 d) { return normalize(d); }",
         "((d) * inversesqrt(max(dot(d, d), 1.17549435e-38)))",
         {{"d", {-1, 1}}}},
        {"float f(float x) { return log(1.0 + x); }", "log_of_1_plus(x)", {{"x", {0, 0.01}}}},
        {"float f(float x) { return exp(x) - 1.0; }", "exp_minus_1(x)", {{"x", {0, 0.01}}}},
        {"float f(float a, float b) { return a * a - b * b; }",
         "((a - b) * (a + b))",
         {{"a", {1, 2}}, {"b", {1, 2}}}},
        {"float f(float x) { return pow(x, 2.0); }", "((x) * (x))", {{"x", {-2, 2}}}},
        {"float f(float x) { return pow(1.0 - x, 5.0); }",
         "((1.0 - x) * (1.0 - x) * (1.0 - x) * (1.0 - x) * (1.0 - x))",
         {{"x", {0, 1}}}},
        {"float f(float x) { return pow(x, 3.); }", "((x) * (x) * (x))", {{"x", {0, 4}}}},
        {"float f(vec3 d) { return length(d); }", "scaled_length(d)", {{"d", {1e18, 1e22}}}},
        {"float f(float x) { return sin(x); }", "sin(within_pi(x))", {{"x", {-6, 6}}}},
        {"float f(float x) { return smoothstep(1.0, 0.0, x); }",
         "smoothstep(-(1.0), -(0.0), -(x))",
         {{"x", {0, 1}}}}};
    for (const auto& [text, after, ranges] : rows) {
        const Audit audit = Audited(text).audit("f", ranges);
        EXPECT_THAT(audit.rewrites, Contains(Field(&AuditRewrite::after, after))) << to_text(audit);
    }
}

// A rewrite that changes what the function means is none, even if it loses fewer digits.
TEST(Rewrites, KeepTheMeaning) {
    const Audit hash =
        Audited("float f(vec2 uv) { return fract(sin(dot(uv, vec2(12.9898, 78.233))) * 43758.5453); }")
            .audit("f");
    EXPECT_NE(find(hash, Concern::digits), nullptr);
    EXPECT_THAT(hash.rewrites, IsEmpty()) << to_text(hash);
}

}  // namespace gloam::audit::audit_test
