// SPDX-License-Identifier: MIT
#include "check/shrink.hpp"

#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <stdexcept>

#include "check/run.hpp"

namespace gloam::check {
namespace shrink_test {

constexpr std::size_t enough = 2000;

Word bits(float value) {
    return std::bit_cast<Word>(value);
}

float as_float(Word word) {
    return std::bit_cast<float>(word);
}

// A function that should return its first word; where `fails` is true it returns another one.
template <class Function>
struct Planted {
    Domain domain;
    std::function<bool(std::span<const Word>)> fails;
    Question question = {
        .signature = SignatureOf<Function>::describe(),
        .domain = domain,
        .reference = [](const ImageSet&, std::span<const Word> inputs, std::vector<double>& outputs) {
            outputs = {static_cast<double>(inputs[0])};
        }};
    JudgeOptions options = {};
    ImageSet images = {};
    mutable std::size_t evaluations = 0;

    [[nodiscard]] std::vector<Word> evaluate(std::span<const Word> inputs, std::size_t count) const {
        ++evaluations;
        const std::size_t width = inputs.size() / count;
        std::vector<Word> outputs;
        for (std::size_t i = 0; i < count; ++i) {
            const auto row = inputs.subspan(i * width, width);
            outputs.push_back(fails(row) ? ~row[0] : row[0]);
        }
        return outputs;
    }

    [[nodiscard]] ShrinkScope scope() const {
        return {.question = question,
                .options = options,
                .images = images,
                .evaluate = [this](auto inputs, auto count) {
                    return KernelCore::Result{.outputs = evaluate(inputs, count)};
                }};
    }

    // Shrinks every failing input of a draw; each must still fail, and lie in the domain.
    void expect_shrinks_to(const std::vector<Word>& smallest) const {
        const Domain::Inputs inputs = domain.draw(enough, 1);
        std::size_t shrunk = 0;
        for (std::size_t i = 0; i < inputs.count() && shrunk < 20; ++i) {
            const auto row = inputs.row(i);
            if (!fails(row)) continue;
            const Sample found = shrink(scope(), {.index = i, .inputs = {row.begin(), row.end()}});
            EXPECT_EQ(found.inputs, smallest) << "from input " << i;
            EXPECT_EQ(found.index, i);
            EXPECT_TRUE(fails(found.inputs));
            EXPECT_TRUE(domain.holds(found.inputs, row));
            EXPECT_EQ(found.got, std::vector<Word>{~found.inputs[0]});
            EXPECT_GT(found.fraction, 1.0);
            ++shrunk;
        }
        EXPECT_EQ(shrunk, 20U);
    }
};

TEST(Shrink, AlwaysFailingGoesToZero) {
    Planted<unsigned(float)>{.domain = {any_float()}, .fails = [](auto) { return true; }}.expect_shrinks_to(
        {0U});
}

TEST(Shrink, AFloatGoesToTheRoundestNumberBeyondTheThreshold) {
    Planted<unsigned(float)>{.domain = {uniform(-1000, 1000)},
                             .fails = [](auto in) { return as_float(in[0]) > 3.25F; }}
        .expect_shrinks_to({bits(4.0F)});
    Planted<unsigned(float)>{.domain = {uniform(-1000, 1000)},
                             .fails = [](auto in) { return as_float(in[0]) < -0.1F; }}
        .expect_shrinks_to({bits(-1.0F)});
}

TEST(Shrink, AnIntegerGoesToTheThreshold) {
    Planted<unsigned(unsigned)>{.domain = {integers(0, 1'000'000)},
                                .fails = [](auto in) { return in[0] >= 1000U; }}
        .expect_shrinks_to({1024U});
    Planted<unsigned(int)>{.domain = {integers(-500, 500)},
                           .fails = [](auto in) { return static_cast<int>(in[0]) <= -3; }}
        .expect_shrinks_to({static_cast<Word>(-3)});
}

TEST(Shrink, WhatDoesNotMatterGoesToZero) {
    Planted<unsigned(glm::vec3, bool, int)>{
        .domain = {vector(3, uniform(-8, 8)), booleans(), integers(-9, 9)},
        .fails = [](auto in) { return as_float(in[1]) >= 1.0F; }}
        .expect_shrinks_to({0U, bits(1.0F), 0U, 0U, 0U});
}

TEST(Shrink, ValuesThatMustBeEqualShrinkTogether) {
    const Domain equal = Domain({uniform(0, 100), uniform(0, 100)}).adjusted([](std::span<Word> words) {
        words[1] = words[0];
    });
    Planted<unsigned(float, float)>{.domain = equal,
                                    .fails = [](auto in) { return in[0] == in[1] && as_float(in[0]) > 1.5F; }}
        .expect_shrinks_to({bits(2.0F), bits(2.0F)});
}

TEST(Shrink, StaysInTheDomain) {
    Planted<unsigned(float)>{.domain = {log_uniform(5, 100)}, .fails = [](auto) { return true; }}
        .expect_shrinks_to({bits(8.0F)});
    Planted<unsigned(float)>{.domain = {constant(2.75F)}, .fails = [](auto) { return true; }}
        .expect_shrinks_to({bits(2.75F)});
}

TEST(Shrink, AnUnknownDistributionStaysAsItWasDrawn) {
    const Planted<unsigned(float)> planted{.domain = {made_by<float>([](numeric::Random& random) {
                                               return static_cast<float>(random.uniform(0, 1));
                                           })},
                                           .fails = [](auto) { return true; }};
    EXPECT_EQ(shrink(planted.scope(), {.inputs = {bits(0.3F)}}).inputs, std::vector<Word>{bits(0.3F)});
}

TEST(Shrink, UnitVectorsStayUnitVectors) {
    const Planted<unsigned(glm::vec3)> planted{.domain = {unit_vector(3)},
                                               .fails = [](auto in) { return as_float(in[2]) > 0.1F; }};
    const Domain::Inputs inputs = planted.domain.draw(100, 1);
    for (std::size_t i = 0; i < inputs.count(); ++i) {
        const auto row = inputs.row(i);
        if (!planted.fails(row)) continue;
        const Sample found = shrink(planted.scope(), {.inputs = {row.begin(), row.end()}});
        EXPECT_NEAR(
            std::hypot(as_float(found.inputs[0]), as_float(found.inputs[1]), as_float(found.inputs[2])), 1.0,
            1e-6);
    }
}

TEST(Shrink, ManyCandidatesCostOneEvaluation) {
    const Planted<unsigned(glm::vec4)> planted{
        .domain = {vector(4, uniform(-1e6, 1e6))},
        .fails = [](auto in) { return as_float(in[0]) > 100.0F && as_float(in[3]) < -5.0F; }};
    const Sample found =
        shrink(planted.scope(), {.inputs = {bits(123456.7F), bits(-3.3F), bits(1e-9F), bits(-98765.4F)}});
    EXPECT_EQ(found.inputs, (std::vector<Word>{bits(128.0F), 0U, 0U, bits(-8.0F)}));
    EXPECT_LT(planted.evaluations, 40U);
}

TEST(Shrink, AnInputThatDoesNotFailIsRefused) {
    const Planted<unsigned(float)> planted{.domain = {uniform(0, 1)}, .fails = [](auto) { return false; }};
    EXPECT_THAT([&] { (void)shrink(planted.scope(), {.inputs = {bits(0.5F)}}); },
                testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("does not fail")));
}

TEST(Complexity, OrdersFromSimpleToStrange) {
    const std::vector<float> ascending{0.0F,  1.0F, -1.0F,  1.5F,
                                       1.25F, 0.1F, 1e-30F, std::numeric_limits<float>::quiet_NaN()};
    for (std::size_t i = 1; i < ascending.size(); ++i) {
        const std::vector<Word> simpler{bits(ascending[i - 1])};
        const std::vector<Word> stranger{bits(ascending[i])};
        EXPECT_LT(complexity(simpler, {shader::Scalar::float_}),
                  complexity(stranger, {shader::Scalar::float_}))
            << ascending[i - 1] << " and " << ascending[i];
    }
}

}  // namespace shrink_test
}  // namespace gloam::check
