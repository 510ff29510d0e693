// SPDX-License-Identifier: MIT
// Functions whose inputs are more than vectors of floats: arrays, nested structures, float16, uniforms and
// buffers, samplers, and images that they load and store.
#include "interpreter/program.hpp"
#include "judge/explain.hpp"
#include "judge/function.hpp"
#include "subject/fixture_functions.hpp"

namespace gloam::subject::own_values_test {

using namespace judge;

// Values that C++ gives.

using Row = std::array<float, 4>;

TEST(OwnTypes, ArraysGoInAndOutOfAKernel) {
    const Lab lab = test::make_lab(FIXTURES);
    const Function<float(Row, Row)> dot(lab, "arrays.glsl", "array_dot");
    EXPECT_EQ(dot(Row{1, 2, 3, 4}, Row{1, 10, 100, 1000}), 4321.0F);
    using Wide = std::array<std::array<float, 3>, 2>;
    using High = std::array<std::array<float, 2>, 3>;
    const Function<High(Wide)> transposed(lab, "arrays.glsl", "array_transposed");
    EXPECT_EQ(transposed(Wide{{{1, 2, 3}, {4, 5, 6}}}), (High{{{1, 4}, {2, 5}, {3, 6}}}));
    using Two = std::array<glm::vec2, 2>;
    const Function<void(Two, Out<std::array<float, 2>>, std::array<int, 3>&)> split(lab, "arrays.glsl",
                                                                                    "array_split");
    const auto [x, counts] = split(Two{glm::vec2(1, 2), glm::vec2(3, 4)}, std::array{10, 20, 30});
    EXPECT_EQ(x, (std::array<float, 2>{1, 3}));
    EXPECT_EQ(counts, (std::array{10, 21, 32}));
    EXPECT_THAT([&] { (void)Function<float(std::array<float, 3>, Row)>(lab, "arrays.glsl", "array_dot"); },
                testing::ThrowsMessage<std::invalid_argument>(
                    AllOf(HasSubstr("float[3], float[4]"), HasSubstr("float[4] a, float[4] b"))));
}

struct Light {
    glm::vec3 position;
    std::array<float, 2> weights;
};
struct Scene {
    std::array<Light, 2> lights;
    glm::mat2 turn;
};

TEST(OwnTypes, StructuresHoldArraysOfStructures) {
    const Lab lab = test::make_lab(FIXTURES);
    const Function<Scene(Scene, float)> swapped(lab, "arrays.glsl", "array_swapped");
    const Scene scene{{Light{{1, 2, 3}, {4, 5}}, Light{{6, 7, 8}, {9, 10}}}, glm::mat2(11, 12, 13, 14)};
    const Scene result = swapped(scene, 2.0F);
    EXPECT_EQ(result.lights[0].position, glm::vec3(6, 7, 8));
    EXPECT_EQ(result.lights[1].weights, (std::array<float, 2>{8, 5}));
    EXPECT_EQ(result.turn, scene.turn);
}

struct Halves {
    glm::vec<2, Float16> h;
    float f;
};

TEST(OwnTypes, Float16GoesInAndOutOfAKernel) {
    const Lab lab = test::make_lab(FIXTURES);
    const Function<Float16(Float16, Float16)> halves(lab, "numbers.glsl", "half_sum");
    EXPECT_EQ(halves(2048.0F, 1.0F), 2048.0F) << "rounded to float16";
    const auto sum = [](double a, double b) { return a + b; };
    const Answer doubled = halves.compare(sum, {uniform(0, 1000), constant(0.0F)}, {}, {.inputs = 512});
    EXPECT_TRUE(doubled.passed()) << "the reference has the halves that the shader has" << doubled;
    const Function<Halves(Halves, std::array<Float16, 2>)> all(lab, "numbers.glsl", "halves_changed");
    const Halves result = all(Halves{{0.5F, 3.0F}, 0.25F}, std::array<Float16, 2>{7.0F, 1.5F});
    EXPECT_EQ(result.h.x, 0.75F);
    EXPECT_EQ(result.h.y, 4.5F);
    EXPECT_EQ(result.f, 7.25F);
    expect_error<std::invalid_argument>(
        [&] { (void)Function<float(float, float)>(lab, "numbers.glsl", "half_sum"); },
        {"float16_t half_sum(float16_t a, float16_t b)"});
    expect_error<backend::Unsupported>(
        [&] { (void)Function<float(float)>(lab, "numbers.glsl", "double_inside"); },
        {"double is not judged: gloam judges float"});
}

TEST(OwnTypes, ArraysAreComparedWithAReference) {
    const Lab lab = test::make_lab(FIXTURES);
    using DoubleRow = std::array<double, 4>;
    const auto reference = [](DoubleRow a, DoubleRow b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
    };
    const Values row = vector(4, uniform(0, 1));
    for (const auto& [name, right] : {std::pair{"array_dot", true}, {"array_dot_wrong", false}}) {
        const Answer answer = Function<float(Row, Row)>(lab, "arrays.glsl", name)
                                  .compare(reference, {row, row}, {.ulp = 8}, {.inputs = 512});
        EXPECT_EQ(answer.passed(), right) << answer;
    }
    const Lab file(options_of("arrays.glsl"), test::SharedDevice::get());
    EXPECT_TRUE(answer_of(file, "arrays.glsl", "array_large", {}, 8).passed());
}

TEST(OwnTypes, UniformsHaveTheValuesThatWereDrawn) {
    const Lab lab(options_of("uniforms.glsl"), test::SharedDevice::get());
    const auto run_one = [&](const char* name, const std::vector<float>& inputs) {
        const OwnFunction own = function_of("uniforms.glsl", name);
        std::vector<Word> words;
        for (const float input : inputs) words.push_back(to_word(input));
        return lab.kernel("uniforms.glsl", name, own.signature()).run(words, 1).outputs;
    };
    // x; then exposure, bias
    EXPECT_THAT(run_one("exposed", {2, 10, 7, 5}), ElementsAre(to_word(25.0F)));
    EXPECT_THAT(run_one("timed", {2, 4}), ElementsAre(to_word(8.0F)));
    EXPECT_THAT(run_one("sum", {2, 4}), ElementsAre(to_word(24.0F)));
    EXPECT_THAT(
        describe_inputs(function_of("uniforms.glsl", "timed").signature(), {to_word(0.5F), to_word(5.0F)}),
        AllOf(StartsWith("float "), HasSubstr(", float iTime ")));
    const std::vector<Word> shaded = run_one("shade", {1, 2, 3, 4, 5, 6});
    EXPECT_THAT(shaded, testing::SizeIs(4));
    EXPECT_THAT(shaded, testing::IsSupersetOf({to_word(1.0F), to_word(2.0F)}));
}

// An index, texel or pixel outside is not judged; the other inputs of the same kernel are.
TEST(OwnTypes, WhatIsOutsideIsTheInputsFault) {
    struct Outside {
        const char* file;
        const char* function;
        const char* variant = "shipped";
        Ranges ranges = {};
        bool undefined = true;
    };
    for (const auto& [file, function, variant, ranges, undefined] :
         {Outside{"undefined.glsl", "undefined_table", "literals"},
          {"undefined.glsl", "undefined_table", "specialization"},
          {"own_images.glsl", "loaded"},
          {"samplers.glsl", "fetched"},
          {"samplers.glsl", "fetched", "shipped", {{"p", {0, 3}}}, false},
          {"samplers.glsl", "fetched_beside", "shipped", {{"p", {1, 2}}}, false}}) {
        const Lab lab(options_of(file, module::variant(variant)), test::SharedDevice::get());
        const Answer answer = answer_of(lab, file, function, ranges);
        EXPECT_EQ(answer.undefined > 0, undefined) << function;
        EXPECT_EQ(answer.undefined, answer.recorded()) << function;
        EXPECT_LT(answer.undefined, answer.inputs()) << function;
        EXPECT_EQ(answer.outside(), 0U) << answer;
    }
    const Lab lab(options_of("own_images.glsl"), test::SharedDevice::get());
    EXPECT_THROW((void)answer_of(lab, "own_images.glsl", "loaded", {{"p", {0, 7}}, {"picture", {0, 1}}}),
                 interpreter::Error)
        << "all inputs are in ranges that were given";
    EXPECT_TRUE(answer_of(lab, "own_images.glsl", "size_of", {}, 64).passed());
    EXPECT_TRUE(answer_of(lab, "own_images.glsl", "height", {{"p", {0, 3}}}, 5000).passed())
        << "more inputs than an image has layers";
}

TEST(OwnTypes, Float16IsDrawnFromItsFormat) {
    const Lab lab(options_of("numbers.glsl"), test::SharedDevice::get());
    const Question question = question_of(lab, function_of("numbers.glsl", "half_sum"), {});
    std::set<double> found;
    bool nan = false;
    for (const Word word : Domain({question.domain.parameters().front()}).draw(4000, 1).words) {
        const auto value = from_word<double>(word);
        nan = nan || std::isnan(value);
        if (std::isnan(value)) continue;
        found.insert(value);
        EXPECT_EQ(numeric::float16.round_down(value), value);
    }
    EXPECT_TRUE(nan);
    for (const double special : numeric::special_values(numeric::float16))
        EXPECT_TRUE(std::isnan(special) || found.contains(special)) << special;
}

TEST(OwnSamplers, ScenariosDifferInFilterEdgesAndLevels) {
    std::vector<std::string> names;
    for (const ImageScenario& scenario : random_scenarios(function_of("samplers.glsl", "sampled").images))
        names.push_back(scenario.name);
    EXPECT_THAT(names, ElementsAre("5 x 4, random, linear, repeat", "4 x 4, random, linear, edge, 3 levels",
                                   "5 x 4, random, nearest, mirrored, 2 levels"));
}

// What a story of a failure shows: the digits of float16, the pixels of an image, what a sampler gives.
TEST(OwnTypes, AnExplanationHasTheirValues) {
    const auto explained = [](const char* file, const char* function, const std::vector<Word>& words,
                              const ImageSet& images = {}) {
        return explain({}, function_of(file, function), words, images);
    };
    const Explanation half = explained("numbers.glsl", "half_sum", {to_word(2048.0F), to_word(1.0F)});
    ASSERT_EQ(half.steps.size(), 1U);
    EXPECT_EQ(half.steps[0].value, 2048.0);
    EXPECT_EQ(half.steps[0].exact, 2049.0);
    EXPECT_EQ(half.steps[0].local, -1.0);
    EXPECT_EQ(half.steps[0].ulps, 0.5) << "of float16";
    EXPECT_EQ(half.steps[0].permitted, (numeric::Bounds{2048.0, 2050.0, false}));
    numeric::Random random(1);
    const ImageScenario scenario = random_scenarios(function_of("samplers.glsl", "twice").images).front();
    const std::vector<Word> quad(8, to_word(0.25F));
    const Explanation twice = explained("samplers.glsl", "twice", quad, scenario.make(scenario.size, random));
    EXPECT_GT(std::ranges::count(twice.steps, "OpImageSample", &ExplainedStep::operation), 0);
    EXPECT_THROW((void)explained("samplers.glsl", "twice", quad), std::invalid_argument);
}

// As docs/verdicts.md has it.
TEST(OwnRules, AFunctionOfYourOwn) {
    const Lab lab({.include_roots = {FIXTURES}});
    const Answer answer =
        Function<float(float)>(lab, "rules.glsl", "reciprocal").check_rules({uniform(1, 2)});
    EXPECT_TRUE(answer.passed()) << answer;
    EXPECT_LE(answer.guarantee.ulp, 4.0);
}

}  // namespace gloam::subject::own_values_test
