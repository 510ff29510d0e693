// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "backend/vulkan/device.hpp"
#include "effect/ambient_occlusion.hpp"
#include "effect/composite.hpp"
#include "effect/errors.hpp"
#include "pictures/light.hpp"
#include "pictures/sheet.hpp"
#include "report/output.hpp"
#include "report/page.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::cli {

// x, y, z of each vector.
[[nodiscard]] std::vector<float> components_of(const std::vector<glm::vec3>& vectors);

// Writes a frame of docs/gbuffer-format.md. read_gbuffer() and link() restore the view from it, within the
// rounding of the files.
void write_gbuffer(report::OutputFolder& folder, int number, const scene::GBuffer& view);

// STEM_ao.pfm and .png, of the filtered image.
void write_images(report::OutputFolder& folder, const std::string& stem, const effect::Frame& frame);

// Errors of a frame against the truth.
struct FrameErrors {
    effect::Errors raw;
    effect::Errors filtered;
    std::optional<effect::Errors> filtered_depth;  // against the truth of the depth buffer alone
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
    double samples = 0.0;           // asked of a pixel with a surface, mean
    double mean_convergence = 0.0;  // over the pixels with geometry
    HistoryReport history;
    std::optional<double> flicker;  // of the filtered image, from the frame before
    std::optional<TruthReport> truth;
    std::optional<FrameErrors> errors;
};

struct RenderReport {
    std::string source;
    std::string name;  // of the run, among several: its preset where presets are compared, else its method
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

// Pictures of a frame for display, in 8-bit colour.
struct Pictures {
    std::string name;  // of its files, without the part from _ on
    gpu::Extent extent;
    base::RgbBytes plain;       // lit, without occlusion
    base::RgbBytes shaded;      // lit, with occlusion
    base::RgbBytes visibility;  // white where open
    base::RgbBytes truth;       // white where open; empty: there is no truth
    base::RgbBytes truth_lit;   // lit, with the true occlusion; empty: there is no truth
    base::RgbBytes error;       // of the occlusion against the truth; empty: there is no truth
};

// One run of one method: its report, and the pictures of its last frame.
struct Rendered {
    RenderReport report;
    Pictures last;
};

// The error at the bright end of the heat map.
inline constexpr double brightest_error = 0.25;

// Pictures, lit by the pass that engines use. occlusion: a value for each pixel; truth: the same, or empty.
// multi_bounce: light bounces among blockers (gloam_multi_bounce).
[[nodiscard]] Pictures pictures_of(const effect::Composite& composite, std::string name,
                                   const pictures::PictureLight& light, const std::vector<float>& occlusion,
                                   const effect::Truth& truth, bool multi_bounce);

// Writes NAME_plain.png and NAME_shaded.png, with a truth NAME_true.png and NAME_error.png as well.
void write_pictures(report::OutputFolder& folder, const Pictures& pictures);

// Sum of the passes of the last frame, ms; NaN where the device has no clock.
[[nodiscard]] double frame_ms(const RenderReport& report);

// Root mean square error of the last frame's filtered image; nullopt without a truth.
[[nodiscard]] std::optional<double> frame_error(const RenderReport& report);

// "sweep, 3.2 ms, error 0.031": for captions.
[[nodiscard]] std::string caption_of(const RenderReport& report);

// A PNG sheet. For one run: lit without and with occlusion, the occlusion alone, and its error if the truth
// is known. For several runs: the truth if it is known, then the occlusion of each with its name, time and
// error. Throws std::invalid_argument for no runs.
[[nodiscard]] std::string sheet_of(const std::vector<Rendered>& runs);

// Writes the pictures of a run into a page's folder, under names that begin with `prefix`, and adds them to
// the page, one of them shown at a time.
void add_pictures(report::Page& page, report::OutputFolder& folder, const std::string& prefix,
                  const Rendered& run);

}  // namespace gloam::cli
