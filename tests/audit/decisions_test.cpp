// SPDX-License-Identifier: MIT
// Decisions on inexact numbers.
#include "audit/audited.hpp"

namespace gloam::check::audit_decisions_test {

using audited::Audited;
using audited::find;

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

}  // namespace gloam::check::audit_decisions_test
