// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>

// Angles in radians for the reference estimators.
namespace gloam::effect::own {

inline constexpr double turn = 2.0 * std::numbers::pi;
inline constexpr double right_angle = 0.5 * std::numbers::pi;

}  // namespace gloam::effect::own
