// SPDX-License-Identifier: MIT
// The guided search against plain random sampling.
#include "check/search.hpp"

#include <gtest/gtest.h>

#include "support/lab.hpp"

namespace gloam::check {
namespace search_test {

Question planted(const std::string& function, Domain domain) {
    return {.file = "peaks.glsl",
            .function = function,
            .signature = SignatureOf<float(float, float)>::describe(),
            .domain = std::move(domain),
            .reference = make_reference<float(float, float)>([](double, double) { return 1.0; }),
            .budget = {.absolute = 1.0}};
}

class SearchTest : public testing::Test {
  protected:
    Lab lab = test::make_lab(FIXTURES);
};

TEST_F(SearchTest, ClimbsANarrowPeakThatSamplingMisses) {
    const Question narrow = planted("narrow_peak", {uniform(0, 1), uniform(0, 1)});
    const SearchResult found = search(lab, narrow, {.inputs = 32'768});
    const Answer sampled = run(lab, narrow, {.inputs = 32'768});
    EXPECT_GT(found.answer.fraction, 0.99) << "the peak is 1 high";
    EXPECT_LT(sampled.fraction, 0.6) << "else the peak is no test";
    EXPECT_EQ(found.answer.inputs(), 32'768U);
    EXPECT_GT(found.answer.fraction, found.drawn_fraction);
}

TEST_F(SearchTest, FindsThePeakAtASingleExponent) {
    const Question small = planted("peak_at_small_numbers", {log_uniform(1e-30, 1), uniform(0, 1)});
    EXPECT_GT(search(lab, small, {.inputs = 32'768}).answer.fraction, 0.99);
}

TEST_F(SearchTest, StaysInsideTheDomain) {
    // The error grows without end beyond the domain.
    const Question tempting = planted("grows", {uniform(0, 1), uniform(-2, 3)});
    const SearchResult found = search(lab, tempting, {.inputs = 16'384});
    ASSERT_TRUE(found.answer.worst);
    EXPECT_EQ(from_word<float>(found.answer.worst->inputs[0]), 1.0F);
    EXPECT_EQ(from_word<float>(found.answer.worst->inputs[1]), 3.0F);
}

TEST_F(SearchTest, FindsTheSameAgain) {
    const Question narrow = planted("narrow_peak", {uniform(0, 1), uniform(0, 1)});
    const SearchResult first = search(lab, narrow, {.inputs = 8192, .seed = 3});
    const SearchResult second = search(lab, narrow, {.inputs = 8192, .seed = 3});
    ASSERT_TRUE(first.answer.worst && second.answer.worst);
    EXPECT_EQ(first.answer.worst->inputs, second.answer.worst->inputs);
}

TEST_F(SearchTest, AFoundInputIsPartOfEveryRunAfterwards) {
    const Question narrow =
        planted("narrow_peak", Domain{uniform(0, 1), uniform(0, 1)}.and_input(0.7123F, 0.3004F));
    EXPECT_GT(run(lab, narrow, {.inputs = 16}).fraction, 0.99);
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
    EXPECT_FALSE(admits(uniform(0, 1), std::nanf("")));
    EXPECT_FALSE(admits(integers(-3, 70), 71));
    EXPECT_FALSE(admits(integers(-3, 70), -4));
    EXPECT_FALSE(admits(unit_vector(2), 0.8F, 0.61F));
    EXPECT_FALSE(admits(vector(2, uniform(0, 1)), 0.5F, -0.5F));
    EXPECT_FALSE(admits(either(uniform(0, 1), uniform(4, 5)), 3.0F));
    EXPECT_TRUE(admits(uniform(0, 1).and_near({2.0}), 2.0F));
    EXPECT_FALSE(admits(made_by<float>([](numeric::Random&) { return 1.0F; }), 1.0F)) << "nobody can tell";
}

}  // namespace search_test
}  // namespace gloam::check
