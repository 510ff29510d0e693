// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "check/answer.hpp"
#include "check/lab.hpp"
#include "check/question.hpp"

namespace gloam::check::internal {

// Adds the story to an answer that failed: what was found, and the worst input operation by operation.
// `seed`: of the run.
void tell_story(const Lab& lab, const Question& question, std::uint64_t seed, Answer& answer);

}  // namespace gloam::check::internal
