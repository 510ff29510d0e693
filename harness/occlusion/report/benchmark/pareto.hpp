// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "report/benchmark/result.hpp"

namespace gloam::report {

// Positions of the (cost, error) points that no other point dominates: at least as good in both and better in
// one. Cheapest first; of equal points the first. Points that are not finite are in no front.
[[nodiscard]] std::vector<std::size_t> pareto_front(std::span<const std::pair<double, double>> points);

// The scenes of a benchmark, in their order.
[[nodiscard]] std::vector<std::string> scenes_of(const Benchmark& benchmark);

// The rows of a scene on its front: copies of all passes against the RMSE of the displayed image and (G).
// Cheapest first. The pointers are valid as long as the benchmark.
[[nodiscard]] std::vector<const Row*> front_of(const Benchmark& benchmark, const std::string& scene);

// A choice over all scenes.
struct Overall {
    Configuration choice;       // its scene is empty
    double copies = 0.0;        // of all passes: geometric mean over the scenes
    double ms = 0.0;            // the same in milliseconds
    double error_ratio = 0.0;   // geometric mean of the ratio of the error to the least error in the scene
    double worst_copies = 0.0;  // in the scene with the longest time
    double worst_ms = 0.0;
    double mean_error = 0.0;   // RMSE against (G), mean over the scenes
    double worst_error = 0.0;  // in the scene with the largest error
};

// Every choice that was measured in all scenes, in the order of the first scene.
[[nodiscard]] std::vector<Overall> overall_of(const Benchmark& benchmark);

// The choices on the front of copies against error_ratio, cheapest first.
[[nodiscard]] std::vector<Overall> front_of(std::span<const Overall> choices);

}  // namespace gloam::report
