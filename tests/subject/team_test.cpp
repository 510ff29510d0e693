// SPDX-License-Identifier: MIT
// Functions that need other invocations: derivatives and discard in quads; shared memory, barriers and
// subgroups.
#include "interpreter/program.hpp"
#include "judge/function.hpp"
#include "subject/fixture_functions.hpp"

namespace gloam::subject::team_test {

using namespace judge;

Lab lab_for(const char* file) {
    return {options_of(file), test::SharedDevice::get()};
}

class QuadCalls : public testing::Test {
  protected:
    Lab lab{{.validation = true, .include_roots = {FIXTURES}}, test::SharedDevice::get()};
};

// More than one row of quads, and more than a driver draws at once without dividing the triangle.
TEST_F(QuadCalls, NoQuadIsDivided) {
    const Function<Quad<float>(Quad<float>)> width(lab, "edges.glsl", "edge_width");
    std::vector<std::tuple<Quad<float>>> inputs;
    for (int i = 0; i < 300'000; ++i) {
        const auto x = static_cast<float>(i);
        inputs.emplace_back(Quad<float>{{x, x + 1.0F, x + 2.0F, x + 3.0F}});
    }
    EXPECT_THAT(width(inputs), Each(Quad<float>{{3, 3, 3, 3}}));
}

TEST_F(QuadCalls, AFineDerivativeIsThatOfTheOwnRow) {
    const Function<Quad<glm::vec2>(Quad<float>)> slopes(lab, "edges.glsl", "edge_slopes");
    const Quad<glm::vec2> got = slopes(Quad<float>{{0, 1, 10, 13}});
    EXPECT_EQ(got,
              (Quad<glm::vec2>{{glm::vec2(1, 10), glm::vec2(1, 12), glm::vec2(3, 10), glm::vec2(3, 12)}}));
}

TEST_F(QuadCalls, OtherParametersAreThoseOfAllInvocations) {
    const Function<Quad<float>(Quad<float>, float)> scaled(lab, "edges.glsl", "edge_scaled");
    EXPECT_EQ(scaled(Quad<float>{{0, 1, 2, 3}}, 0.5F), (Quad<float>{{1.5F, 1.5F, 1.5F, 1.5F}}));
    const auto reference = [](const Quad<double>& x, double scale) {
        Quad<double> all{};
        for (std::size_t k = 0; k < 4; ++k)
            all[k] = (std::abs(x[k | 1U] - x[k & ~1U]) + std::abs(x[k | 2U] - x[k & ~2U])) * scale;
        return all;
    };
    const Values smooth = neighbours(type_of<float>(), uniform(0, 1));
    const Answer answer = scaled.compare(reference, {smooth, uniform(1, 2)}, {.ulp = 2}, {.inputs = 4096});
    EXPECT_TRUE(answer.passed()) << answer;
}

TEST(Quads, AnInvocationThatIsDiscardedSaysSo) {
    const Lab lab = lab_for("quads.frag");
    const KernelCore kernel =
        lab.kernel("quads.frag", "cut_out", function_of("quads.frag", "cut_out").signature());
    const std::vector<Word> input{to_word(0.25F), to_word(0.75F), to_word(1.0F), to_word(0.0F)};
    EXPECT_EQ(kernel.run(input, 1).outputs,
              (std::vector<Word>{0, to_word(1.5F), to_word(2.0F), 0, 1, 0, 0, 1}));
}

// Work groups.

using Kind = interpreter::Error::Kind;

auto fails_with(Kind kind, const testing::Matcher<const char*>& message) {
    return testing::Throws<interpreter::Error>(AllOf(testing::Property(&interpreter::Error::kind, kind),
                                                     testing::Property(&std::exception::what, message)));
}

TEST(Groups, RacesAndDivergentBarriersAreErrorsOfTheShader) {
    const Lab lab = lab_for("groups.comp");
    const Lab interpreted(options_of("groups.comp"), interpreter_backend());
    for (const Lab* each : {&lab, &interpreted})
        for (const auto& [name, kind] : {std::pair{"without_barrier", Kind::race},
                                         {"sometimes_without", Kind::race},
                                         {"barrier_for_some", Kind::divergent_barrier}})
            EXPECT_THAT([&] { (void)answer_of(*each, "groups.comp", name, {}, 64); },
                        fails_with(kind, HasSubstr("groups.comp:")))
                << name;
}

TEST(Groups, WhatDependsOnTheOrderIsNotJudged) {
    const Lab lab = lab_for("groups.comp");
    const Answer answer = answer_of(lab, "groups.comp", "ticket", {}, 64);
    EXPECT_EQ(answer.outside(), 0U);
    EXPECT_EQ(answer.open(), answer.inputs());
}

TEST(Groups, AreCalledFromCpp) {
    const Lab lab({.validation = true, .include_roots = {FIXTURES}}, test::SharedDevice::get());
    const Function<Group<float, 64>(Group<float, 64>)> sum(lab, "totals.glsl", "group_total");
    Group<float, 64> ones{};
    ones.fill(1.0F);
    ones[7] = 2.0F;
    EXPECT_THAT(sum(ones), Each(65.0F));
    const Function<Group<float, 64>(Group<float, 64>)> racing(lab, "totals.glsl", "racing_total");
    EXPECT_THAT([&] { (void)racing.check_rules({vector(64, uniform(0, 1))}, {.inputs = 16}); },
                fails_with(Kind::race, AllOf(StartsWith("totals.glsl: racing_total: a race: invocation "),
                                             HasSubstr("totals.glsl:16"), HasSubstr("totals.glsl:18"),
                                             Not(HasSubstr("(word ")))));
    using Mixed = Quad<float>(Group<float, 64>);
    EXPECT_THROW((void)SignatureOf<Mixed>::describe(), std::invalid_argument);
}

}  // namespace gloam::subject::team_test
