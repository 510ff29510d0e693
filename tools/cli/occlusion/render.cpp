// SPDX-License-Identifier: MIT
#include "cli/occlusion/render.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "cli/framework/open_device.hpp"
#include "cli/occlusion/names.hpp"
#include "cli/occlusion/settings.hpp"

namespace gloam::cli {
namespace {

// A run of one method.
struct Run {
    RenderOptions options;
    RenderInput input;
    std::string prefix;  // of its files
};

// A run for each selected method; checks all names.
std::vector<Run> runs_of(const RenderOptions& options) {
    std::vector<std::string> methods = options.methods;
    if (methods.empty()) methods.push_back(options.method);
    if (methods.size() == 1 && methods.front() == "all") {
        methods.clear();
        for (const Named& method : method_names()) methods.push_back(method.name);
    }
    std::vector<std::string> presets = options.presets;
    if (presets.empty()) presets.push_back(options.preset);
    if (methods.size() > 1 && presets.size() > 1)
        throw std::invalid_argument("--method and --preset: expected several of one of the two");
    const bool several = methods.size() * presets.size() > 1;
    if (several && !options.write_gbuffer.empty())
        throw std::invalid_argument("--write-gbuffer goes with one method and one preset");
    std::vector<Run> runs;
    std::set<std::string> prefixes;
    for (const std::string& preset : presets) {
        for (const std::string& method : methods) {
            Run run{.options = options, .input = {}, .prefix = {}};
            run.options.method = method;
            run.options.preset = preset;
            if (several) run.prefix = name_of(run.options) + "_";
            if (!prefixes.insert(run.prefix).second)
                throw std::invalid_argument(
                    fmt::format("{}: expected each once", presets.size() > 1 ? preset : method));
            (void)settings_for(run.options, 1.0);
            run.input = open_input(run.options, runs.empty() ? nullptr : &runs.front().input);
            (void)TruthSource(run.options, run.input);
            runs.push_back(std::move(run));
        }
    }
    return runs;
}

void print_comparison(const std::vector<Rendered>& rendered) {
    const RenderReport& first = rendered.front().report;
    std::size_t width = 0;
    for (const Rendered& run : rendered) width = std::max(width, run.report.name.size());
    fmt::print("{} on {}\n{:<{}} {:>9} {:>8}\n", first.source, first.device.name, "run", width, "ms/frame",
               "error");
    for (const Rendered& run : rendered) {
        const auto error = frame_error(run.report);
        fmt::print("{:<{}} {:>9.3f} {:>8}\n", run.report.name, width, frame_ms(run.report),
                   error ? fmt::format("{:.4f}", *error) : "-");
    }
    if (!first.truth.empty()) fmt::print("error: root mean square, against the {}\n", first.truth);
}

void add_view_options(CLI::App& command, RenderOptions& options) {
    command.add_option("source", options.source,
                       "scene (gloam list scenes) or mesh file, stood on a ground plane");
    CLI::Option* gbuffer = command.add_option("--gbuffer", options.gbuffer,
                                              "folder of G-buffers of an engine, instead of a scene");
    command
        .add_option(
            "--depth", options.depth,
            "how the G-buffers store it: linear, or buffer: depth-buffer values of the frame's projection")
        ->capture_default_str();
    command
        .add_option(
            "--normals", options.normals,
            "how the G-buffers store them: view or world space, and behind it -octahedral, -unorm or both")
        ->capture_default_str();
    command.add_option("--size", options.size, "WIDTHxHEIGHT of a scene or mesh, pixels")
        ->excludes(gbuffer)
        ->capture_default_str();
    command
        .add_option("--frames", options.frames,
                    "number of frames. A scene that moves: from --frame on. A G-buffer sequence: the first N "
                    "(default: all). Else: accumulated on one view (default: 1)")
        ->check(CLI::Range(1, 9999));
    command.add_option("--frame", options.frame, "of a scene that moves: the first frame shown, 0 and up")
        ->check(CLI::Range(0, 1'000'000));
    command.add_flag("--still", options.still,
                     "stop the scene at --frame and accumulate frames of that view");
    command.add_option("--write-gbuffer", options.write_gbuffer, "folder for the G-buffers that were shaded");
    command.add_option("--out", options.out, "folder for pictures and render.json")->capture_default_str();
    command
        .add_option(
            "--antialias", options.antialias,
            "N x N samples of each pixel in lit pictures of scenes and meshes; the occlusion stays that "
            "of the pixels")
        ->check(CLI::Range(1, 8))
        ->capture_default_str();
    command.add_flag("--quiet", options.quiet, "print nothing but errors");
}

void add_mesh_options(CLI::App& command, MeshOptions& mesh) {
    command.add_option("--up", mesh.up, "the file's axis that points up: x, y, z, -x, -y or -z")
        ->capture_default_str();
    command.add_flag("--no-ground", mesh.no_ground, "no plane under the mesh");
    CLI::Option* orbit = command.add_option("--orbit", mesh.orbit,
                                            "AZIMUTH,ELEVATION: direction from the mesh to the eye, degrees; "
                                            "as near as the whole mesh fits into the image");
    command
        .add_option("--eye", mesh.eye,
                    "X,Y,Z: position of the eye, in units of the mesh, from the middle of its base; y is up")
        ->excludes(orbit);
    command.add_option(
        "--look-at", mesh.look_at,
        "X,Y,Z: the point that the eye looks at, in the same unit (default: the centre of the mesh)");
    command.add_option("--fovy", mesh.fovy, "vertical angle of the view, degrees, 1 to 170 (default: 40)");
}

void add_effect_options(CLI::App& command, RenderOptions& options) {
    command
        .add_option("--method", options.methods,
                    "gloam list methods, or all; several, separated by commas, are compared on one sheet "
                    "(default: the preset's)")
        ->delimiter(',')
        ->allow_extra_args(false);
    command
        .add_option("--preset", options.presets,
                    fmt::format("gloam list presets; several, separated by commas, are compared on one sheet "
                                "(default: {})",
                                options.preset))
        ->delimiter(',')
        ->allow_extra_args(false);
    command
        .add_option("--samples", options.samples,
                    "samples for each pixel in each frame (default: the preset's)")
        ->check(CLI::Range(1U, effect::most_samples));
    command.add_option("--radius", options.radius, "world units (default: the view's)");
    command.add_option("--bias", options.bias, "world units (default: the preset's part of the radius)");
    command.add_option(
        "--guard", options.guard,
        "guard band: part of the image that is rendered outside each of its sides, so that pixels at the "
        "edge have neighbours; 0 to 0.5, usually 0.05 to 0.1 (default: none)");
    command.add_flag("--no-filter", options.no_filter, "show the estimate as it is");
}

void add_light_options(CLI::App& command, RenderOptions& options) {
    command.add_flag("--multi-bounce", options.multi_bounce,
                     "lit pictures with the light that bounces among blockers of the surface's colour");
    CLI::Option* bent =
        command.add_flag("--bent-normals", options.bent_normals,
                         "write the directions in which points are open, and the cones around them, too: "
                         "those of the frame, or of a pass of their own");
    command
        .add_option("--bent-interleave", options.bent_interleave,
                    "interleave samples: the N x N pixels of a block take different samples of one pattern "
                    "(1: no interleaving); by a pass of their own")
        ->needs(bent)
        ->check(CLI::Range(1, 8))
        ->capture_default_str();
    command
        .add_option("--light", options.light,
                    "white or sky: also write the scene in its light, with directional occlusion and one "
                    "bounce")
        ->check(CLI::IsMember({"white", "sky"}));
}

void add_truth_options(CLI::App& command, RenderOptions& options) {
    CLI::Option* truth = command
                             .add_option_function<std::vector<std::string>>(
                                 "--truth",
                                 [&options](const std::vector<std::string>& files) {
                                     options.truth = files.empty() ? "" : files.front();
                                     options.trace_truth = options.truth.empty();
                                 },
                                 "compare with true occlusion: traced now, or given as a PFM file")
                             ->expected(0, 1)
                             ->type_name("[FILE]");
    command
        .add_flag(
            "--truth-every", options.truth_every,
            "trace the truth of every frame of a sequence, not of the last alone: it takes as long for each")
        ->needs(truth);
    command.add_option("--truth-rays", options.truth_rays, "rays for each pixel, 32 to 16777216")
        ->needs(truth)
        ->capture_default_str();
    command.add_option("--truth-falloff", options.truth_falloff, "linear, quadratic or step")
        ->needs(truth)
        ->capture_default_str();
    command
        .add_option(
            "--truth-thickness", options.truth_thickness,
            "thickness of the surfaces that the depth buffer shows, world units (default: solid behind them)")
        ->needs(truth);
}

// `render --truth columns`: if there is nothing else to render, the value of --truth is the scene.
void take_scene_from_truth(RenderOptions& options) {
    if (!options.source.empty() || !options.gbuffer.empty() || options.truth.empty()) return;
    options.source = std::exchange(options.truth, "");
    options.trace_truth = true;
}

// Returns the exit status: 0, or 1 if the validation layers reported messages.
int run_render(const RenderOptions& options) {
    std::vector<Run> runs = runs_of(options);
    record::OutputFolder out(options.out);
    RenderBench bench(options);
    std::vector<Rendered> rendered;
    for (const Run& run : runs) {
        rendered.push_back(render(run.options, run.input, bench, {&out, run.prefix}));
        if (runs.size() == 1 && !options.quiet) fmt::print("{}", to_text(rendered.front().report));
    }
    out.write("sheet.png", sheet_of(rendered));
    out.keep();
    if (!options.quiet) {
        if (runs.size() > 1) print_comparison(rendered);
        fmt::print("pictures: {}\n", (out.path() / "sheet.png").string());
    }
    return validation_status(bench.device);
}

}  // namespace

void add_render(CLI::App& app, int& status) {
    auto options = std::make_shared<RenderOptions>();
    CLI::App* command =
        app.add_subcommand("render", "ambient occlusion of a scene, a mesh or an engine's G-buffer");
    add_view_options(*command, *options);
    add_mesh_options(*command, options->mesh);
    add_effect_options(*command, *options);
    add_light_options(*command, *options);
    command
        ->add_option("--set", options->set, "NAME=VALUE: any setting (gloam list settings); may be repeated")
        ->allow_extra_args(false);
    add_truth_options(*command, *options);
    command->add_option("--repeat", options->repeat, "runs of each frame, of which times are the median")
        ->check(CLI::Range(1, 10'000))
        ->capture_default_str();
    add_device_options(*command, options->device, options->validation);
    command->callback([options, &status] {
        take_scene_from_truth(*options);
        status = run_render(*options);
    });
}

}  // namespace gloam::cli
