// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>

#include "check/values.hpp"

// Inputs of the functions that see a scene through a camera.
namespace gloam::catalogue {

// GloamCamera: perspective or orthographic, of the size of the run's images (1 x 1 beside special values).
[[nodiscard]] check::Values cameras();

// Takes the vec3 at word `position` of a row, drawn as (ndc, depth), to the view-space position there in the
// GloamCamera at word `camera`. What was not drawn so (special values) stays as it is.
[[nodiscard]] std::function<void(std::span<check::Word>)> place_before_camera(std::size_t position,
                                                                              std::size_t camera);

}  // namespace gloam::catalogue
