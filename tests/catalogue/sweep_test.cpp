// SPDX-License-Identifier: MIT
// Every equation of the catalogue on the device, over its whole domain.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

#include "catalogue/catalogue.hpp"
#include "support/lab.hpp"

namespace gloam::catalogue {
namespace sweep_test {

constexpr std::size_t inputs_per_equation = 65'536;
constexpr std::size_t strict_inputs = 512;

class Sweep : public testing::TestWithParam<Entry> {};

TEST_P(Sweep, StaysWithinItsBudget) {
    const check::Lab lab = test::make_lab();
    const check::Answer result = check::run(lab, GetParam().question, {.inputs = inputs_per_equation});
    EXPECT_TRUE(result.passed()) << GetParam().description.id << ": " << result;
    EXPECT_EQ(result.inputs(), inputs_per_equation);
}

// Each operation rounded on its own: the narrowest bounds of Vulkan's rules, which budgets may hide errors
// inside.
TEST_P(Sweep, IsPermittedWhenStrict) {
    const check::Lab lab = test::make_lab({}, shader::variant("strict"));
    const check::Answer result = check::run(lab, GetParam().question, {.inputs = strict_inputs});
    EXPECT_TRUE(result.passed()) << GetParam().description.id << ": " << result;
    EXPECT_EQ(result.verdict, check::Verdict::rules);
    EXPECT_EQ(result.by_rules, strict_inputs);
}

std::string test_name(const testing::TestParamInfo<Entry>& info) {
    std::string name = info.param.description.id;
    std::ranges::replace_if(
        name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Sweep, testing::ValuesIn(all_entries()), test_name);

}  // namespace sweep_test

// Without this GoogleTest prints the bytes of an entry.
void PrintTo(const Entry& entry, std::ostream* stream) {
    *stream << entry.description.id;
}

}  // namespace gloam::catalogue
