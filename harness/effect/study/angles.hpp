// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>

// Angles in radians that the estimators of our own are written with.
namespace gloam::effect::own {

inline constexpr double turn = 2.0 * std::numbers::pi;
inline constexpr double right_angle = 0.5 * std::numbers::pi;

}  // namespace gloam::effect::own
