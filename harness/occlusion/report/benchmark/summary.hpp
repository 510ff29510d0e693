// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "report/benchmark/result.hpp"

namespace gloam::report {

// Whether a pass takes samples: its name begins with "ambient_occlusion".
[[nodiscard]] bool is_gather(std::string_view pass);

// Summarises the readings of a configuration. Passes are in the order of the first reading that has them; a
// pass that is missing in some readings has the median of the others. A time in copies is divided by the copy
// of the same reading, so that the machine's drift cancels.
[[nodiscard]] Row row_of(const Configuration& configuration, const Quality& quality,
                         std::span<const Reading> readings);

}  // namespace gloam::report
