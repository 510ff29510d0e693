// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "experiment/benchmark_views.hpp"
#include "experiment/experiment.hpp"

namespace gloam::experiment {

// The scene or the view of a case. Throws like scene::make_scene() and scene::make_view(), and
// std::invalid_argument for a number of objects of a scene without any.
[[nodiscard]] scene::Scene scene_of(const Case& one, const std::filesystem::path& meshes);

// The frames of a case at a size of the experiment, without the truth of the depth buffer. Changed views have
// no truth.
[[nodiscard]] BenchmarkFrames frames_of(const Experiment& experiment, const Case& one, gpu::Extent extent);

}  // namespace gloam::experiment
