// SPDX-License-Identifier: MIT
// The snippets of docs/testing.md. tests/house/guides.py compares the two.
#include "check/matchers.hpp"
#include "support/lab.hpp"

namespace gloam::check::guide_test {

Lab guide_lab() {
    return test::make_lab(std::string(FIXTURES) + "/guide");
}

TEST(Guide, ManyInputsAgainstAReference) {
    const Lab lab = guide_lab();
    // Begin: compare
    const Function<float(float)> tone(lab, "tone.glsl", "tone_reinhard");
    const auto reinhard = [](double x) { return x / (1.0 + x); };
    const Answer answer = tone.compare(reinhard, {log_uniform(1e-6, 1e6)}, {.ulp = 4});
    EXPECT_TRUE(answer.passed()) << answer;
    // End
}

TEST(Guide, OneCall) {
    const Lab lab = guide_lab();
    // Begin: call
    const Function<float(float)> tone(lab, "tone.glsl", "tone_reinhard");
    EXPECT_EQ(tone(0.0F), 0.0F);
    EXPECT_EQ(tone(1.0F), 0.5F);
    // End
}

TEST(Guide, HalfPrecision) {
    const Lab lab = guide_lab();
    // Begin: numbers
    const Function<Float16(Float16)> halved(lab, "halved.glsl", "halved");
    EXPECT_EQ(halved(0.25F), 0.125F);
    EXPECT_THAT(halved.check_rules({uniform(0, 1, shader::Scalar::float16_)}), Passes());
    // End
}

// Begin: matchers
TEST(Guide, Matchers) {
    const Lab lab = guide_lab();
    const Function<float(float)> tone(lab, "tone.glsl", "tone_reinhard");
    EXPECT_THAT(tone(0.3F), WithinUlp(0.3 / 1.3, 2));
    EXPECT_THAT(tone.check_rules({uniform(0, 1)}), Passes());
}

template <class T>
class Doubled : public testing::Test {};
using Types = testing::Types<float, glm::vec2, glm::vec4>;
TYPED_TEST_SUITE(Doubled, Types);

TYPED_TEST(Doubled, IsTwiceTheValue) {
    const Lab lab = guide_lab();
    const Function<TypeParam(TypeParam)> doubled(lab, "doubled.glsl", "doubled");
    EXPECT_EQ(doubled(TypeParam(1.5F)), TypeParam(3.0F));
}
// End

TEST(Guide, AMatcherNamesTheWorstComponent) {
    testing::StringMatchResultListener words;
    EXPECT_FALSE(
        testing::ExplainMatchResult(WithinUlp(glm::dvec2(1, 2), 2), glm::vec2(1.0F, 2.00001F), &words));
    EXPECT_THAT(words.str(), HasSubstr("84 ulp off in component 1"));
    EXPECT_FALSE(testing::ExplainMatchResult(WithinUlp(glm::dvec2(1), 2), 1.0F, &words));
    EXPECT_THAT(words.str(), HasSubstr("1 numbers, expected 2"));
    const Answer failed{.error = "no driver"};
    EXPECT_FALSE(testing::ExplainMatchResult(Passes(), failed, &words));
}

TEST(Guide, Quads) {
    const Lab lab = guide_lab();
    // Begin: quad
    const Function<Quad<float>(Quad<float>)> coverage(lab, "edge.glsl", "edge_coverage");
    const Quad<float> across = coverage(Quad<float>{{-0.5F, 0.5F, -0.5F, 0.5F}});
    EXPECT_EQ(across[0], 0.15625F);
    EXPECT_EQ(across[1], 0.84375F);
    const Answer answer = coverage.check_rules({neighbours(type_of<float>(), uniform(-10, 10))});
    EXPECT_TRUE(answer.passed()) << answer;
    // End
}

TEST(Guide, Groups) {
    const Lab lab = guide_lab();
    // Begin: group
    const Function<Group<float, 64>(Group<float, 64>)> mean(lab, "mean.glsl", "group_mean");
    Group<float, 64> values{};
    values[5] = 32.0F;
    EXPECT_THAT(mean(values), Each(0.5F));
    const Answer answer = mean.check_rules({vector(64, uniform(0, 1))}, {.inputs = 256});
    EXPECT_TRUE(answer.passed()) << answer;
    // End
}

TEST(Guide, Domains) {
    const Lab lab = guide_lab();
    const Function<float(float)> tone(lab, "tone.glsl", "tone_reinhard");
    const auto reinhard = [](double x) { return x / (1.0 + x); };
    // Begin: domain
    const Domain domain{log_uniform(1e-6, 1e6).and_near({1.0}).and_value(0.0F)};
    const Answer answer =
        tone.compare(reinhard, domain, {.ulp = 4, .absolute = 1e-30}, {.inputs = 4096, .seed = 7});
    EXPECT_TRUE(answer.passed()) << answer;
    // End
}

// Begin: struct
struct Lamp {
    glm::vec3 color;
    float power;
};

TEST(Guide, StructsAndOutParameters) {
    const Lab lab = guide_lab();
    const Function<glm::vec3(Lamp, float, Out<float>)> radiance(lab, "lamp.glsl", "lamp_radiance");
    const auto [color, falloff] = radiance(Lamp{{1, 2, 4}, 8.0F}, 1.0F);
    EXPECT_EQ(color, glm::vec3(4, 8, 16));
    EXPECT_EQ(falloff, 0.5F);
}
// End

TEST(Guide, Images) {
    const Lab lab = guide_lab();
    // Begin: image
    const Function<float(glm::ivec2)> slope(lab, "slope.glsl", "slope_x");
    const auto ramp = [](glm::ivec2 pixel) { return 3.0F * static_cast<float>(pixel.x); };
    const ImageSet images{{"fetch_height", make_image<float>({5, 5}, ramp, Border::clamp)}};
    EXPECT_EQ(slope.with_images(images, {glm::ivec2(2, 2)}), 3.0F);
    EXPECT_EQ(slope.with_images(images, {glm::ivec2(0, 2)}), 1.5F);  // the edge, clamped
    // End
}

TEST(Guide, Properties) {
    const Lab lab = guide_lab();
    const Function<float(float)> tone(lab, "tone.glsl", "tone_reinhard");
    // Begin: property
    const PropertyResult below =
        tone.property({uniform(0, 1000)}, [](float x, float y) { return y <= x && y < 1.0F; });
    EXPECT_TRUE(below) << below;
    // End
    // Begin: many
    std::vector<std::tuple<float>> inputs;
    for (int i = 0; i < 10'000; ++i) inputs.emplace_back(0.01F * static_cast<float>(i));
    const std::vector<float> values = tone(inputs);  // one dispatch for all
    EXPECT_TRUE(std::is_sorted(values.begin(), values.end()));
    EXPECT_LT(values.back(), 1.0F);
    // End
}

TEST(Guide, WholePasses) {
    const Lab lab = guide_lab();
    // Begin: pass
    const Pass blur(lab, "blur.comp");
    const auto step = [](glm::ivec2 pixel) { return pixel.x < 8 ? 0.0F : 1.0F; };
    const PassInputs inputs{{"source", make_image<float>({16, 4}, step)}, {"radius", 1}};
    const PassResult out = blur.run(inputs);
    const auto wanted = [](glm::ivec2 pixel) { return std::clamp((pixel.x - 6) / 3.0, 0.0, 1.0); };
    const ImageComparison same = out.image("result").compare(make_image<float>({16, 4}, wanted), 1e-7);
    EXPECT_TRUE(same) << same;
    // End
}

// The snippets of docs/copy-a-shader.md: near = 1, reversed, infinite far plane, so p22 = 0 and p32 = 1.
TEST(Guide, AnEnginesDepthAndLight) {
    const Lab lab = guide_lab();
    const Function<float(float, float, float)> depth(lab, "engine.glsl", "engine_depth");
    EXPECT_EQ(depth(0.25F, 0.0F, 1.0F), 4.0F);
    EXPECT_EQ(depth(0.0F, 0.0F, 1.0F), INFINITY);
    const Function<glm::vec3(glm::vec3, glm::vec3, float)> light(lab, "engine.glsl", "engine_light");
    EXPECT_EQ(light(glm::vec3(4), glm::vec3(1), 0.75F), glm::vec3(2));
}

// The guide's text on a budget that is too narrow.
TEST(Guide, ANarrowBudgetFailsAndSaysWhere) {
    const Lab lab = guide_lab();
    const auto other = [](double x) { return x / (1.0 + 1.001 * x); };
    const Answer answer = Function<float(float)>(lab, "tone.glsl", "tone_reinhard")
                              .compare(other, {log_uniform(1e-6, 1e6)}, {.ulp = 4});
    EXPECT_FALSE(answer.passed());
    std::ostringstream text;
    text << answer;
    EXPECT_THAT(text.str(), HasSubstr("tone_reinhard"));
}

}  // namespace gloam::check::guide_test
