// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>

#include "check/values.hpp"

// Inputs of functions that take a camera.
namespace gloam::catalogue {

// GloamCamera: perspective or orthographic, with the size of the run's images (1 x 1 besides special values).
[[nodiscard]] check::Values cameras();

// Returns an adjustment: the vec3 at word `position` of a row, drawn as (ndc, depth), becomes the view-space
// position there in the GloamCamera at word `camera`. Special values, which are not (ndc, depth), are kept.
[[nodiscard]] std::function<void(std::span<check::Word>)> place_before_camera(std::size_t position,
                                                                              std::size_t camera);

}  // namespace gloam::catalogue
