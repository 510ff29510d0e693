// SPDX-License-Identifier: MIT
#include "cli/occlusion/render.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "cli/commands.hpp"
#include "cli/environment.hpp"
#include "cli/occlusion/names.hpp"
#include "cli/occlusion/settings.hpp"
#include "cli/progress.hpp"
#include "pictures/sheet.hpp"
#include "scene/analytic_scene.hpp"
#include "scene/draw.hpp"
#include "scene/mesh_scene.hpp"
#include "scene/read_gbuffer.hpp"

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* mesh_options =
    "--eye, --look-at, --orbit, --fovy, --up and --no-ground go with a mesh file";

bool is_among(const std::vector<Named>& names, const std::string& name) {
    return std::ranges::any_of(names, [&](const Named& one) { return one.name == name; });
}

std::string scene_list() {
    std::string names;
    for (const Named& scene : scene_names()) names += (names.empty() ? "" : ", ") + scene.name;
    return names;
}

// Parses "0.5,1,2.25": exactly `count` numbers.
std::vector<double> parse_numbers(const char* option, const std::string& text, std::size_t count,
                                  const char* expected) {
    std::vector<double> numbers;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (numbers.size() < count) {
        double number = 0.0;
        const auto [rest, error] = std::from_chars(at, end, number);
        if (error != std::errc{} || !std::isfinite(number)) break;
        numbers.push_back(number);
        at = rest;
        if (at == end || *at != ',') break;
        ++at;
    }
    if (numbers.size() == count && at == end) return numbers;
    throw std::invalid_argument(fmt::format("{} {}: expected {}", option, text, expected));
}

std::optional<glm::dvec3> parse_point(const char* option, const std::string& text) {
    if (text.empty()) return std::nullopt;
    const auto numbers = parse_numbers(option, text, 3, "X,Y,Z in units of the mesh, such as 0.5,1,2");
    return glm::dvec3(numbers[0], numbers[1], numbers[2]);
}

scene::MeshView mesh_view(const MeshOptions& mesh, gpu::Extent extent) {
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

scene::Scene load_scene(const RenderOptions& options, gpu::Extent extent) {
    const std::string& source = options.source;
    const scene::MeshView view = mesh_view(options.mesh, extent);
    if (is_among(scene_names(), source) || is_among(view_names(), source)) {
        if (options.mesh.given())
            throw std::invalid_argument(
                fmt::format("\"{}\" has a camera of its own: {}", source, mesh_options));
        return scene::make_scene(source);
    }
    std::error_code none;
    if (fs::path(source).has_extension() && !fs::exists(source, none))
        throw std::invalid_argument(source + ": no such file");
    if (!fs::is_regular_file(source, none)) {
        throw std::invalid_argument(
            fmt::format("\"{}\" is neither a scene ({}), a view (gloam list views) nor a mesh file", source,
                        scene_list()));
    }
    return scene::mesh_scene(scene::read_mesh(source), fs::path(source).stem().string(), view);
}

// what: the view, with what makes it so wide.
void require_allowed(const std::string& what, gpu::Extent wide, const gpu::DeviceInfo& device) {
    if (wide.width <= device.max_image_size && wide.height <= device.max_image_size) return;
    throw std::invalid_argument(fmt::format("{}: {} x {} pixels; {} allows at most {} a side", what,
                                            wide.width, wide.height, device.name, device.max_image_size));
}

RenderInput from_scene(const RenderOptions& options, const RenderInput* like) {
    const gpu::Extent extent = parse_size(options.size);
    const auto scene = like != nullptr && like->scene
                           ? like->scene
                           : std::make_shared<const scene::Scene>(load_scene(options, extent));
    const int frames = options.frames.value_or(1);
    const bool moves = scene->camera_path || !scene->objects.empty();
    const bool follows = moves && !options.still && frames > 1;
    RenderInput input{.name = scene->name,
                      .views = std::vector<int>(static_cast<std::size_t>(follows ? frames : 1)),
                      .first_frame = options.frame,
                      .frames_per_view = follows ? 1 : frames};
    std::iota(input.views.begin(), input.views.end(), 0);
    input.scene = scene;
    input.picture_samples = options.antialias;
    const effect::Settings settings = settings_for(options, scene->ao_radius);
    const double guard = double{settings.guard};
    const gpu::Extent wide = scene::with_border(extent, scene::guard_border(extent, guard));
    // If only the camera moves, its matrices determine all motion.
    const bool motion = follows && !scene->objects.empty();
    input.load = [scene, extent, wide, guard, motion, layers = settings.own.layers, first = options.frame,
                  encoding = scene::encoding_named(options.depth, options.normals)](const gpu::Device& device,
                                                                                    int view) {
        require_allowed(fmt::format("--size {}x{}, guard band included", extent.width, extent.height), wide,
                        device.info());
        scene::GBuffer shown = scene::draw(
            *scene, extent,
            {.frame = first + view, .motion = motion, .color = true, .layers = layers, .guard = guard});
        if (encoding != scene::Encoding{}) shown.stored = scene::stored_inputs(shown, encoding);
        return shown;
    };
    if (options.source == "corner") {
        input.truth = scene::corner_occlusion_at;
        input.truth_name = "closed form";
    }
    return input;
}

RenderInput from_gbuffer(const RenderOptions& options) {
    if (options.still) throw std::invalid_argument("--still goes with a scene, not with --gbuffer");
    if (options.frame != 0) throw std::invalid_argument("--frame goes with a scene, not with --gbuffer");
    if (options.mesh.given()) throw std::invalid_argument(mesh_options);
    if (!options.source.empty()) {
        throw std::invalid_argument(fmt::format("\"{}\" and --gbuffer {}: give one of the two",
                                                options.source, options.gbuffer.string()));
    }
    RenderInput input{.name = options.gbuffer.string(), .views = scene::frames_of(options.gbuffer)};
    if (input.views.size() == 1) {
        input.frames_per_view = options.frames.value_or(1);
    } else if (options.frames) {
        const auto count = static_cast<std::size_t>(*options.frames);
        if (count > input.views.size()) {
            throw std::invalid_argument(
                fmt::format("--frames {}: {} holds {}", count, options.gbuffer.string(), input.views.size()));
        }
        input.views.resize(count);
    }
    const bool alone = input.views.size() == 1;  // a frame of a sequence may show nothing but sky
    input.load = [folder = options.gbuffer, encoding = scene::encoding_named(options.depth, options.normals),
                  alone, off_centre = glm::ivec2(0)](const gpu::Device& device, int view) mutable {
        scene::GBuffer shown = scene::read_gbuffer(folder, view, encoding, off_centre);
        off_centre = shown.off_centre;
        const gpu::Extent wide = with_border(shown.extent, centring_border(shown));
        require_allowed(folder.string() + ", with background up to a centred projection", wide,
                        device.info());
        shown = centred(std::move(shown));
        if (alone && std::ranges::none_of(shown.depth, scene::is_surface)) {
            throw std::invalid_argument(fmt::format(
                "{}: no geometry, every pixel of the depth is background; expected {}", folder.string(),
                encoding.depth_buffer ? "depth-buffer values in front of the far plane of the projection"
                                      : "eye-linear depths > 0, the distance along -z"));
        }
        return shown;
    };
    return input;
}

}  // namespace

RenderInput open_input(const RenderOptions& options, const RenderInput* like) {
    if (!options.gbuffer.empty()) return from_gbuffer(options);
    if (options.source.empty()) {
        throw std::invalid_argument(
            fmt::format("nothing to render: give a scene ({}), a mesh file or --gbuffer DIR", scene_list()));
    }
    return from_scene(options, like);
}

TruthSource::TruthSource(const RenderOptions& options, const RenderInput& input)
    : options_(options), input_(input) {
    const auto falloff = scene::falloff_named(options.truth_falloff);
    if (!falloff) {
        throw std::invalid_argument(
            fmt::format("--truth-falloff \"{}\": expected linear, quadratic or step", options.truth_falloff));
    }
    falloff_ = *falloff;
    if (options.truth_every && !options.trace_truth)
        throw std::invalid_argument("--truth-every goes with --truth that is traced, without a file");
    if (options.trace_truth) {
        scene::validate(scene::RaySettings{.radius = 1.0, .falloff = falloff_, .rays = options.truth_rays});
        if (!(options.truth_thickness > 0.0)) {
            throw std::invalid_argument(
                fmt::format("--truth-thickness {}: expected > 0", options.truth_thickness));
        }
    } else if (!options.truth.empty()) {
        reference_ = base::read_pfm(options.truth);
    }
}

std::string TruthSource::name() const {
    if (options_.trace_truth) return input_.scene ? "traced geometry" : "traced depth buffer";
    return reference_ ? options_.truth : input_.truth_name;
}

bool TruthSource::every_view() const {
    return options_.trace_truth ? options_.truth_every : !reference_;
}

TracedView TruthSource::traced(const scene::GBuffer& view, int frame, double radius) const {
    const auto settings = [&](const char* what) {
        return scene::TruthSettings{
            .rays = {.radius = radius, .falloff = falloff_, .rays = options_.truth_rays},
            .thickness = options_.truth_thickness,
            .progress = progress_bar(fmt::format("{}: truth of the {}", input_.name, what)),
            .cache = truth_cache_directory()};
    };
    TracedView result;
    if (input_.scene) {
        result.geometry = scene::trace_geometry(*input_.scene, frame, view, settings("geometry"));
    }
    result.depth = scene::trace_depth(view, settings("depth buffer"));
    return result;
}

ViewTruth TruthSource::of(const scene::GBuffer& view, int frame, double radius) const {
    if (options_.trace_truth) {
        ViewTruth result{.traced = traced(view, frame, radius)};
        const scene::TracedTruth& best =
            result.traced->geometry ? *result.traced->geometry : result.traced->depth;
        result.truth = effect::truth_from(view, best.occlusion);
        return result;
    }
    if (!reference_) {
        return {.truth = input_.truth ? effect::truth_of(view, radius, input_.truth) : effect::Truth{}};
    }
    if (gpu::Extent{reference_->width, reference_->height} == view.extent && reference_->channels == 1)
        return {.truth = effect::truth_from(view, reference_->texels)};
    throw std::invalid_argument(fmt::format("{}: {} x {} with {} channels, expected {} x {} with 1",
                                            options_.truth, reference_->width, reference_->height,
                                            reference_->channels, view.extent.width, view.extent.height));
}

void write_truth(record::OutputFolder& folder, const std::string& prefix, gpu::Extent size,
                 const TracedView& traced) {
    const auto write = [&](const std::string& name, const std::vector<float>& image) {
        folder.write(prefix + name + ".pfm", base::to_pfm(image, size.width, size.height, 1));
        folder.write(prefix + name + ".png", pictures::to_visibility_png(image, size.width, size.height));
    };
    const scene::TracedTruth& best = traced.geometry ? *traced.geometry : traced.depth;
    write("truth", best.occlusion);
    write("truth_depth", traced.depth.occlusion);
    folder.write(prefix + "truth_error.pfm", base::to_pfm(best.standard_error, size.width, size.height, 1));
}

}  // namespace gloam::cli
