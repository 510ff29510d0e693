// SPDX-License-Identifier: MIT
#pragma once

#include "effect/methods.hpp"

// The methods by what they sample: a list for each family.
namespace gloam::effect {

[[nodiscard]] std::vector<MethodInfo> point_methods();
[[nodiscard]] std::vector<MethodInfo> tap_methods();
[[nodiscard]] std::vector<MethodInfo> volumetric_methods();
[[nodiscard]] std::vector<MethodInfo> slice_methods();
[[nodiscard]] std::vector<MethodInfo> ray_methods();
[[nodiscard]] std::vector<MethodInfo> surface_methods();

// Settings of a published configuration. The number of samples is the same before and after convergence.
[[nodiscard]] Settings configuration(const MethodInfo& method, std::uint32_t samples);

// The comparative study's settings (Aalund and Baerentzen 2013), quality configuration: frames without
// history, without a blur.
[[nodiscard]] Settings studied(Settings settings);

// The study's performance configuration, with its blur. half_width: taps on each side, at least 1.
[[nodiscard]] Settings blurred(Settings settings, int half_width = 2);

// What the study prints for every method, and `more` for one.
[[nodiscard]] Printed printed_by_study(const Printed& more);

// `count` rays or slices of `steps` steps each.
[[nodiscard]] Settings rays(const MethodInfo& method, std::uint32_t count, std::uint32_t steps);
[[nodiscard]] Settings slices(const MethodInfo& method, std::uint32_t count, std::uint32_t steps);

}  // namespace gloam::effect
