// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/render_report.hpp"
#include "effect/composite.hpp"
#include "effect/errors.hpp"
#include "report/image.hpp"
#include "report/output_folder.hpp"
#include "scene/lighting.hpp"

namespace gloam::cli {

// Pictures of a frame for display, in 8-bit colour.
struct Pictures {
    std::string name;  // of its files, without the part from _ on
    gpu::Extent extent;
    report::RgbBytes plain;       // lit, without occlusion
    report::RgbBytes shaded;      // lit, with occlusion
    report::RgbBytes visibility;  // white where open
    report::RgbBytes truth;       // white where open; empty: there is no truth
    report::RgbBytes error;       // of the occlusion against the truth; empty: there is no truth
};

// One run of one method: its report, and the pictures of its last frame; for a turntable those of all frames.
struct Rendered {
    RenderReport report;
    std::vector<Pictures> pictures;
};

// The error at the bright end of the heat map.
inline constexpr double brightest_error = 0.25;

// Pictures, lit by the pass that engines use. occlusion: a value for each pixel of the light; truth: the
// same, or empty.
[[nodiscard]] Pictures pictures_of(const effect::Composite& composite, std::string name, gpu::Extent extent,
                                   const scene::SplitLight& light, const std::vector<float>& occlusion,
                                   const effect::Truth& truth);

// Writes NAME_plain.png, NAME_shaded.png, and NAME_error.png if there is an error.
void write_pictures(report::OutputFolder& folder, const Pictures& pictures);

// Sum of the passes of the last frame, ms; NaN where the device has no clock.
[[nodiscard]] double frame_ms(const RenderReport& report);

// Root mean square error of the last frame's filtered image; nullopt without a truth.
[[nodiscard]] std::optional<double> frame_error(const RenderReport& report);

// "gtao, 3.2 ms, error 0.031": for captions.
[[nodiscard]] std::string caption_of(const RenderReport& report);

// A PNG sheet. For one run: lit without and with occlusion, the occlusion alone, and its error if the truth
// is known. For several runs: the truth if it is known, then the occlusion of each with its name, time and
// error. Throws std::invalid_argument for no runs.
[[nodiscard]] std::string sheet_of(const std::vector<Rendered>& runs);

}  // namespace gloam::cli
