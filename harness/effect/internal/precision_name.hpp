// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "effect/settings.hpp"

namespace gloam::effect {

// As the setting "precision" names it.
[[nodiscard]] std::string name_of(HistoryPrecision precision);

}  // namespace gloam::effect
