// SPDX-License-Identifier: MIT
// The snippets of docs/testing.md, which snippets.py makes tests of.
#include <gtest/gtest-spi.h>

#include "judge/matchers.hpp"
#include "pass/pass.hpp"
#include "support/lab.hpp"

namespace gloam::judge::guide_test {

using namespace pass;
using namespace subject;

subject::Lab guide_lab() {
    subject::LabOptions options = test::make_lab(FIXTURES "/guide").options();
    options.include_roots.emplace_back(GUIDE);
    return {std::move(options), test::SharedDevice::get()};
}

#include "snippets.inc"

TEST(Guide, AMatcherNamesTheWorstComponent) {
    testing::StringMatchResultListener words;
    EXPECT_FALSE(
        testing::ExplainMatchResult(WithinUlp(glm::dvec2(1, 2), 2), glm::vec2(1.0F, 2.00001F), &words));
    EXPECT_THAT(words.str(), HasSubstr("84 ulp off in component 1"));
    EXPECT_FALSE(testing::ExplainMatchResult(WithinUlp(glm::dvec2(1), 2), 1.0F, &words));
    EXPECT_THAT(words.str(), HasSubstr("1 numbers, expected 2"));
    const Answer failed{.error = "no driver"};
    EXPECT_NONFATAL_FAILURE(EXPECT_THAT(failed, Passes()), "no driver");
    testing::StringMatchResultListener none;
    EXPECT_FALSE(testing::ExplainMatchResult(Passes(), failed, &none));
    EXPECT_EQ(none.str(), "") << "GoogleTest shows the answer itself";
}

// The snippets of docs/copy-a-shader.md: near = 1, reversed, infinite far plane, so p22 = 0 and p32 = 1.
TEST(Guide, AnEnginesDepthAndLight) {
    const subject::Lab lab = guide_lab();
    const Function<float(float, float, float)> depth(lab, "engine.glsl", "engine_depth");
    EXPECT_EQ(depth(0.25F, 0.0F, 1.0F), 4.0F);
    EXPECT_EQ(depth(0.0F, 0.0F, 1.0F), INFINITY);
    const Function<glm::vec3(glm::vec3, glm::vec3, float)> light(lab, "engine.glsl", "engine_light");
    EXPECT_EQ(light(glm::vec3(4), glm::vec3(1), 0.75F), glm::vec3(2));
}

}  // namespace gloam::judge::guide_test
