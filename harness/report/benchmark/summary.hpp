// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "report/benchmark/result.hpp"

namespace gloam::report {

// Median and quartiles, linear between the values of an ordered list (its first value is the quantile 0, its
// last the quantile 1). Values that are not finite are left out.
[[nodiscard]] Spread spread_of(std::span<const double> values);

// Whether a pass takes samples: its name begins with "ambient_occlusion".
[[nodiscard]] bool is_gather(std::string_view pass);

// What the readings of a configuration come to. Passes in the order of the first reading that has them; a
// pass that is not in every reading has the median of those that it is in. A time in copies is that of its
// reading over the copy of the same reading, so that drift of the machine cancels.
[[nodiscard]] Row row_of(const Configuration& configuration, const Quality& quality,
                         std::span<const Reading> readings);

}  // namespace gloam::report
