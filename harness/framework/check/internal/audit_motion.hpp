// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "check/audit.hpp"
#include "check/internal/audit_search.hpp"

namespace gloam::check::internal {

// How each of the first results moves with each scalar float parameter, along lines through a few drawn
// inputs: in double whether it rises, falls, turns or jumps; in float32 whether it goes backward.
[[nodiscard]] std::vector<AuditMotion> motions(AuditRuns& runs, const AuditSearch& search);

}  // namespace gloam::check::internal
