// SPDX-License-Identifier: MIT
// What `gloam render` is asked, what it renders, and what it says and shows of that.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "backend/vulkan/device.hpp"
#include "base/image_files.hpp"
#include "effect/ambient_occlusion.hpp"
#include "effect/composite.hpp"
#include "effect/directional.hpp"
#include "effect/errors.hpp"
#include "effect/methods.hpp"
#include "effect/pixel_classes.hpp"
#include "pictures/light.hpp"
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

    friend bool operator==(const MeshOptions&, const MeshOptions&) = default;
};

// A case: what is shown in how many frames, and the truth with which they are compared.
struct RenderCase {
    std::string source;             // a scene's name or a mesh file; empty with gbuffer
    MeshOptions mesh;               // of a mesh file
    std::filesystem::path gbuffer;  // folder of an engine's frames
    std::string depth = "linear";   // how they store depth and normals: scene::encoding_named()
    std::string normals = "view";
    std::string size = "640x360";
    std::optional<int> frames;
    int frame = 0;                     // of a scene that moves: the first
    bool still = false;                // it is held there
    std::optional<std::string> truth;  // PFM; empty: it is traced; nullopt: none
    bool truth_every = false;          // trace it for each frame; otherwise for the last alone
    std::string truth_falloff = "linear";
    scene::TruthSettings traced;  // rays for each pixel, and thickness in world units
};

// A candidate: a method with the settings of a preset, and what the command line changes of them.
struct RenderCandidate {
    std::string preset = effect::default_preset;
    std::string method;  // empty: the preset's
    std::optional<std::uint32_t> samples;
    std::optional<float> radius;  // world units; otherwise the view's own
    std::optional<float> bias;    // world units; otherwise a part of the radius
    std::optional<float> guard;   // part of the image on each side
    bool no_filter = false;
    bool bent_normals = false;     // and cones
    int bent_interleave = 1;       // side of the blocks that share a pattern
    std::vector<std::string> set;  // NAME=VALUE
    std::string name;              // among several: its preset where presets are compared, else its method
    std::string prefix;            // of its files; empty: it is the only one
};

// The options of `gloam render`: a case, candidates, and what is made of these.
struct RenderOptions {
    RenderCase shown;
    std::vector<std::string> methods;  // "all"; none: the presets'
    std::vector<std::string> presets;  // none: the default; several of one of the two are compared
    RenderCandidate candidate;         // what all have in common
    int repeat = 1;
    std::string device;
    bool validation = false;
    int antialias = 2;                    // samples on each side of a pixel, of lit pictures
    bool multi_bounce = false;            // in lit pictures
    std::optional<std::string> light;     // white or sky: directional occlusion in it
    std::filesystem::path write_gbuffer;  // folder
    std::filesystem::path out = "gloam-out";
    bool quiet = false;
};

// A view as a candidate shades it.
struct ShadedView {
    int number;  // of RenderInput::views
    effect::Settings settings{};
    scene::GBuffer wide{};                         // the view with its guard band
    scene::GBuffer view{};                         // without
    std::string cut{};                             // why it has no history; empty: it has one
    effect::Truth truth{};                         // empty if it is unknown, or not requested for this view
    std::optional<scene::TracedTruth> geometry{};  // (G), traced; not for a G-buffer from elsewhere
    std::optional<scene::TracedTruth> depth{};     // (D), traced

    // Where it was traced: what `truth` is made of.
    [[nodiscard]] const scene::TracedTruth& best() const { return geometry ? *geometry : *depth; }
};

// The views to shade: one still view, on which frames accumulate, or a sequence of views.
struct RenderInput {
    std::string name;
    std::vector<int> views;  // their numbers, which are also in the names of written files
    int first_frame = 0;     // of a scene: view 0 shows it
    int frames_per_view = 1;
    // With the guard band and the layers of the settings.
    std::function<scene::GBuffer(const backend::vulkan::Device&, int view, const effect::Settings&)> load;
    std::shared_ptr<const scene::Scene> scene;  // null for G-buffers from elsewhere
    // Adds the truth of a view; frame: of the scene; both: (D) beside (G), too. Empty: it is unknown.
    std::function<void(ShadedView& shown, int frame, bool both)> truth;
    std::string truth_name;
    // Every view of a sequence is compared; otherwise the last: tracing takes long, and a file has one image.
    bool every_truth = true;
    std::vector<RenderCandidate> candidates;
};

// What the demo shows: a view that no setting is fitted to, with skipped tiles, beside traced truth.
[[nodiscard]] RenderOptions demo_options(bool quiet);

// Checks the names and files of the options, as far as that is possible without a device. Throws
// std::invalid_argument or std::runtime_error with the error in one line.
[[nodiscard]] RenderInput open_input(const RenderOptions& options);

// How a frame relates to the one before it, which a temporal method follows.
struct FrameChange {
    std::optional<double> flicker;  // mean change at the same surface points; nullopt: no relation
    std::optional<effect::PixelClasses> classes;  // of the frame's pixels
};

// Pictures of a frame for display, in 8-bit colour. Those of the truth are empty where there is none.
struct Pictures {
    std::string name;  // of its files, without the part from _ on
    backend::Extent extent;
    base::RgbBytes plain;        // lit, without occlusion
    base::RgbBytes shaded;       // lit, with occlusion
    base::RgbBytes visibility;   // white where open
    base::RgbBytes truth{};      // white where open
    base::RgbBytes truth_lit{};  // lit, with the true occlusion
    base::RgbBytes error{};      // of the occlusion against the truth
    base::RgbBytes tiles{};      // tinted_tiles(); empty without Resolution::tiles
};

// One candidate, rendered; all but the report is of its last frame.
struct Rendered {
    std::string name;
    nlohmann::ordered_json report;  // render.json
    effect::Settings settings;
    effect::Frame frame;
    std::optional<double> error;  // root mean square, of the filtered image; nullopt without a truth
    Pictures pictures;

    // Sum of the passes; NaN where the device has no clock.
    [[nodiscard]] double ms() const;
};

// The report of a view's i-th frame, for render.json.
[[nodiscard]] nlohmann::ordered_json frame_json(const RenderInput& input, const ShadedView& shown, int i,
                                                const effect::Frame& frame, const FrameChange& change);

// The report of a candidate. run: all of it but this.
[[nodiscard]] nlohmann::ordered_json report_of(const RenderOptions& options, const RenderInput& input,
                                               const RenderCandidate& candidate,
                                               const backend::DeviceInfo& device, const Rendered& run,
                                               const nlohmann::ordered_json& frames);

// A few lines for people: device, settings, and the last frame.
[[nodiscard]] std::string to_text(const Rendered& run);

// Writes a frame of docs/gbuffer-format.md. read_gbuffer() and link() restore the view but for rounding.
void write_gbuffer(record::OutputFolder& folder, int number, const scene::GBuffer& view);

// Writes the traced images: PREFIXtruth.pfm and .png, PREFIXtruth_depth.pfm and .png, PREFIXtruth_error.pfm
// (the standard errors).
void write_truth(record::OutputFolder& folder, const std::string& prefix, const ShadedView& traced);

// With Resolution::tiles the occlusion, tinted in each tile of 8 x 8 pixels by the frame's work in it: blue
// background, green a radius below a pixel, white half size, orange in full. Otherwise empty.
[[nodiscard]] base::RgbBytes tinted_tiles(const ShadedView& shown, const effect::Frame& frame);

// Writes STEM_ao.pfm and .png, of the filtered image, and STEM_tiles.png where there are some.
void write_frame(record::OutputFolder& folder, const std::string& stem, const effect::Frame& frame,
                 const base::RgbBytes& tiles);

// Writes STEM_bent.pfm (x, y, z in view space) and .png (0.5 + 0.5 of it), STEM_cone.pfm (half angle, rad).
void write_bent(record::OutputFolder& folder, const std::string& stem, const effect::BentNormals& bent);

// Writes STEM_light.pfm (linear radiance, direct and bounced) and .png (sRGB, white from 1 on),
// STEM_bounce.pfm (the bounced part).
void write_light(record::OutputFolder& folder, const std::string& stem,
                 const effect::DirectionalLight& light);

// Writes NAME_plain.png and NAME_shaded.png, with a truth NAME_true.png and NAME_error.png as well.
void write_pictures(record::OutputFolder& folder, const Pictures& pictures);

// Pictures, lit by the pass that engines use. occlusion: a value for each pixel; truth: the same, or empty.
// multi_bounce: light bounces among blockers (gloam_multi_bounce).
[[nodiscard]] Pictures pictures_of(const effect::Composite& composite, std::string name,
                                   const pictures::PictureLight& light, const std::vector<float>& occlusion,
                                   const effect::Truth& truth, bool multi_bounce);

// A PNG sheet. For one run: lit without and with occlusion, the occlusion alone, and its error. For several:
// the truth, then the occlusion of each with its name, time and error. Without a truth there is no error.
[[nodiscard]] std::string sheet_of(const std::vector<Rendered>& runs);

// Writes the pictures of a run into a page's folder, and adds them to the page, one of them shown at a time.
void add_pictures(record::Page& page, record::OutputFolder& folder, const Rendered& run,
                  const std::string& caption);

// Renders the views of an input with each candidate. folder: of PREFIXrender.json and all files, or nullptr.
[[nodiscard]] std::vector<Rendered> render(const RenderOptions& options, const RenderInput& input,
                                           const backend::vulkan::Device& device,
                                           record::OutputFolder* folder);

}  // namespace gloam::cli
