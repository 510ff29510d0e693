// SPDX-License-Identifier: MIT
// A documented accuracy is what the function really achieves: no driver at hand may leave more than three
// quarters of a budget unused.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "support/entries.hpp"
#include "support/lab.hpp"

namespace gloam::catalogue {
namespace budget_test {

constexpr std::size_t inputs_per_equation = 65'536;
constexpr double most_slack = 4.0;

// A result is never nearer to the exact one than its rounding, so half an ULP is no slack.
bool is_tightest(const check::Budget& budget) {
    return budget.ulp <= 0.5 && budget.absolute == 0.0;
}

std::vector<std::unique_ptr<check::Lab>> labs_of_all_devices() {
    std::vector<std::unique_ptr<check::Lab>> labs;
    for (const gpu::DeviceInfo& info : gpu::list_devices()) {
        labs.push_back(
            std::make_unique<check::Lab>(check::LabOptions{.device = std::to_string(info.index),
                                                           .validation = true,
                                                           .include_roots = {GLOAM_GLSL_DIR},
                                                           .cache_directory = test::cache_directory()}));
    }
    return labs;
}

class Budgets : public testing::TestWithParam<std::size_t> {
  protected:
    static void SetUpTestSuite() { labs_ = labs_of_all_devices(); }
    static void TearDownTestSuite() { labs_.clear(); }

    inline static std::vector<std::unique_ptr<check::Lab>> labs_;
};

TEST_P(Budgets, AreAtMostFourTimesWhatIsMeasured) {
    ASSERT_FALSE(labs_.empty());
    const check::Question& question = test::entries()[GetParam()].question;
    if (question.only_rules || is_tightest(question.budget)) return;
    if (question.budget.ulp == 0.0 && question.budget.absolute == 0.0) return;
    double worst = 0.0;
    for (const auto& lab : labs_)
        worst = std::max(worst, check::run(*lab, question, {.inputs = inputs_per_equation}).fraction);
    EXPECT_GE(worst * most_slack, 1.0)
        << "documents " << check::to_text(question.budget) << ", of which " << worst << " is used at most";
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Budgets, test::entry_numbers(), test::entry_name);

}  // namespace budget_test
}  // namespace gloam::catalogue
