// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include "record/failures.hpp"
#include "support/test.hpp"

namespace gloam::record::failures_test {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Expected {
    module::Scalar scalar;
    std::uint32_t found;
    numeric::Bounds allowed;
};

judge::Reproduction failure_of(const std::vector<Expected>& all) {
    judge::Reproduction made{.assembly = "; SPIR-V\nOpName %BLEND \"BLEND\"\n",
                             .inputs = {0x3f800000U, 7U},
                             .outcomes = {{}},
                             .failure = judge::Sample{}};
    for (const Expected& one : all) {
        made.outputs.push_back(one.scalar);
        made.outcomes.front().push_back(one.allowed);
        made.failure->got.push_back(one.found);
        made.failure->want.push_back(0.5);
    }
    return made;
}

Expected number(double low, double high, bool nan = false) {
    return {module::Scalar::float_, 0x3e000000U, {.low = low, .high = high, .nan = nan}};
}
Expected integer(double low, double high) {
    return {module::Scalar::uint_, 99U, {.low = low, .high = high, .nan = false}};
}
Expected integer(double value) {
    return integer(value, value);
}

// A number and an integer that are permitted together: 0 and 1, or 1 and 2, or 4 and 1.
judge::Reproduction three_outcomes(float found, std::uint32_t integer_found) {
    judge::Reproduction made = failure_of({number(0, 0), integer(1)});
    made.outcomes.push_back({numeric::Bounds::point(1), numeric::Bounds::point(2)});
    made.outcomes.push_back({numeric::Bounds::point(4), numeric::Bounds::point(1)});
    made.failure->got = {std::bit_cast<std::uint32_t>(found), integer_found};
    return made;
}

// What "EXPECT floats IDX 0 GE 1" and its like say of the first output: "floats GE 1".
std::vector<std::string> expectations(const judge::Reproduction& of) {
    std::istringstream lines(to_amber(of, {}));
    std::vector<std::string> found;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t index = line.find(" IDX 0 ");
        if (line.starts_with("EXPECT ") && index != std::string::npos)
            found.push_back(line.substr(7, index - 7) + line.substr(index + 6));
    }
    return found;
}

// Ends between two floats are rounded inwards: 0.1 in double lies between 0.0999999940 and 0.100000001. A
// range of integers is one of words unless it crosses zero.
TEST(Amber, AnOutputLiesInItsRange) {
    const std::pair<Expected, std::vector<std::string>> rows[] = {
        {number(0.25, 0.5), {"floats NE nan", "floats GE 0.250000000", "floats LE 0.500000000"}},
        {number(-0.125, 3.0, true), {"floats GE -0.125000000", "floats LE 3.00000000"}},
        {number(0.1, 0.1 + 1e-12), {"floats NE nan", "floats GE 0.100000001", "floats LE 0.0999999940"}},
        {number(0.7, 0.8), {"floats NE nan", "floats GE 0.700000048", "floats LE 0.799999952"}},
        {number(infinity, infinity), {"floats NE nan", "floats GT 3.40282347e+38"}},
        {number(-infinity, -infinity), {"floats NE nan", "floats LT -3.40282347e+38"}},
        {number(1.0, infinity), {"floats NE nan", "floats GE 1.00000000"}},
        {number(-infinity, infinity), {"floats NE nan"}},
        {number(infinity, -infinity, true), {"floats EQ nan"}},
        {number(-infinity, infinity, true), {}},
        {integer(7), {"words EQ 7"}},
        {integer(-1), {"words EQ 4294967295"}},
        {integer(4294967295.0), {"words EQ 4294967295"}},
        {integer(3, 5), {"words GE 3", "words LE 5"}},
        {integer(-2, -1), {"words GE 4294967294", "words LE 4294967295"}},
        {integer(-2, 1), {}},
        {integer(0, infinity), {"words GE 0", "words LE 4294967295"}}};
    for (const auto& [output, expected] : rows)
        EXPECT_EQ(expectations(failure_of({output})), expected)
            << output.allowed.low << " " << output.allowed.high;
}

// A script has no word for "or".
TEST(Amber, OfSeveralOutcomesTheHullIsExpectedAndNotWhatFailedBetweenThem) {
    EXPECT_THAT(
        expectations(three_outcomes(2.5F, 2)),
        ElementsAre("floats NE nan", "floats GE 0.00000000", "floats LE 4.00000000", "floats NE 2.50000000"));
    // 1 is permitted, but not with 1.
    EXPECT_THAT(expectations(three_outcomes(1.0F, 1)), Not(Contains("floats NE 1.00000000")));
    const std::string script = to_amber(three_outcomes(2.5F, 2), {});
    EXPECT_THAT(script, HasSubstr("# one of 3 outcomes is allowed (report.txt); this expects their hull\n"));
    EXPECT_THAT(script, HasSubstr("EXPECT words IDX 4 GE 1\nEXPECT words IDX 4 LE 2\n"));
}

TEST(Amber, AWholeScript) {
    judge::Reproduction all = failure_of({number(0.25, 1), integer(3)});
    all.specialized = true;
    all.images = {{.name = "depth", .words = std::vector<std::uint32_t>(9, 5U)}};
    const auto pipeline = [](const char* view) {
        return fmt::format(
            "PIPELINE compute read_{0}\n"
            "  ATTACH kernel SPECIALIZE 0 AS uint32 1065353216 SPECIALIZE 1 AS uint32 7\n"
            "  BIND BUFFER run AS push_constant\n"
            "  BIND BUFFER inputs AS storage DESCRIPTOR_SET 0 BINDING 0\n"
            "  BIND BUFFER {0} AS storage DESCRIPTOR_SET 0 BINDING 1\n"
            "  BIND BUFFER faults AS storage DESCRIPTOR_SET 0 BINDING 2\n"
            "  BIND BUFFER image0 AS storage DESCRIPTOR_SET 0 BINDING 3\n"
            "END\n\nRUN read_{0} 1 1 1\n# the kernel ran to its end\n",
            view);
    };
    const std::string five = "0x00000005";
    EXPECT_EQ(to_amber(all, {"a comment"}),
              "#!amber\n# a comment\n\nSHADER compute kernel SPIRV-ASM TARGET_ENV spv1.5\n"
              "; SPIR-V\nOpName %BLEnd \"BLEnd\"\nEND\n\n"
              "# how many inputs, invocations in a row, the word to write behind the outputs\n"
              "BUFFER run DATA_TYPE uint32 DATA\n0x00000001 0x00000040 0x3f800000\nEND\n\n"
              "BUFFER inputs DATA_TYPE uint32 DATA\n0x3f800000 0x00000007\nEND\n\n"
              "# accesses outside an image: how many, and the first\n"
              "BUFFER faults DATA_TYPE uint32 DATA\n0x00000000 0x00000000 0x00000000 0x00000000 0x00000000\n"
              "END\n\n# depth: width, height, clamped, then the pixels row by row\n"
              "BUFFER image0 DATA_TYPE uint32 DATA\n" +
                  fmt::format("{}\n{}\n", fmt::join(std::vector(8, five), " "), five) +
                  "END\n\nBUFFER floats DATA_TYPE float SIZE 3 FILL 0.0\n\n" + pipeline("floats") +
                  "EXPECT floats IDX 8 EQ 1.0\n# output 0: here it was 0.125 (0x3e000000); the reference "
                  "gives 0.5 (0x1p-1)\n"
                  "EXPECT floats IDX 0 NE nan\n"
                  "EXPECT floats IDX 0 GE 0.250000000\nEXPECT floats IDX 0 LE 1.00000000\n\n"
                  "BUFFER words DATA_TYPE uint32 SIZE 3 FILL 0\n\n" +
                  pipeline("words") +
                  "EXPECT words IDX 8 EQ 1065353216\n# output 1: here it was 0x00000063; the reference gives "
                  "0.5 (0x1p-1)\n"
                  "EXPECT words IDX 4 EQ 3\n\n"
                  "# no access fell outside an image\nEXPECT faults IDX 0 EQ 0\n");
}

TEST(Amber, WhatWasNotJudgedMustOnlyEnd) {
    judge::Reproduction not_judged = failure_of({number(0, 1)});
    not_judged.failure.reset();
    not_judged.outcomes.clear();
    const std::string script = to_amber(not_judged, {});
    EXPECT_THAT(script, HasSubstr("# output 0: not judged"));
    EXPECT_THAT(script, Not(HasSubstr("EXPECT floats IDX 0")));
    EXPECT_THAT(script, HasSubstr("EXPECT floats IDX 4 EQ 1.0"));
}

TEST(Amber, AFunctionWithoutInputsHasABufferAllTheSame) {
    judge::Reproduction none = failure_of({number(0, 1)});
    none.inputs.clear();
    EXPECT_THAT(to_amber(none, {}), HasSubstr("BUFFER inputs DATA_TYPE uint32 DATA\n0x00000000\nEND\n"));
}

}  // namespace gloam::record::failures_test
