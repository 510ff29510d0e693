// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "gpu/device.hpp"
#include "stress/row.hpp"

namespace gloam::stress {

// Column titles, and one line for each row: run, what was varied, what was measured, the number, its bound
// and the verdict. Rows without a bound have no verdict.
[[nodiscard]] std::string table_header();
[[nodiscard]] std::string table_line(const Row& row);

// {"device": {"name", "driver"}, "rows": [{"run", "varied", "quantity", "measured", "bound", "passed"}]}.
// bound is null where nothing is promised. Infinite numbers are the strings "inf" and "-inf", NaN is "nan".
[[nodiscard]] std::string to_json(const gpu::DeviceInfo& device, const Rows& rows,
                                  const std::string& versions = {});

}  // namespace gloam::stress
