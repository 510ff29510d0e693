// SPDX-License-Identifier: MIT
#include "cli/occlusion/render.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <ranges>
#include <stdexcept>

#include "base/number.hpp"
#include "cli/environment.hpp"
#include "cli/occlusion/settings.hpp"
#include "cli/progress.hpp"
#include "scene/analytic_scene.hpp"
#include "scene/draw.hpp"
#include "scene/mesh_scene.hpp"
#include "scene/read_gbuffer.hpp"

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* mesh_options =
    "--eye, --look-at, --orbit, --fovy, --up and --no-ground go with a mesh file";

std::string scene_list() {
    std::string names;
    for (const scene::ViewInfo& view : scene::all_views())
        if (view.kind == "scene") names += (names.empty() ? "" : ", ") + view.name;
    return names;
}

// Parses "0.5,1,2.25": exactly `count` numbers.
std::vector<double> parse_numbers(const char* option, const std::string& text, std::size_t count,
                                  const char* expected) {
    std::vector<double> numbers;
    for (const auto part : std::views::split(text, ','))
        numbers.push_back(
            base::number_from<double>(std::string_view(part.begin(), part.end())).value_or(NAN));
    if (numbers.size() == count && std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); }))
        return numbers;
    throw std::invalid_argument(fmt::format("{} {}: expected {}", option, text, expected));
}

std::optional<glm::dvec3> parse_point(const char* option, const std::string& text) {
    if (text.empty()) return std::nullopt;
    const auto numbers = parse_numbers(option, text, 3, "X,Y,Z in units of the mesh, such as 0.5,1,2");
    return glm::dvec3(numbers[0], numbers[1], numbers[2]);
}

scene::MeshView mesh_view(const MeshOptions& mesh, backend::Extent extent) {
    scene::MeshView view{.ground = !mesh.no_ground};
    const auto up = scene::axis_named(mesh.up);
    if (!up) throw std::invalid_argument(fmt::format("--up {}: expected x, y, z, -x, -y or -z", mesh.up));
    view.up = *up;
    if (!mesh.orbit.empty()) {
        const auto angles =
            parse_numbers("--orbit", mesh.orbit, 2, "AZIMUTH,ELEVATION in degrees, such as 30,20");
        view.azimuth_deg = angles[0];
        view.elevation_deg = angles[1];
    }
    view.eye = parse_point("--eye", mesh.eye);
    view.look_at = parse_point("--look-at", mesh.look_at);
    if (mesh.fovy) view.fovy_deg = *mesh.fovy;
    view.aspect = static_cast<double>(extent.width) / static_cast<double>(extent.height);
    return view;
}

scene::Scene load_scene(const RenderCase& shown, backend::Extent extent) {
    const std::string& source = shown.source;
    const scene::MeshView view = mesh_view(shown.mesh, extent);
    if (std::ranges::count(scene::all_views(), source, &scene::ViewInfo::name) > 0) {
        if (shown.mesh != MeshOptions{})
            throw std::invalid_argument(
                fmt::format("\"{}\" has a camera of its own: {}", source, mesh_options));
        return scene::make_scene(source);
    }
    std::error_code none;
    if (fs::path(source).has_extension() && !fs::exists(source, none))
        throw std::invalid_argument(source + ": no such file");
    if (!fs::is_regular_file(source, none))
        throw std::invalid_argument(
            fmt::format("\"{}\" is neither a scene ({}), a view (gloam list views) nor a mesh file", source,
                        scene_list()));
    return scene::mesh_scene(scene::read_mesh(source), fs::path(source).stem().string(), view);
}

// what: the view, with what makes it so wide.
void require_allowed(const std::string& what, backend::Extent wide, const backend::DeviceInfo& device) {
    if (wide.width <= device.max_image_size && wide.height <= device.max_image_size) return;
    throw std::invalid_argument(fmt::format("{}: {} x {} pixels; {} allows at most {} a side", what,
                                            wide.width, wide.height, device.name, device.max_image_size));
}

RenderInput from_scene(const RenderCase& shown) {
    const backend::Extent extent = parse_size(shown.size);
    const auto scene = std::make_shared<const scene::Scene>(load_scene(shown, extent));
    const int frames = shown.frames.value_or(1);
    const bool moves = scene->camera_path || !scene->objects.empty();
    const bool follows = moves && !shown.still && frames > 1;
    RenderInput input{.name = scene->name,
                      .views = std::vector<int>(static_cast<std::size_t>(follows ? frames : 1)),
                      .first_frame = shown.frame,
                      .frames_per_view = follows ? 1 : frames,
                      .scene = scene};
    std::iota(input.views.begin(), input.views.end(), 0);
    // If only the camera moves, its matrices determine all motion.
    const bool motion = follows && !scene->objects.empty();
    input.load = [scene, extent, motion, first = shown.frame,
                  encoding = scene::encoding_named(shown.depth, shown.normals)](
                     const backend::vulkan::Device& device, int view, const effect::Settings& settings) {
        const double guard = double{settings.guard};
        require_allowed(fmt::format("--size {}x{}, guard band included", extent.width, extent.height),
                        scene::with_border(extent, scene::guard_border(extent, guard)), device.info());
        scene::GBuffer drawn = scene::draw(*scene, extent,
                                           {.frame = first + view,
                                            .motion = motion,
                                            .color = true,
                                            .layers = settings.own.layers,
                                            .guard = guard});
        if (encoding != scene::Encoding{}) drawn.stored = scene::stored_inputs(drawn, encoding);
        return drawn;
    };
    return input;
}

RenderInput from_gbuffer(const RenderCase& shown) {
    if (shown.still) throw std::invalid_argument("--still goes with a scene, not with --gbuffer");
    if (shown.frame != 0) throw std::invalid_argument("--frame goes with a scene, not with --gbuffer");
    if (shown.mesh != MeshOptions{}) throw std::invalid_argument(mesh_options);
    if (!shown.source.empty())
        throw std::invalid_argument(fmt::format("\"{}\" and --gbuffer {}: give one of the two", shown.source,
                                                shown.gbuffer.string()));
    RenderInput input{.name = shown.gbuffer.string(), .views = scene::frames_of(shown.gbuffer)};
    if (input.views.size() == 1) {
        input.frames_per_view = shown.frames.value_or(1);
    } else if (shown.frames) {
        const auto count = static_cast<std::size_t>(*shown.frames);
        if (count > input.views.size())
            throw std::invalid_argument(
                fmt::format("--frames {}: {} holds {}", count, shown.gbuffer.string(), input.views.size()));
        input.views.resize(count);
    }
    const bool alone = input.views.size() == 1;  // a frame of a sequence may show nothing but sky
    input.load = [folder = shown.gbuffer, encoding = scene::encoding_named(shown.depth, shown.normals), alone,
                  off_centre = glm::ivec2(0)](const backend::vulkan::Device& device, int view,
                                              const effect::Settings&) mutable {
        scene::GBuffer read = scene::read_gbuffer(folder, view, encoding, off_centre);
        off_centre = read.off_centre;
        const backend::Extent wide = with_border(read.extent, centring_border(read));
        require_allowed(folder.string() + ", with background up to a centred projection", wide,
                        device.info());
        read = centred(std::move(read));
        if (alone && std::ranges::none_of(read.depth, scene::is_surface))
            throw std::invalid_argument(fmt::format(
                "{}: no geometry, every pixel of the depth is background; expected {}", folder.string(),
                encoding.depth_buffer ? "depth-buffer values in front of the far plane of the projection"
                                      : "eye-linear depths > 0, the distance along -z"));
        return read;
    };
    return input;
}

// The truth of --truth: by rays.
void add_traced(RenderInput& input, const RenderCase& shown, scene::Falloff falloff) {
    scene::TruthSettings settings = shown.traced;
    settings.rays.falloff = falloff;
    settings.cache = truth_cache_directory();
    scene::validate(settings.rays);
    if (!(settings.thickness > 0.0))
        throw std::invalid_argument(fmt::format("--truth-thickness {}: expected > 0", settings.thickness));
    input.truth_name = input.scene ? "traced geometry" : "traced depth buffer";
    input.every_truth = shown.truth_every;
    input.truth = [settings, scene = input.scene, name = input.name](ShadedView& one, int frame,
                                                                     bool both) mutable {
        const auto of = [&](const char* what) {
            settings.rays.radius = double{one.settings.radius};
            settings.progress = progress_bar(fmt::format("{}: truth of the {}", name, what));
            return settings;
        };
        if (scene) one.geometry = scene::trace_geometry(*scene, frame, one.view, of("geometry"));
        if (both || !scene) one.depth = scene::trace_depth(one.view, of("depth buffer"));
        one.truth = effect::truth_from(one.view, one.best().occlusion);
    };
}

void add_truth(RenderInput& input, const RenderCase& shown) {
    const auto falloff = scene::falloff_named(shown.truth_falloff);
    if (!falloff)
        throw std::invalid_argument(
            fmt::format("--truth-falloff \"{}\": expected linear, quadratic or step", shown.truth_falloff));
    const bool traced = shown.truth && shown.truth->empty();
    if (shown.truth_every && !traced)
        throw std::invalid_argument("--truth-every goes with --truth that is traced, without a file");
    if (traced) return add_traced(input, shown, *falloff);
    if (shown.truth) {
        input.truth_name = *shown.truth;
        input.every_truth = false;
        input.truth = [file = *shown.truth, image = base::read_pfm(*shown.truth)](ShadedView& one, int,
                                                                                  bool) {
            const backend::Extent size = one.view.extent;
            if (backend::Extent{image.width, image.height} != size || image.channels != 1)
                throw std::invalid_argument(
                    fmt::format("{}: {} x {} with {} channels, expected {} x {} with 1", file, image.width,
                                image.height, image.channels, size.width, size.height));
            one.truth = effect::truth_from(one.view, image.texels);
        };
    } else if (shown.source == "corner") {
        input.truth_name = "closed form";
        input.truth = [](ShadedView& one, int, bool) {
            one.truth = effect::truth_of(one.view, double{one.settings.radius}, scene::corner_occlusion_at);
        };
    }
}

// One for each selected method or preset; all names and settings are checked.
std::vector<RenderCandidate> candidates_of(const RenderOptions& options) {
    std::vector<std::string> methods = options.methods;
    if (methods.empty()) methods.emplace_back();
    if (methods.size() == 1 && methods.front() == "all") {
        methods.clear();
        for (const effect::MethodInfo& method : effect::methods()) methods.push_back(method.name);
    }
    std::vector<std::string> presets = options.presets;
    if (presets.empty()) presets.emplace_back(effect::default_preset);
    if (methods.size() > 1 && presets.size() > 1)
        throw std::invalid_argument("--method and --preset: expected several of one of the two");
    const bool several = methods.size() * presets.size() > 1;
    if (several && !options.write_gbuffer.empty())
        throw std::invalid_argument("--write-gbuffer goes with one method and one preset");
    std::vector<RenderCandidate> candidates;
    for (const std::string& preset : presets) {
        for (const std::string& method : methods) {
            RenderCandidate made = options.candidate;
            made.preset = preset;
            made.method = method;
            made.name = settings_for(made, 1.0).method;
            if (presets.size() > 1) made.name = fs::path(preset).stem().string();
            if (several) made.prefix = made.name + "_";
            if (std::ranges::count(candidates, made.name, &RenderCandidate::name) > 0)
                throw std::invalid_argument(
                    fmt::format("{}: expected each once", presets.size() > 1 ? preset : method));
            candidates.push_back(std::move(made));
        }
    }
    return candidates;
}

}  // namespace

RenderOptions demo_options(bool quiet) {
    return {.shown = {.source = "workshop", .truth = "", .traced = {.rays = {.rays = 128}}},
            .presets = {"quality"},
            .candidate = {.set = {"history=off"}},  // all as in gloam bench views --single
            .repeat = 3,                            // a driver may compile in the first frame's time
            .quiet = quiet};
}

RenderInput open_input(const RenderOptions& options) {
    std::vector<RenderCandidate> candidates = candidates_of(options);
    const RenderCase& shown = options.shown;
    if (shown.gbuffer.empty() && shown.source.empty())
        throw std::invalid_argument(
            fmt::format("nothing to render: give a scene ({}), a mesh file or --gbuffer DIR", scene_list()));
    RenderInput input = shown.gbuffer.empty() ? from_scene(shown) : from_gbuffer(shown);
    add_truth(input, shown);
    input.candidates = std::move(candidates);
    return input;
}

}  // namespace gloam::cli
