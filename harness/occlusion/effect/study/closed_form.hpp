// SPDX-License-Identifier: MIT
#pragma once

#include "effect/ambient_occlusion.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::effect {

// A measured number and its standard error.
struct Estimate {
    double value = 0.0;
    double error = 0.0;
};

// The occlusion of the point of a closed-form view, drawn, by the real passes, with history, without filter,
// remap and rotation: the mean over all frames of 1024 samples, with a standard error from the spread of the
// frames' means. Consecutive frames of a low-discrepancy sequence have opposite errors, so the actual error
// of the mean is smaller than this estimate. Settings are for a radius of 1. frames: 2 or more. Throws like
// AmbientOcclusion.
[[nodiscard]] Estimate measured(AmbientOcclusion& effect, const scene::GBuffer& view,
                                const Settings& settings, int frames);

}  // namespace gloam::effect
