// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "effect/settings.hpp"

namespace gloam::effect {

// The effect with one mechanism switched off.
struct Variant {
    std::string name;     // of what is switched off; "full" for nothing
    std::string instead;  // what takes its place
    Settings settings;
};

// Every mechanism of the temporal effect switched off alone; first the full effect.
[[nodiscard]] std::vector<Variant> ablations_of(const Settings& full);

}  // namespace gloam::effect
