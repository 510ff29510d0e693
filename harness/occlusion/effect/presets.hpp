// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "effect/settings.hpp"

namespace gloam::effect {

// Settings that belong together; lengths are for a radius of 1.
struct Preset {
    std::string name;
    std::string description;
    Settings settings;
};

[[nodiscard]] std::vector<Preset> presets();

// The preset with this name. Throws std::invalid_argument that lists the names.
[[nodiscard]] Preset preset_named(std::string_view name);

}  // namespace gloam::effect
