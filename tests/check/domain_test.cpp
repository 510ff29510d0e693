// SPDX-License-Identifier: MIT
#include "check/domain.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "numeric/special_values.hpp"

namespace gloam::check {
namespace domain_test {

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
    for (const float special : numeric::special_floats)
        EXPECT_TRUE(words.contains(to_word(special))) << special;
}

TEST(Domain, BranchPointsComeWithTheirNeighbours) {
    const auto inputs = Domain{uniform(0, 1).and_near({0.25})}.draw(100, 1);
    std::set<float> at_branch;
    for (std::size_t i = 0; i < inputs.count(); ++i) {
        if (inputs.branch[i]) at_branch.insert(from_word<float>(inputs.row(i)[0]));
    }
    EXPECT_EQ(at_branch, (std::set<float>{std::nextafter(0.25F, 0.0F), 0.25F, std::nextafter(0.25F, 1.0F)}));
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
    const auto inputs = Domain{unit_vector(3)}.draw(20'000, 1);
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < inputs.count(); ++i) {
        const auto row = inputs.row(i);
        const glm::dvec3 v(from_word<float>(row[0]), from_word<float>(row[1]), from_word<float>(row[2]));
        ASSERT_NEAR(glm::length(v), 1.0, 1e-7);
        sum += v;
    }
    EXPECT_LT(glm::length(sum) / static_cast<double>(inputs.count()), 0.03);
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
    EXPECT_THROW((void)unit_vector(4), std::invalid_argument);
    EXPECT_THROW((void)Domain{uniform(0, 1)}.tied(0, 1), std::invalid_argument);
}

}  // namespace domain_test
}  // namespace gloam::check
