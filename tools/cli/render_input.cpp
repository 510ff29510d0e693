// SPDX-License-Identifier: MIT
#include "cli/render_input.hpp"

#include <fmt/format.h>

#include <memory>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "cli/mesh_reader.hpp"
#include "cli/names.hpp"
#include "cli/render_settings.hpp"
#include "cli/view_size.hpp"
#include "scene/corner.hpp"
#include "scene/guard_band.hpp"
#include "scene/mesh_reader.hpp"
#include "scene/rasterize.hpp"
#include "scene/read_gbuffer.hpp"

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;

bool is_scene(const std::string& name) {
    for (const Named& scene : scene_names()) {
        if (scene.name == name) return true;
    }
    return false;
}

std::string scene_list() {
    std::string names;
    for (const Named& scene : scene_names()) names += (names.empty() ? "" : ", ") + scene.name;
    return names;
}

scene::Scene load_scene(const std::string& source) {
    if (is_scene(source)) return scene::make_scene(source);
    std::error_code none;
    if (!fs::is_regular_file(source, none)) {
        throw std::invalid_argument(
            fmt::format("\"{}\" is neither a scene ({}) nor a mesh file", source, scene_list()));
    }
    return scene::mesh_on_ground(scene::read_mesh(source, mesh_reader_command()),
                                 fs::path(source).stem().string());
}

// wide: with its guard band.
void require_allowed(gpu::Extent extent, gpu::Extent wide, const gpu::DeviceInfo& device) {
    if (wide.width <= device.max_image_size && wide.height <= device.max_image_size) return;
    throw std::invalid_argument(
        fmt::format("--size {}x{}: {} allows at most {} pixels a side, guard band included", extent.width,
                    extent.height, device.name, device.max_image_size));
}

RenderInput from_scene(const RenderOptions& options) {
    const gpu::Extent extent = parse_size(options.size);
    const auto scene = std::make_shared<const scene::Scene>(load_scene(options.source));
    const int frames = options.frames.value_or(1);
    const bool moves = scene->camera_path || !scene->objects.empty();
    const bool follows = moves && !options.still && frames > 1;
    RenderInput input{.name = scene->name,
                      .views = std::vector<int>(static_cast<std::size_t>(follows ? frames : 1)),
                      .first_frame = options.frame,
                      .frames_per_view = follows ? 1 : frames};
    std::iota(input.views.begin(), input.views.end(), 0);
    input.scene = scene;
    const effect::Settings settings = settings_for(options, scene->ao_radius);
    const double guard = double{settings.guard};
    const gpu::Extent wide = scene::with_border(extent, scene::guard_border(extent, guard));
    // Where only the camera moves, its matrices tell everything.
    const bool motion = follows && !scene->objects.empty();
    input.load = [scene, extent, wide, guard, motion, layers = static_cast<int>(settings.layers),
                  color = options.light.has_value(), first = options.frame](
                     const gpu::Device& device, const scene::PassLibrary& passes, int view) {
        require_allowed(extent, wide, device.info());
        return scene::rasterize(
            device, passes, *scene, extent,
            {.frame = first + view, .motion = motion, .color = color, .layers = layers, .guard = guard});
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
    input.load = [folder = options.gbuffer](const gpu::Device&, const scene::PassLibrary&, int view) {
        return scene::read_gbuffer(folder, view);
    };
    return input;
}

}  // namespace

RenderInput open_input(const RenderOptions& options) {
    if (!options.gbuffer.empty()) return from_gbuffer(options);
    if (options.source.empty()) {
        throw std::invalid_argument(
            fmt::format("nothing to render: give a scene ({}), a mesh file or --gbuffer DIR", scene_list()));
    }
    return from_scene(options);
}

}  // namespace gloam::cli
