// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/errors.hpp"
#include "effect/metrics.hpp"
#include "gpu/device.hpp"

namespace gloam::cli {

// Errors of a frame against the truth.
struct FrameErrors {
    effect::Errors raw;
    effect::Errors filtered;
    std::optional<effect::Errors> filtered_depth;  // against the truth of the depth buffer alone
    std::optional<effect::Errors> further_views;   // of the estimate raised by further views
    std::optional<effect::Metrics> metrics;        // of the filtered image; in a view's last frame
    std::optional<effect::ClassErrors> by_class;   // of the filtered image; from the second frame on
};

// The report of a traced truth.
struct TruthReport {
    std::uint64_t rays = 0;               // for each pixel
    std::uint64_t pixels = 0;             // with geometry
    std::uint64_t unmatched = 0;          // of these, pixels whose surface the rays did not find
    double standard_error = 0.0;          // root mean square over the pixels
    std::optional<effect::Errors> depth;  // of the depth buffer's truth, against that of the geometry
};

// The use of the history in a frame.
struct HistoryReport {
    std::string cut;       // why there was no history; empty: there was one
    double kept = 0.0;     // share of the pixels with geometry that have a history, [0, 1]
    double samples = 0.0;  // in the history, mean over those pixels
};

// The report of a frame; its images are in files.
struct FrameReport {
    int number = 0;
    std::optional<int> scene_frame;
    gpu::Extent extent;
    effect::Settings settings;
    std::vector<effect::PassTime> times;
    effect::Work work;
    double mean_convergence = 0.0;  // over the pixels with geometry
    HistoryReport history;
    std::optional<double> flicker;  // of the filtered image, from the frame before
    std::optional<TruthReport> truth;
    std::optional<FrameErrors> errors;
};

struct RenderReport {
    std::string source;
    std::string preset;
    std::string truth;  // the truth that the errors refer to
    gpu::DeviceInfo device;
    int repeat = 1;
    std::vector<FrameReport> frames;
};

// render.json.
[[nodiscard]] std::string to_json(const RenderReport& report);

// A few lines for people: device, settings, and the last frame.
[[nodiscard]] std::string to_text(const RenderReport& report);

}  // namespace gloam::cli
