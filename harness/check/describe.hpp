// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <string>

#include "check/answer.hpp"
#include "check/signature.hpp"

namespace gloam::check {

// The values of a signature's inputs, each in decimal and hexadecimal: "vec2 (0.5 (0x3f000000), 1
// (0x3f800000)), int 3".
[[nodiscard]] std::string describe_inputs(const Signature& signature, const std::vector<Word>& inputs);

// Verdict, counts by class of input, and the worst input with what came out and what should have.
[[nodiscard]] std::string describe(const Signature& signature, const Answer& answer);

// Gives every sample of an answer its values in words.
void describe_samples(const Signature& signature, Answer& answer);

// So that EXPECT_TRUE(answer.passed()) << answer describes the failure.
std::ostream& operator<<(std::ostream& stream, const Answer& answer);

}  // namespace gloam::check
