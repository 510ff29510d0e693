// SPDX-License-Identifier: MIT
// The guided search against plain random sampling.
#include "audit/worst.hpp"
#include "support/lab.hpp"

namespace gloam::audit::worst_test {

using namespace judge;
using namespace subject;

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

}  // namespace gloam::audit::worst_test
