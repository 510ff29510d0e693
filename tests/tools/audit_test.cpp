// SPDX-License-Identifier: MIT
// `gloam audit FILE`.
#include <nlohmann/json.hpp>

#include "tools/expect.hpp"
#include "tools/installation.hpp"

namespace gloam::test::audit_test {

class AuditCommand : public InFolder {
  protected:
    std::string lit() {
        return write("lit.glsl",
                     "// <script>alert(1)</script>\n"
                     "float angle(vec3 n, vec3 l) { return acos(dot(n, l)); }\n"
                     "// x in [0, 1]\n"
                     "float curve(float x) { return x / (1.0 + x); }\n")
            .string();
    }
};

TEST_F(AuditCommand, SaysWhatGoesWrongAndWhere) {
    const CommandResult all = gloam("audit {} --inputs 2048", lit());
    EXPECT_EQ(all.status, 1) << "some input gives NaN";
    EXPECT_THAT(all.out, testing::StartsWith("lit.glsl: float angle(vec3 n, vec3 l)\n  n  "));
    EXPECT_THAT(all.out, HasSubstr("not finite"));
    EXPECT_THAT(all.out, HasSubstr("arises at lit.glsl:2 (acos)"));
    EXPECT_THAT(all.out, HasSubstr("acos(clamp(dot(n, l), -1.0, 1.0))"));
    EXPECT_THAT(all.out, HasSubstr("x               0 to 1 (comment)"));
    EXPECT_THAT(output_of(gloam("audit {} curve", lit())), HasSubstr("well            no input gives NaN"));
    EXPECT_EQ(gloam("audit {} curve --range x=-2:0", lit()).status, 1) << "it divides by zero at -1";
}

TEST_F(AuditCommand, RunsTheWorstInputsOnADevice) {
    const std::string report = path("audit.json").string();
    const CommandResult all = gloam("audit {} angle --device interpreter --json {}", lit(), report);
    EXPECT_EQ(all.status, 1);
    EXPECT_THAT(all.out, HasSubstr("NaN on interpreter"));
    const nlohmann::json function = nlohmann::json::parse(read_file(report)).at("functions").at(0);
    EXPECT_EQ(function.at("function"), "angle");
    EXPECT_EQ(function.at("broken"), true);
    EXPECT_EQ(function.at("domain").at(0).at("reason"), "name");
    const nlohmann::json finding = function.at("findings").at(0);
    EXPECT_EQ(finding.at("concern"), "not finite");
    EXPECT_EQ(finding.at("words").size(), 6U);
    EXPECT_EQ(finding.at("place").at("line"), 2);
    EXPECT_EQ(finding.at("devices").at(0).at("value"), "nan");
    // The words are a call of explain, which shows the same.
    std::string words;
    for (const auto& word : finding.at("words")) words += fmt::format(" 0x{:08x}", word.get<unsigned>());
    EXPECT_THAT(output_of(gloam("explain {} angle" + words, lit())), HasSubstr("nan"));
    expect_could_not_run(gloam("audit {} angle --device nothing-like-it", lit()), "nothing-like-it");
}

TEST_F(AuditCommand, WritesAPage) {
    const std::string page = path("audit.html").string();
    EXPECT_EQ(gloam("audit {} --inputs 512 --html {}", lit(), page).status, 1);
    const std::string html = read_file(page);
    EXPECT_THAT(html, HasSubstr("&lt;script&gt;alert(1)")) << "the source is text";
    EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
    EXPECT_THAT(html, HasSubstr("<span class=\"heat4\"><b>   2</b> float angle"));
    EXPECT_THAT(html, HasSubstr("domain = domain.and_words({0x"));
    EXPECT_THAT(html, HasSubstr("+ acos(clamp(dot(n, l), -1.0, 1.0))"));
}

TEST_F(AuditCommand, RefusesWhatItCannotAudit) {
    expect_could_not_run(gloam("audit {}", path("missing.glsl").string()), "missing.glsl");
    expect_could_not_run(gloam("audit {} none", lit()), "no function none; it defines: angle, curve");
    expect_could_not_run(gloam("audit {} --range y=0:1", lit()), "no parameter has this name");
    expect_could_not_run(gloam("audit {} --range x=1", lit()), "expected NAME=LOW:HIGH");
    expect_could_not_run(gloam("audit {} --inputs 1", lit()), "--inputs");
    expect_could_not_run(gloam("audit {} --html {}", lit(), "/no/such/folder/a.html"), "/no/such/folder");
    const std::string broken = write("broken.glsl", "float f(float x) { return y; }\n").string();
    const CommandResult result = gloam("audit {}", broken);
    EXPECT_EQ(result.status, 2);
    EXPECT_THAT(result.out, HasSubstr("f(float) was left out: it does not compile"));
}

}  // namespace gloam::test::audit_test
