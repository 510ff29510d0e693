// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <string>

#include "check/answer.hpp"
#include "check/signature.hpp"

namespace gloam::check {

// The values of a signature's inputs as text, each in decimal and hexadecimal: "vec2 (0.5 (0x3f000000), 1
// (0x3f800000)), int 3".
[[nodiscard]] std::string describe_inputs(const Signature& signature, const std::vector<Word>& inputs);

// Verdict, counts by class of input, and the worst input with its outputs and the expected ones.
[[nodiscard]] std::string describe(const Signature& signature, const Answer& answer);

// Sets Sample::values of every sample of an answer.
void describe_samples(const Signature& signature, Answer& answer);

// Prints describe()'s text, so that EXPECT_TRUE(answer.passed()) << answer describes the failure.
std::ostream& operator<<(std::ostream& stream, const Answer& answer);

}  // namespace gloam::check
