// SPDX-License-Identifier: MIT
#include "effect/internal/precision_name.hpp"

#include "effect/setting_table.hpp"

namespace gloam::effect {

std::string name_of(HistoryPrecision precision) {
    Settings settings;
    settings.precision = precision;
    return std::get<std::string>(setting_named("precision").get(settings));
}

}  // namespace gloam::effect
