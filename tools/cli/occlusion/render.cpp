// SPDX-License-Identifier: MIT
#include "cli/occlusion/render.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/commands.hpp"
#include "cli/framework/open_device.hpp"

namespace gloam::cli {
namespace {

void print_comparison(const std::vector<Rendered>& runs) {
    const auto text_of = [&](const nlohmann::ordered_json& text) { return text.get<std::string>(); };
    const nlohmann::ordered_json& first = runs.front().report;
    std::size_t width = 0;
    for (const Rendered& run : runs) width = std::max(width, run.name.size());
    fmt::print("{} on {}\n{:<{}} {:>9} {:>8}\n", text_of(first["source"]), text_of(first["device"]["name"]),
               "run", width, "ms/frame", "error");
    for (const Rendered& run : runs)
        fmt::print("{:<{}} {:>9.3f} {:>8}\n", run.name, width, run.ms(),
                   run.error ? fmt::format("{:.4f}", *run.error) : "-");
    if (!first["truth"].is_null())
        fmt::print("error: root mean square, against the {}\n", text_of(first["truth"]));
}

std::vector<Option> options_of(RenderOptions& options) {
    RenderCase& shown = options.shown;
    MeshOptions& mesh = shown.mesh;
    RenderCandidate& candidate = options.candidate;
    const Rules list{.repeated = true, .commas = true};
    return {
        {"source", &shown.source, "scene (gloam list scenes) or mesh file, stood on a ground plane"},
        {"--gbuffer", &shown.gbuffer, "folder of G-buffers of an engine, instead of a scene"},
        {"--depth", &shown.depth,
         "how the G-buffers store it: linear, or buffer: depth-buffer values of the frame's projection"},
        {"--normals", &shown.normals,
         "how the G-buffers store them: view or world space, and behind it -octahedral, -unorm or both"},
        {"--size", &shown.size, excludes("--gbuffer"), "WIDTHxHEIGHT of a scene or mesh, pixels"},
        {"--frames", &shown.frames, between(1, 9999),
         "number of frames. A scene that moves: from --frame on. A G-buffer sequence: the first N (default: "
         "all). Else: accumulated on one view (default: 1)"},
        {"--frame", &shown.frame, between(0, 1e6), "of a scene that moves: the first frame shown, 0 and up"},
        {"--still", &shown.still, "stop the scene at --frame and accumulate frames of that view"},
        {"--write-gbuffer", &options.write_gbuffer, "folder for the G-buffers that were shaded"},
        {"--out", &options.out, "folder for pictures and render.json"},
        {"--antialias", &options.antialias, between(1, 8),
         "N x N samples of each pixel in lit pictures of scenes and meshes; the occlusion stays that of the "
         "pixels"},
        {"--quiet", &options.quiet, "print nothing but errors"},
        {"--up", &mesh.up, "the file's axis that points up: x, y, z, -x, -y or -z"},
        {"--no-ground", &mesh.no_ground, "no plane under the mesh"},
        {"--orbit", &mesh.orbit,
         "AZIMUTH,ELEVATION: direction from the mesh to the eye, degrees; as near as the whole mesh fits "
         "into the image"},
        {"--eye", &mesh.eye, excludes("--orbit"),
         "X,Y,Z: position of the eye, in units of the mesh, from the middle of its base; y is up"},
        {"--look-at", &mesh.look_at,
         "X,Y,Z: the point that the eye looks at, in the same unit (default: the centre of the mesh)"},
        {"--fovy", &mesh.fovy, "vertical angle of the view, degrees, 1 to 170 (default: 40)"},
        {"--method", &options.methods, list,
         "gloam list methods, or all; several, separated by commas, are compared on one sheet (default: the "
         "preset's)"},
        {"--preset", &options.presets, list,
         fmt::format(
             "gloam list presets; several, separated by commas, are compared on one sheet (default: {})",
             effect::default_preset)},
        {"--samples", &candidate.samples, between(1, effect::most_samples),
         "samples for each pixel in each frame (default: the preset's)"},
        {"--radius", &candidate.radius, "world units (default: the view's)"},
        {"--bias", &candidate.bias, "world units (default: the preset's part of the radius)"},
        {"--guard", &candidate.guard,
         "guard band: part of the image that is rendered outside each of its sides, so that pixels at the "
         "edge have neighbours; 0 to 0.5, usually 0.05 to 0.1 (default: none)"},
        {"--no-filter", &candidate.no_filter, "show the estimate as it is"},
        {"--multi-bounce", &options.multi_bounce,
         "lit pictures with the light that bounces among blockers of the surface's colour"},
        {"--bent-normals", &candidate.bent_normals,
         "write the directions in which points are open, and the cones around them, too: those of the frame, "
         "or of a pass of their own"},
        {"--bent-interleave", &candidate.bent_interleave, needs("--bent-normals", between(1, 8)),
         "interleave samples: the N x N pixels of a block take different samples of one pattern (1: no "
         "interleaving); by a pass of their own"},
        {"--light", &options.light, one_of({"white", "sky"}),
         "white or sky: also write the scene in its light, with directional occlusion and one bounce"},
        {"--set", &candidate.set, repeated, "NAME=VALUE: any setting (gloam list settings); may be repeated"},
        {"--truth",
         [&shown](const std::string& file) { shown.truth = file; },
         {.may_lack = "[FILE]"},
         "compare with true occlusion: traced now, or given as a PFM file"},
        {"--truth-every", &shown.truth_every, needs("--truth"),
         "trace the truth of every frame of a sequence, not of the last alone: it takes as long for each"},
        {"--truth-rays", &shown.traced.rays.rays, needs("--truth"), "rays for each pixel, 32 to 16777216"},
        {"--truth-falloff", &shown.truth_falloff, needs("--truth"), "linear, quadratic or step"},
        {"--truth-thickness", &shown.traced.thickness, needs("--truth"),
         "thickness of the surfaces that the depth buffer shows, world units (default: solid behind them)"},
        {"--repeat", &options.repeat, between(1, 1e4), "runs of each frame, of which times are the median"},
        device_option(options.device),
        validation_option(options.validation),
        driver_option()};
}

// Returns the exit status: 0, or 1 if the validation layers reported messages.
int run_render(RenderOptions& options) {
    RenderCase& shown = options.shown;
    // `render --truth columns`: if there is nothing else to render, the value of --truth is the scene.
    if (shown.source.empty() && shown.gbuffer.empty() && shown.truth)
        shown.source = std::exchange(*shown.truth, "");
    const RenderInput input = open_input(options);
    record::OutputFolder out(options.out);
    backend::vulkan::Device device = open_device(options.device, options.validation);
    const std::vector<Rendered> runs = render(options, input, device, &out);
    out.write("sheet.png", sheet_of(runs));
    out.keep();
    if (!options.quiet) {
        if (runs.size() == 1)
            fmt::print("{}", to_text(runs.front()));
        else
            print_comparison(runs);
        fmt::print("pictures: {}\n", (out.path() / "sheet.png").string());
    }
    return validation_status(device);
}

}  // namespace

Command render_command() {
    static RenderOptions options;
    return {.name = "render",
            .about = "ambient occlusion of a scene, a mesh or an engine's G-buffer",
            .options = options_of(options),
            .run = [] { return run_render(options); },
            .examples =
                "  gloam render mesh.obj --frames 8\n"
                "  gloam render mesh.obj --up z --orbit 40,25\n"
                "  gloam render columns --method all --truth\n"
                "  gloam render --gbuffer FOLDER --radius 0.5\n"};
}

}  // namespace gloam::cli
