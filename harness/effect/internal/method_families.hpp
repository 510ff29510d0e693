// SPDX-License-Identifier: MIT
#pragma once

#include "effect/methods.hpp"

// The methods by what they sample, one list a file of effect/methods.
namespace gloam::effect {

[[nodiscard]] std::vector<MethodInfo> point_methods();
[[nodiscard]] std::vector<MethodInfo> tap_methods();
[[nodiscard]] std::vector<MethodInfo> pair_methods();
[[nodiscard]] std::vector<MethodInfo> slice_methods();
[[nodiscard]] std::vector<MethodInfo> ray_methods();
[[nodiscard]] std::vector<MethodInfo> surface_methods();

// Settings of a published configuration, with as many samples before convergence as after.
[[nodiscard]] Settings configuration(const MethodInfo& method, std::uint32_t samples);

// The comparative study's (Aalund and Baerentzen 2013): each frame by itself, in its quality configuration
// without a blur.
[[nodiscard]] Settings studied(Settings settings);

// In its performance configuration with its blur, one pixel wide at the least.
[[nodiscard]] Settings blurred(Settings settings, int half_width = 2);

// Rays or slices of so many steps.
[[nodiscard]] Settings rays(const MethodInfo& method, std::uint32_t count, std::uint32_t steps);
[[nodiscard]] Settings slices(const MethodInfo& method, std::uint32_t count, std::uint32_t steps);

}  // namespace gloam::effect
