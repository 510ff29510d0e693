// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "check/audit.hpp"
#include "check/internal/audit_search.hpp"

namespace gloam::check::internal {

// How each of the first results moves with each scalar float parameter, along lines through a few drawn
// inputs: in double whether it rises, falls, turns or jumps; in float32 whether it goes backward. The rest is
// left out once the runs have taken so many instructions.
[[nodiscard]] std::vector<AuditMotion> motions(AuditRuns& runs, const AuditSearch& search,
                                               std::uint64_t most_instructions);

}  // namespace gloam::check::internal
