// SPDX-License-Identifier: MIT
#pragma once

#include "base/process.hpp"

namespace gloam::base {

// Of compilers of texts from elsewhere: far beyond the needs of any reasonable shader.
inline const ProcessLimits compiler_limits{.memory_bytes = std::uint64_t{3} << 30,
                                           .cpu = std::chrono::seconds(60),
                                           .patience = std::chrono::minutes(5)};

}  // namespace gloam::base
