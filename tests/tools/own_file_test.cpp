// SPDX-License-Identifier: MIT
// Somebody's shader file: `gloam check FILE` and `gloam explain`.
#include "tools/gloam.hpp"

namespace gloam::test::own_file_test {

class OwnFile : public InFolder {};

TEST_F(OwnFile, OpenGlRunsNoInvocationsTogether) {
    const fs::path shader =
        write("given.frag",
              "#version 300 es\nprecision mediump float;\nuniform sampler2D image;\nin vec2 uv;\n"
              "vec3 seen() { return texture(image, uv).rgb; }\n");
    const std::string report = path("opengl.json").string();
    const CommandResult opengl =
        gloam("check {} seen --inputs 64 --device es:llvmpipe-3.2 --json {}", shader, report);
    if (opengl.out.find("unsupported") == std::string::npos) return expect_could_not_run(opengl, "OpenGL");
    EXPECT_THAT(read_file(report),
                HasSubstr("runs in several invocations together, and OpenGL runs each alone"));
}

// `gloam audit FILE`.

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

TEST_F(AuditCommand, RunsTheWorstInputsOnADevice) {
    const std::string report = path("audit.json").string();
    const CommandResult all = gloam("audit {} angle --device interpreter --json {}", lit(), report);
    EXPECT_EQ(all.status, 1);
    EXPECT_THAT(all.out, HasSubstr("NaN on interpreter"));
    const json function = json::parse(read_file(report)).at("functions").at(0);
    EXPECT_EQ(function.at("function"), "angle");
    EXPECT_EQ(function.at("broken"), true);
    EXPECT_EQ(function.at("domain").at(0).at("reason"), "name");
    const json finding = function.at("findings").at(0);
    EXPECT_EQ(finding.at("concern"), "not finite");
    EXPECT_EQ(finding.at("words").size(), 6U);
    EXPECT_EQ(finding.at("place").at("line"), 2);
    EXPECT_EQ(finding.at("devices").at(0).at("value"), "nan");
    // The words are a call of explain, which shows the same.
    std::string words;
    for (const auto& word : finding.at("words")) words += fmt::format(" 0x{:08x}", word.get<unsigned>());
    EXPECT_THAT(output_of(gloam("explain {} angle" + words, lit())),
                HasSubstr("the first NaN is the result of lit.glsl:2, GLSL.std.450 Acos"));
}

}  // namespace gloam::test::own_file_test
