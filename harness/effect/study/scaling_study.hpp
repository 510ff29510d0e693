// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "effect/settings.hpp"
#include "gpu/device.hpp"
#include "gpu/image.hpp"
#include "scene/pass_library.hpp"
#include "scene/scene.hpp"

namespace gloam::effect {

struct ScalingOptions {
    std::string method;
    std::vector<gpu::Extent> sizes{{320, 180}, {640, 360}, {1280, 720}, {1920, 1080}, {3840, 2160}};
    int repeat = 3;                          // rounds over the values of a quantity
    std::function<void(double)> progress{};  // called with the completed part, in [0, 1]
};

// The time of a frame while one quantity grows.
struct ScalingRun {
    std::string of;                                 // "pixels", "samples", "radius in pixels", ...
    std::vector<std::pair<double, double>> points;  // value; all passes, median, milliseconds
    std::vector<double> open;  // share of tiles found open at each point, in [0, 1]; empty: not counted
};

// Times the scene `moving` at the smallest of the sizes, with 16 samples for each pixel, while one quantity
// grows: pixels, samples, the radius, the filter's taps on each side, moving objects. The pixels grow with
// the same radius in pixels. The radius is in pixels at the point that the camera looks at. The frames of
// moving objects have a history. Values are visited in rounds.
//
// The number of pixels grows twice. In "pixels" every tile is sampled, so each pixel is the same work. In
// "pixels, open tiles skipped" open tiles are skipped, as users have it, where the method knows them. How
// many tiles are open depends on the radius in the world, which shrinks as the number of pixels grows. Only
// these two runs count `open`.
//
// Throws std::invalid_argument for no size and an unknown method, and like AmbientOcclusion.
[[nodiscard]] std::vector<ScalingRun> study_scaling(const gpu::Device& device,
                                                    const scene::PassLibrary& passes,
                                                    const ScalingOptions& options);

}  // namespace gloam::effect
