// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "effect/settings.hpp"

namespace gloam::effect {

struct MethodInfo {
    std::string name;
    std::string description;
    Method method = Method::hemisphere;
};

// A set of settings that goes together; its lengths are for a radius of 1.
struct Preset {
    std::string name;
    std::string description;
    Settings settings;
};

[[nodiscard]] std::vector<MethodInfo> methods();
[[nodiscard]] std::vector<Preset> presets();

// By name. Throw std::invalid_argument that lists the names.
[[nodiscard]] Method method_named(std::string_view name);
[[nodiscard]] Preset preset_named(std::string_view name);
[[nodiscard]] std::string name_of(Method method);

}  // namespace gloam::effect
