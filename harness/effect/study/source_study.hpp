// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "effect/settings.hpp"
#include "gpu/device.hpp"
#include "gpu/image.hpp"
#include "scene/pass_library.hpp"
#include "scene/truth_cache.hpp"

// Experiments from the published sources, repeated with this library's implementation.
namespace gloam::effect {

struct SourceOptions {
    gpu::Extent extent{640, 360};
    int rounds = 7;  // each round times everything once, in turn; the least time is reported
    int rays = 256;  // of the truth, for each pixel
    std::function<void(double)> progress{};  // called with the completed part, in [0, 1]
};

// One configuration in an experiment, on the first frame of a scene.
struct SourceRow {
    std::string scene;
    std::string name;           // of the configuration
    std::string what;           // the change
    Settings settings;          // for a radius of 1
    double radius = 1.0;        // in units of the scene's radius
    double taken = 0.0;         // samples taken for each pixel with geometry, mean
    double occlusion_ms = 0.0;  // least time of the passes that estimate the occlusion, preparation included
    double filter_ms = 0.0;     // least time of both passes of the filter
    double error = 0.0;         // RMSE of the displayed image, against the geometry truth for that radius
    double error_before = 0.0;  // the same against the truth for the scene's own radius
    double error_remapped = 0.0;  // after the best remap (remap_fit.hpp); of study_quality() alone
};

// ISSAO's table 1: four methods of 12 taps, each without a filter and with the bilateral one, on `scene`.
[[nodiscard]] std::vector<SourceRow> study_issao_table(const gpu::Device& device,
                                                       const scene::PassLibrary& passes,
                                                       const scene::TruthCache& cache,
                                                       const std::string& scene,
                                                       const SourceOptions& options);

// The comparative study's quality configurations: samples doubled, from one unit on, until more of them lower
// the error by less than a hundredth. Without a filter and without history.
[[nodiscard]] std::vector<SourceRow> study_quality(const gpu::Device& device,
                                                   const scene::PassLibrary& passes,
                                                   const scene::TruthCache& cache, const std::string& scene,
                                                   const SourceOptions& options);

// The comparative study's scalability experiment (Aalund and Baerentzen 2013): its performance configurations
// at the scene's radius, at twice the radius, and at twice the radius with twice the samples. Like
// study_issao_table(), it throws std::runtime_error for a device without a clock, and like AmbientOcclusion.
[[nodiscard]] std::vector<SourceRow> study_radius(const gpu::Device& device, const scene::PassLibrary& passes,
                                                  const scene::TruthCache& cache, const std::string& scene,
                                                  const SourceOptions& options);

}  // namespace gloam::effect
