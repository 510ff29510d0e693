// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <string>

#include "check/case.hpp"

namespace gloam::check {

// The values of a signature's inputs, each in decimal and hexadecimal: "vec2 (0.5 (0x3f000000), 1
// (0x3f800000)), int 3".
[[nodiscard]] std::string describe_inputs(const Signature& signature, const std::vector<Word>& inputs);

// Verdict, counts by class of input, and the worst input with what came out and what should have.
[[nodiscard]] std::string describe(const Result& result);

// So that EXPECT_TRUE(result.passed()) << result tells the whole story.
std::ostream& operator<<(std::ostream& stream, const Result& result);

}  // namespace gloam::check
