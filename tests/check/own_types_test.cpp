// SPDX-License-Identifier: MIT
// Functions whose inputs are more than vectors: arrays, nested structures, uniforms and buffers.
#include <array>

#include "check/fixture_functions.hpp"
#include "check/function.hpp"
#include "module/include.hpp"
#include "support/changed_device.hpp"

#include "support/test.hpp"

namespace gloam::check::own_types_test {

using testing::ElementsAre;
using testing::UnorderedElementsAre;

// A device whose results are wrong: each output has the words of its neighbour.
std::shared_ptr<backend::Backend> shifted() {
    return std::make_shared<test::ChangedDevice>(test::SharedDevice::get(), nullptr, [](std::span<Word> row) {
        std::rotate(row.begin(), row.begin() + 1, row.end());
    });
}

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
    EXPECT_THAT([&] { (void)Function<float(std::array<float, 3>, Row)>(lab, "arrays.glsl", "array_dot"); },
                testing::ThrowsMessage<std::invalid_argument>(
                    AllOf(HasSubstr("float[3], float[4]"), HasSubstr("float[4] a, float[4] b"))));
}

TEST(OwnTypes, ArraysAreComparedWithAReference) {
    const Lab lab = test::make_lab(FIXTURES);
    using DoubleRow = std::array<double, 4>;
    const auto reference = [](DoubleRow a, DoubleRow b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
    };
    const Values row = vector(4, uniform(0, 1));
    const Budget budget{.ulp = 8};
    const Answer right =
        Function<float(Row, Row)>(lab, "arrays.glsl", "array_dot").compare(reference, {row, row}, budget);
    EXPECT_TRUE(right.passed()) << right;
    const Answer wrong = Function<float(Row, Row)>(lab, "arrays.glsl", "array_dot_wrong")
                             .compare(reference, {row, row}, budget);
    EXPECT_TRUE(wrong.failed()) << wrong;
}

TEST(OwnTypes, AWrongElementIsNoticed) {
    const Lab lab(options_of("arrays.glsl"), shifted());
    for (const char* name : {"array_transposed", "array_swapped", "array_split"}) {
        const Answer answer = answer_of(lab, "arrays.glsl", name);
        EXPECT_GT(answer.outside(), 0U) << name;
        EXPECT_FALSE(answer.passed()) << name;
    }
}

TEST(OwnTypes, LargeArraysAreInputs) {
    EXPECT_TRUE(answer_of("arrays.glsl", "array_large").passed());
}

// An index outside is not judged; the other inputs of the same kernel are.
TEST(OwnTypes, AConstantIndexOutsideIsAnInputsFault) {
    for (const char* name : {"literals", "specialization"}) {
        const Lab lab(options_of("undefined.glsl", shader::variant(name)), test::SharedDevice::get());
        const Answer answer = answer_of(lab, "undefined.glsl", "undefined_table", {}, 256);
        EXPECT_GT(answer.undefined, 0U) << name;
        EXPECT_LT(answer.undefined, answer.inputs()) << name;
        EXPECT_EQ(answer.outside(), 0U) << answer;
    }
}

// "float gain", "inout vec2[16] sums": what is drawn and read besides the parameters.
std::vector<std::string> globals_of(const OwnFunction& own) {
    std::vector<std::string> texts;
    for (const shader::Parameter& p : own.function.parameters)
        if (p.global)
            texts.push_back((p.direction == shader::Direction::inout ? "inout " : "") +
                            shader::name_of(p.type) + " " + p.name);
    return texts;
}

TEST(OwnTypes, UniformsAreFurtherInputs) {
    const auto inputs_of = [](const char* name) { return globals_of(function_of("uniforms.glsl", name)); };
    EXPECT_THAT(inputs_of("exposed"), UnorderedElementsAre("float exposure", "float[2] bias"));
    EXPECT_THAT(inputs_of("graded"),
                UnorderedElementsAre("float gain", "vec4 tint", "float exposure", "float[2] bias"));
    EXPECT_THAT(inputs_of("lamp"), ElementsAre("Push pushed"));
    EXPECT_THAT(inputs_of("value_at"), UnorderedElementsAre("float[16] values", "uint header"));
    EXPECT_THAT(inputs_of("store"), UnorderedElementsAre("vec2 uv", "inout Sums result"));
    EXPECT_THAT(inputs_of("shade"), UnorderedElementsAre("vec2 uv", "inout vec4 color"));
    EXPECT_THAT(inputs_of("timed"), ElementsAre("float iTime"));
    EXPECT_THAT(inputs_of("sum"), ElementsAre("float exposure"));
    EXPECT_THAT(inputs_of("shadowed"), ElementsAre());
    EXPECT_THAT(inputs_of("facing"), ElementsAre("vec3 normal"));
    EXPECT_THAT(inputs_of("pixel"), UnorderedElementsAre("vec4 gloam_FragCoord", "bool gloam_FrontFacing"));
    EXPECT_THAT(inputs_of("place"), ElementsAre("inout vec4 gloam_Position"));
}

TEST(OwnTypes, UniformsHaveTheValuesThatWereDrawn) {
    const Lab lab(options_of("uniforms.glsl"), test::SharedDevice::get());
    const auto run_one = [&](const char* name, const std::vector<Word>& inputs) {
        const OwnFunction own = function_of("uniforms.glsl", name);
        return lab
            .kernel("uniforms.glsl", name,
                    {.result = own.function.result, .parameters = own.function.parameters})
            .run(inputs, 1)
            .outputs;
    };
    // x; then exposure, bias
    EXPECT_THAT(run_one("exposed", {to_word(2.0F), to_word(10.0F), to_word(7.0F), to_word(5.0F)}),
                ElementsAre(to_word(25.0F)));
    EXPECT_THAT(run_one("timed", {to_word(2.0F), to_word(4.0F)}), ElementsAre(to_word(8.0F)));
    EXPECT_THAT(run_one("sum", {to_word(2.0F), to_word(4.0F)}), ElementsAre(to_word(24.0F)));
    const std::vector<Word> shaded = run_one(
        "shade", {to_word(1.0F), to_word(2.0F), to_word(3.0F), to_word(4.0F), to_word(5.0F), to_word(6.0F)});
    EXPECT_THAT(shaded, testing::SizeIs(4));
    EXPECT_THAT(shaded, testing::IsSupersetOf({to_word(1.0F), to_word(2.0F)}));
}

TEST(OwnTypes, AWrongUniformIsNoticed) {
    const Lab lab(options_of("uniforms.glsl"), shifted());
    for (const char* name : {"graded", "shade"})
        EXPECT_GT(answer_of(lab, "uniforms.glsl", name).outside(), 0U) << name;
}

TEST(OwnTypes, AnInputNamesItsUniforms) {
    const Signature signature = function_of("uniforms.glsl", "timed").signature();
    const std::string text = describe_inputs(signature, {to_word(0.5F), to_word(5.0F)});
    EXPECT_EQ(text.substr(0, 6), "float ");
    EXPECT_THAT(text, HasSubstr(", float iTime "));
}

}  // namespace gloam::check::own_types_test
