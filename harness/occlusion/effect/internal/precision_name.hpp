// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "effect/settings.hpp"

namespace gloam::effect {

// The name of a precision as the setting "precision" uses it.
[[nodiscard]] std::string name_of(HistoryPrecision precision);

}  // namespace gloam::effect
