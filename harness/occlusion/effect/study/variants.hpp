// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "effect/settings.hpp"

namespace gloam::effect {

// The effect with one mechanism switched off.
struct Variant {
    std::string name;     // of what is switched off; "full" for nothing
    std::string instead;  // what replaces the mechanism
    Settings settings;
};

// The full effect, then one variant for each mechanism of the temporal effect, with that mechanism switched
// off.
[[nodiscard]] std::vector<Variant> ablations_of(const Settings& full);

}  // namespace gloam::effect
