// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/errors.hpp"
#include "gpu/device.hpp"

namespace gloam::cli {

// Errors of a frame against the truth.
struct FrameErrors {
    effect::Errors raw;
    effect::Errors filtered;
};

// What is told of a frame; its images lie in files.
struct FrameReport {
    int number = 0;
    gpu::Extent extent;
    effect::Settings settings;
    std::vector<effect::PassTime> times;
    effect::Work work;
    double mean_convergence = 0.0;  // over the pixels with geometry
    std::optional<FrameErrors> errors;
};

struct RenderReport {
    std::string source;
    std::string preset;
    std::string truth;  // what the errors are against
    gpu::DeviceInfo device;
    int repeat = 1;
    std::vector<FrameReport> frames;
};

// render.json.
[[nodiscard]] std::string to_json(const RenderReport& report);

// A few lines for people: device, settings, and the last frame.
[[nodiscard]] std::string to_text(const RenderReport& report);

}  // namespace gloam::cli
