// SPDX-License-Identifier: MIT
#include "check/domain.hpp"
#include "check/reproduction.hpp"
#include "check/run.hpp"
#include "numeric/numbers.hpp"
#include "support/lab.hpp"

namespace gloam::check::domain_test {

std::vector<float> floats_of(const Domain::Inputs& inputs) {
    std::vector<float> values;
    for (const Word word : inputs.words) values.push_back(from_word<float>(word));
    return values;
}

TEST(Domain, RangesAreKeptAndTheirEndsIncluded) {
    const std::vector<float> values = floats_of(Domain{uniform(-2, 3)}.draw(10'000, 1));
    EXPECT_EQ(*std::min_element(values.begin(), values.end()), -2.0F);
    EXPECT_EQ(*std::max_element(values.begin(), values.end()), 3.0F);
}

TEST(Domain, LogUniformReachesEveryDecade) {
    std::set<int> decades;
    for (const float value : floats_of(Domain{log_uniform(1e-6, 1e6)}.draw(10'000, 1))) {
        ASSERT_GE(value, 1e-6F);
        ASSERT_LE(value, 1e6F);
        decades.insert(static_cast<int>(std::floor(std::log10(value))));
    }
    EXPECT_GE(decades.size(), 12U);
}

TEST(Domain, EverySpecialValueIsThere) {
    std::set<Word> words;
    for (const Word word : Domain{uniform(0, 1).and_special()}.draw(200, 1).words) words.insert(word);
    for (const double special : numeric::special_values(numeric::float32))
        EXPECT_TRUE(words.contains(to_word(static_cast<float>(special)))) << special;
}

TEST(Domain, BranchPointsComeWithTheirNeighbours) {
    const auto inputs = Domain{uniform(0, 1).and_near({0.25})}.draw(100, 1);
    std::set<float> at_branch;
    for (std::size_t i = 0; i < inputs.count(); ++i) {
        if (inputs.branch[i]) at_branch.insert(from_word<float>(inputs.row(i)[0]));
    }
    EXPECT_EQ(at_branch, (std::set<float>{std::nextafter(0.25F, 0.0F), 0.25F, std::nextafter(0.25F, 1.0F)}));
}

TEST(Domain, NumbersAndTheirNeighboursAreTriedWhereValuesAdmitThem) {
    const Signature signature = SignatureOf<float(glm::vec3, glm::vec3, float, float)>::describe();
    const Domain domain{vector(3, uniform(-1, 1)), unit_vector(3), uniform(0.5, 4).only_as_drawn(),
                        made_by<float>([](numeric::Random&) { return 2.0F; })};
    const std::array numbers{0.25F, 3.0F};
    const auto inputs = domain.and_numbers(signature, numbers).draw(800, 1);
    std::array<std::set<float>, 8> seen;
    for (std::size_t i = 0; i < inputs.count(); ++i)
        for (std::size_t k = 0; k < seen.size(); ++k) seen[k].insert(from_word<float>(inputs.row(i)[k]));
    for (std::size_t k = 0; k < 3; ++k) {
        for (const float number : {-0.25F, 0.25F})
            for (const int step : {-1, 0, 1}) EXPECT_TRUE(seen[k].contains(numeric::step(number, step))) << k;
        EXPECT_LE(*seen[k].rbegin(), 1.0F);
        EXPECT_FALSE(seen[k + 3].contains(0.25F)) << "not a unit vector any more";
    }
    EXPECT_FALSE(seen[6].contains(3.0F)) << "only as drawn";
    EXPECT_EQ(seen[7], std::set<float>{2.0F}) << "nothing says what else it may be";
}

TEST(Domain, TiesPlaceOneParameterBesideAnother) {
    const auto inputs = Domain{uniform(0, 1), uniform(1, 2)}.tied(0, 1, 0.5).draw(4'000, 1);
    std::size_t tied = 0;
    for (std::size_t i = 0; i < inputs.count(); ++i) {
        if (!inputs.branch[i]) continue;
        ++tied;
        const float half = 0.5F * from_word<float>(inputs.row(i)[1]);
        EXPECT_LE(std::abs(from_word<float>(inputs.row(i)[0]) - half), 0x1p-23F);
    }
    EXPECT_GT(tied, 100U);
}

TEST(Domain, AdjustmentsSeeEveryInput) {
    const auto inputs = Domain{uniform(0, 1), uniform(0, 1)}
                            .adjusted([](std::span<Word> row) {
                                if (from_word<float>(row[0]) > from_word<float>(row[1]))
                                    std::swap(row[0], row[1]);
                            })
                            .draw(1'000, 1);
    for (std::size_t i = 0; i < inputs.count(); ++i) {
        EXPECT_LE(from_word<float>(inputs.row(i)[0]), from_word<float>(inputs.row(i)[1]));
    }
}

TEST(Domain, UnitVectorsHaveLengthOneAndCoverTheSphere) {
    for (const int size : {3, 4}) {
        const auto inputs = Domain{unit_vector(size)}.draw(20'000, 1);
        const auto count = static_cast<double>(inputs.count());
        glm::dvec4 sum(0);
        glm::dvec4 squares(0);
        for (std::size_t i = 0; i < inputs.count(); ++i) {
            glm::dvec4 v(0);
            for (int k = 0; k < size; ++k)
                v[k] = from_word<float>(inputs.row(i)[static_cast<std::size_t>(k)]);
            ASSERT_NEAR(glm::length(v), 1.0, 1e-7);
            sum += v;
            squares += v * v;
        }
        EXPECT_LT(glm::length(sum) / count, 0.03);
        for (int k = 0; k < size; ++k) EXPECT_NEAR(squares[k] / count, 1.0 / size, 0.02);
    }
}

TEST(Domain, IntegersIncludeTheirEndsAndNegativeOnes) {
    std::set<int> values;
    for (const Word word : Domain{integers(-3, 3)}.draw(1'000, 1).words) values.insert(from_word<int>(word));
    EXPECT_EQ(values, (std::set<int>{-3, -2, -1, 0, 1, 2, 3}));
}

TEST(Domain, SeedsDecideEverything) {
    const Domain domain{uniform(0, 1).and_special(), vector(3, signed_log_uniform(1e-3, 1e3))};
    EXPECT_EQ(domain.draw(1'000, 5).words, domain.draw(1'000, 5).words);
    EXPECT_NE(domain.draw(1'000, 5).words, domain.draw(1'000, 6).words);
}

TEST(Domain, NonsenseIsRefused) {
    EXPECT_THROW((void)uniform(1, 0), std::invalid_argument);
    EXPECT_THROW((void)log_uniform(0, 1), std::invalid_argument);
    EXPECT_THROW((void)unit_vector(5), std::invalid_argument);
    EXPECT_THROW((void)Domain{uniform(0, 1)}.tied(0, 1), std::invalid_argument);
}

TEST(Domain, AnAdjustedDomainKeepsAGivenInputAsItIs) {
    const Domain domain =
        Domain{uniform(0, 1)}.adjusted([](std::span<Word> row) { row[0] = 0U; }).and_input(0.5F);
    const Domain::Inputs inputs = domain.draw(3, 1);
    EXPECT_EQ(from_word<float>(inputs.row(0)[0]), 0.5F);
    EXPECT_EQ(inputs.row(1)[0], 0U);
    EXPECT_EQ(domain.draw(1, 1).count(), 1U);
}

TEST(Values, AdmitWhatTheyDraw) {
    numeric::Random random(1);
    DrawContext context{.random = random};
    const std::vector<Values> all{uniform(-1, 2),
                                  log_uniform(1e-5, 1e5).and_special(),
                                  signed_log_uniform(1e-3, 1),
                                  any_float(),
                                  integers(-3, 70),
                                  log_integers(1000),
                                  unit_vector(2),
                                  unit_vector(3),
                                  vector(3, uniform(0, 1)),
                                  either(uniform(0, 1), uniform(4, 5)),
                                  vector_of_length(3, log_uniform(0.1, 10))};
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (int repeat = 0; repeat < 1000; ++repeat) {
            std::vector<Word> words;
            all[i].draw(context, words);
            // The length of a rounded vector may leave its range by a rounding.
            ASSERT_TRUE(i + 1 == all.size() || all[i].admits(words)) << "values " << i;
        }
        for (const Values::Fixed& fixed : all[i].fixed)
            ASSERT_TRUE(all[i].admits(fixed.words)) << "values " << i;
    }
}

TEST(Values, AdmitNothingElse) {
    const auto admits = [](const Values& values, auto... scalars) {
        const std::vector<Word> words{to_word(scalars)...};
        return values.admits(words);
    };
    EXPECT_FALSE(admits(uniform(0, 1), 1.0000001F));
    EXPECT_FALSE(admits(uniform(0, 1), nan));
    EXPECT_FALSE(admits(integers(-3, 70), 71));
    EXPECT_FALSE(admits(integers(-3, 70), -4));
    EXPECT_FALSE(admits(unit_vector(2), 0.8F, 0.61F));
    EXPECT_FALSE(admits(vector(2, uniform(0, 1)), 0.5F, -0.5F));
    EXPECT_FALSE(admits(either(uniform(0, 1), uniform(4, 5)), 3.0F));
    EXPECT_TRUE(admits(uniform(0, 1).and_near({2.0}), 2.0F));
    EXPECT_FALSE(admits(made_by<float>([](numeric::Random&) { return 1.0F; }), 1.0F)) << "nobody can tell";
}

constexpr std::size_t enough = 2000;

Word bits(float value) {
    return std::bit_cast<Word>(value);
}

float as_float(Word word) {
    return std::bit_cast<float>(word);
}

// A function that should return its first word; where `fails` is true it returns another one.
template <class Type>
struct Planted {
    Domain domain;
    std::function<bool(std::span<const Word>)> fails;
    mutable std::size_t evaluations = 0;

    [[nodiscard]] Sample shrunk(std::size_t index, std::span<const Word> failing) const {
        const auto first_failing = [&](std::span<const std::vector<Word>> inputs) -> std::optional<Sample> {
            ++evaluations;
            const auto found = std::ranges::find_if(inputs, [&](const auto& row) { return fails(row); });
            if (found == inputs.end()) return std::nullopt;
            return Sample{.inputs = *found, .got = {~found->front()}};
        };
        return shrink({.signature = SignatureOf<Type>::describe(), .domain = domain},
                      {.index = index, .inputs = {failing.begin(), failing.end()}}, first_failing);
    }

    // Shrinks every failing input of a draw; each must still fail, and lie in the domain.
    void expect_shrinks_to(const std::vector<Word>& smallest) const {
        const Domain::Inputs inputs = domain.draw(enough, 1);
        std::size_t seen = 0;
        for (std::size_t i = 0; i < inputs.count() && seen < 20; ++i) {
            const auto row = inputs.row(i);
            if (!fails(row)) continue;
            const Sample found = shrunk(i, row);
            EXPECT_EQ(found.inputs, smallest) << "from input " << i;
            EXPECT_EQ(found.index, i);
            EXPECT_TRUE(fails(found.inputs));
            EXPECT_TRUE(domain.holds(found.inputs, row));
            EXPECT_EQ(found.got, std::vector<Word>{~found.inputs[0]});
            ++seen;
        }
        EXPECT_EQ(seen, 20U);
    }
};

TEST(Shrink, ANumberGoesToTheRoundestOneThatFails) {
    using Fails = std::function<bool(std::span<const Word>)>;
    const Fails always = [](auto) { return true; };
    const auto beyond = [](float limit) {
        return Fails([=](auto in) { return (as_float(in[0]) > limit) == (limit > 0.0F); });
    };
    const auto shrinks = [](const Values& values, const Fails& fails, Word smallest) {
        Planted<unsigned(float)>{.domain = {values}, .fails = fails}.expect_shrinks_to({smallest});
    };
    shrinks(any_float(), always, 0U);
    shrinks(uniform(-1000, 1000), beyond(3.25F), bits(4.0F));
    shrinks(uniform(-1000, 1000), beyond(-0.1F), bits(-1.0F));
    shrinks(log_uniform(5, 100), always, bits(8.0F));
    shrinks(constant(2.75F), always, bits(2.75F));
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

TEST(Shrink, AnUnknownDistributionStaysAsItWasDrawn) {
    const Planted<unsigned(float)> planted{.domain = {made_by<float>([](numeric::Random& random) {
                                               return static_cast<float>(random.uniform(0, 1));
                                           })},
                                           .fails = [](auto) { return true; }};
    const std::vector<Word> drawn{bits(0.3F)};
    EXPECT_EQ(planted.shrunk(0, drawn).inputs, drawn);
}

TEST(Shrink, UnitVectorsStayUnitVectors) {
    const Planted<unsigned(glm::vec3)> planted{.domain = {unit_vector(3)},
                                               .fails = [](auto in) { return as_float(in[2]) > 0.1F; }};
    const Domain::Inputs inputs = planted.domain.draw(100, 1);
    for (std::size_t i = 0; i < inputs.count(); ++i) {
        const auto row = inputs.row(i);
        if (!planted.fails(row)) continue;
        const Sample found = planted.shrunk(i, row);
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
        planted.shrunk(0, std::vector<Word>{bits(123456.7F), bits(-3.3F), bits(1e-9F), bits(-98765.4F)});
    EXPECT_EQ(found.inputs, (std::vector<Word>{bits(128.0F), 0U, 0U, bits(-8.0F)}));
    EXPECT_LT(planted.evaluations, 40U);
}

TEST(Shrink, AnInputThatDoesNotFailIsRefused) {
    const Planted<unsigned(float)> planted{.domain = {uniform(0, 1)}, .fails = [](auto) { return false; }};
    expect_error<std::invalid_argument>([&] { (void)planted.shrunk(0, std::vector<Word>{bits(0.5F)}); },
                                        {"does not fail"});
}

}  // namespace gloam::check::domain_test
