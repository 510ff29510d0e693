// SPDX-License-Identifier: MIT
// What `gloam render` is asked, what it renders, and what it says and shows of that.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "backend/vulkan/device.hpp"
#include "base/image_files.hpp"
#include "effect/ambient_occlusion.hpp"
#include "effect/composite.hpp"
#include "effect/errors.hpp"
#include "effect/methods.hpp"
#include "pictures/light.hpp"
#include "pictures/sheet.hpp"
#include "record/output.hpp"
#include "record/page.hpp"
#include "scene/gbuffer.hpp"
#include "scene/pass_library.hpp"
#include "scene/scene.hpp"
#include "scene/truth.hpp"

namespace gloam::cli {

// Placement and view of a mesh, as text of the command line: see scene::MeshView.
struct MeshOptions {
    std::string eye;             // "X,Y,Z"; empty: as near as it can be
    std::string look_at;         // likewise; empty: the middle of the mesh
    std::string orbit;           // "AZIMUTH,ELEVATION"; empty: the default
    std::optional<double> fovy;  // degrees; otherwise that of scene::MeshView
    std::string up = "y";
    bool no_ground = false;

    [[nodiscard]] bool given() const {
        return !eye.empty() || !look_at.empty() || !orbit.empty() || fovy || up != "y" || no_ground;
    }
};

// The options of `gloam render`.
struct RenderOptions {
    std::string source;             // a scene's name or a mesh file; empty with gbuffer
    std::filesystem::path gbuffer;  // folder of an engine's frames
    std::string depth = "linear";   // how they store depth and normals: scene::encoding_named()
    std::string normals = "view";
    std::string method;                           // of one run; empty: the preset's
    std::string preset = effect::default_preset;  // of one run
    std::optional<std::uint32_t> samples;
    std::optional<int> frames;
    int frame = 0;       // of a scene that moves: the first
    bool still = false;  // it is held there
    std::string size = "640x360";
    int antialias = 2;            // samples on each side of a pixel, of lit pictures
    std::optional<float> radius;  // world units; otherwise the view's own
    std::optional<float> bias;    // world units; otherwise a part of the radius
    std::optional<float> guard;   // part of the image on each side
    bool no_filter = false;
    std::vector<std::string> set;      // NAME=VALUE
    bool multi_bounce = false;         // in lit pictures
    bool bent_normals = false;         // and cones
    int bent_interleave = 1;           // side of the blocks that share a pattern
    std::optional<std::string> light;  // white or sky: directional occlusion in it
    int repeat = 1;
    std::string device;
    bool validation = false;
    bool trace_truth = false;  // --truth without a file
    bool truth_every = false;  // trace it for each frame; otherwise for the last alone
    std::string truth;         // PFM; empty: none
    std::string truth_falloff = "linear";
    int truth_rays = 1024;                                             // for each pixel
    double truth_thickness = std::numeric_limits<double>::infinity();  // world units
    std::filesystem::path write_gbuffer;                               // folder
    std::filesystem::path out = "gloam-out";
    MeshOptions mesh;
    std::vector<std::string> methods;  // several: each is run, and a sheet compares them; "all"
    std::vector<std::string> presets;  // likewise; several of one of the two
    bool quiet = false;
};

// The views to shade: one still view, on which frames accumulate, or a sequence of views.
struct RenderInput {
    std::string name;
    std::vector<int> views;  // their numbers, which are also in the names of written files
    int first_frame = 0;     // of a scene: view 0 shows it
    int frames_per_view = 1;
    int picture_samples = 1;  // on each side of a pixel, of lit pictures
    std::function<scene::GBuffer(const gpu::Device&, int view)> load;
    std::shared_ptr<const scene::Scene> scene;  // null for G-buffers from elsewhere
    effect::TrueOcclusion truth;                // empty if it is unknown
    std::string truth_name;
};

// Checks the names and files of the options, as far as that is possible without a device. Throws
// std::invalid_argument or std::runtime_error with the error in one line. `like`: an input of the same
// source, whose scene is used instead of reading it again; null: none.
[[nodiscard]] RenderInput open_input(const RenderOptions& options, const RenderInput* like = nullptr);

// The traced truth of one view.
struct TracedView {
    std::optional<scene::TracedTruth> geometry;  // (G); not for a G-buffer from elsewhere
    scene::TracedTruth depth;                    // (D)
};

// The truth for a view.
struct ViewTruth {
    effect::Truth truth;               // empty: unknown
    std::optional<TracedView> traced;  // with --truth
};

// The source of the truth in a call of `gloam render`: rays, a file, or a closed form.
class TruthSource {
  public:
    // Reads the file of the options. Throws std::runtime_error with its name, std::invalid_argument for
    // options that exclude each other.
    TruthSource(const RenderOptions& options, const RenderInput& input);

    [[nodiscard]] std::string name() const;  // empty: there is none

    // Whether every view of a sequence is compared, or only the last: tracing takes long, and a file has one
    // image.
    [[nodiscard]] bool every_view() const;

    // frame: of the scene.
    [[nodiscard]] ViewTruth of(const scene::GBuffer& view, int frame, double radius) const;

  private:
    [[nodiscard]] TracedView traced(const scene::GBuffer& view, int frame, double radius) const;

    const RenderOptions& options_;
    const RenderInput& input_;
    std::optional<base::FloatImage> reference_;
    scene::Falloff falloff_ = scene::Falloff::linear;
};

// Writes the traced images: PREFIXtruth.pfm and .png, PREFIXtruth_depth.pfm and .png, PREFIXtruth_error.pfm
// (the standard errors).
void write_truth(record::OutputFolder& folder, const std::string& prefix, gpu::Extent size,
                 const TracedView& traced);

// x, y, z of each vector.
[[nodiscard]] std::vector<float> components_of(const std::vector<glm::vec3>& vectors);

// Writes a frame of docs/gbuffer-format.md. read_gbuffer() and link() restore the view from it, within the
// rounding of the files.
void write_gbuffer(record::OutputFolder& folder, int number, const scene::GBuffer& view);

// STEM_ao.pfm and .png, of the filtered image.
void write_images(record::OutputFolder& folder, const std::string& stem, const effect::Frame& frame);

// STEM_tiles.png: the occlusion, tinted in each tile of 8 x 8 pixels by the frame's work in it: blue
// background, green a radius below a pixel, white half size, orange in full. view: with its guard band.
void write_tiles(record::OutputFolder& folder, const std::string& stem, const effect::Frame& frame,
                 const scene::GBuffer& view);

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
    effect::TileShares tiles;
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
void write_pictures(record::OutputFolder& folder, const Pictures& pictures);

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
void add_pictures(record::Page& page, record::OutputFolder& folder, const std::string& prefix,
                  const Rendered& run);

// The name of a run among several: its preset, of a file without folder and suffix, where presets are
// compared, else its method. Throws like settings_for().
[[nodiscard]] std::string name_of(const RenderOptions& options);

// The common parts of runs of several methods on one input: the device, the passes, and the light of the last
// rendered view, which does not depend on the method.
class RenderBench {
  public:
    // Opens the device that the options name.
    explicit RenderBench(const RenderOptions& options);

    // The light of the view with this number.
    [[nodiscard]] const pictures::PictureLight& light_of(const RenderInput& input, int number,
                                                         const scene::GBuffer& view, bool watched);

    // Call it before a view of another input.
    void forget_light() { lit_.reset(); }

    gpu::Device device;
    scene::PassLibrary passes;
    effect::Composite composite;

  private:
    std::optional<int> lit_;
    pictures::PictureLight light_;
};

// The output of a run: written to `folder`, with names that begin with `prefix`.
struct RenderOutput {
    record::OutputFolder* folder = nullptr;  // null: nothing is written
    std::string prefix = {};
};

// Renders the views of an input with one method and writes their files, PREFIXrender.json among them.
[[nodiscard]] Rendered render(const RenderOptions& options, const RenderInput& input, RenderBench& bench,
                              const RenderOutput& output);

}  // namespace gloam::cli
