// SPDX-License-Identifier: MIT
#pragma once

#include "check/internal/pass_work.hpp"
#include "check/pass.hpp"

namespace gloam::check::internal {

// A run of a pass with these inputs, ready but for the contents of what is not given. Throws
// std::invalid_argument like Pass::run().
[[nodiscard]] PassWork bound(const PassInterface& pass, const PassInputs& inputs, const PassOptions& options);

}  // namespace gloam::check::internal
