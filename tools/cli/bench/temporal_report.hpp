// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "effect/study/motion_study.hpp"
#include "effect/study/still_study.hpp"
#include "gpu/device.hpp"

namespace gloam::cli {

// The results of one scene.
struct TemporalReport {
    std::string scene;
    std::string preset;
    gpu::DeviceInfo device;
    gpu::Extent extent;
    double weight_max = 0.0;  // of the full effect
    std::vector<effect::StillFrame> still;
    effect::MotionStudy motion;
};

// A requirement, and the measured value.
struct Criterion {
    std::string what;
    double measured = 0.0;  // NaN where the scene has no such pixels
    double allowed = 0.0;
};
[[nodiscard]] std::vector<Criterion> criteria_of(const TemporalReport& report);

// Tables as Markdown: criteria, convergence, errors by class for each mechanism that is switched off.
[[nodiscard]] std::string to_markdown(const TemporalReport& report);

// All scenes, with every number of every frame.
[[nodiscard]] std::string to_json(const std::vector<TemporalReport>& reports);

}  // namespace gloam::cli
