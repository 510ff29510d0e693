// SPDX-License-Identifier: MIT
#include "effect/internal/view_inputs.hpp"

#include <fmt/format.h>

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "effect/internal/frame_images.hpp"
#include "effect/internal/passes.hpp"
#include "effect/internal/texels.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::effect {
namespace {

void require_size(const char* what, std::size_t found, gpu::Extent extent) {
    if (found == pixels_of(extent)) return;
    throw std::invalid_argument(
        fmt::format("{}: {} pixels, expected {} x {}", what, found, extent.width, extent.height));
}

// Texels of which each channel is a layer.
std::vector<float> texels_of(std::span<const std::vector<float>> layers) {
    std::vector<float> texels(4 * layers.front().size(), 0.0F);
    for (std::size_t l = 0; l < layers.size(); ++l) {
        for (std::size_t i = 0; i < layers[l].size(); ++i) texels[4 * i + l] = layers[l][i];
    }
    return texels;
}

}  // namespace

void require_guard(const scene::GBuffer& view, const Settings& settings) {
    const gpu::Extent none;
    const double guard = double{settings.guard};
    if (view.border != none || scene::guard_border(view.extent, guard) == none) return;
    throw std::invalid_argument(fmt::format("guard {:g}: the view has no guard band", guard));
}

void require_layers(const scene::GBuffer& view, const Settings& settings) {
    if (view.layers.size() + 1 >= settings.layers) return;
    throw std::invalid_argument(fmt::format("layers {}: the view has {}, the first among them",
                                            settings.layers, view.layers.size() + 1));
}

void require_sizes(const scene::GBuffer& view, gpu::Extent extent) {
    require_size("depth", view.depth.size(), extent);
    if (!view.normal.empty()) require_size("normals", view.normal.size(), extent);
    if (!view.previous_position.empty())
        require_size("previous positions", view.previous_position.size(), extent);
    for (const std::vector<float>& layer : view.layers) require_size("a depth layer", layer.size(), extent);
    if (view.layers.size() > std::size_t{scene::most_further_layers})
        throw std::invalid_argument(fmt::format("{} depth layers behind the first: expected at most {}",
                                                view.layers.size(), scene::most_further_layers));
    if (!view.stored) return;
    require_size("stored depth", view.stored->depth.size(), extent);
    require_size("stored normals", view.stored->normal.size(), view.normal.empty() ? gpu::Extent{} : extent);
}

void upload(const scene::GBuffer& view, gpu::Extent extent, bool stores, Resources& resources,
            const std::string& prefix) {
    using enum gpu::Format;
    const bool stored = stores && view.stored;
    const auto image = [&](const char* name, gpu::Format format) -> gpu::Image& {
        return resources.image(prefix + name, extent, format);
    };
    const std::vector<glm::vec3>& normals = stored ? view.stored->normal : view.normal;
    image("depth", r32f).upload(stored ? view.stored->depth : view.depth);
    if (!normals.empty()) image("normal", rgba32f).upload(texels_of(normals));
    if (!view.previous_position.empty())
        image("previous_position", rgba32f).upload(texels_of(view.previous_position));
    if (!view.layers.empty()) image("layers", rgba32f).upload(texels_of(view.layers));
}

void take_linear(const scene::GBuffer& view, Resources& resources, Executor& executor,
                 const PassWatcher& watcher, const std::string& prefix) {
    require_sizes(view, view.extent);
    upload(view, view.extent, false, resources, prefix);
    if (!view.normal.empty()) return;
    (void)resources.image(prefix + "normal", view.extent, gpu::Format::rgba32f);
    const PlannedPass pass = single_pass(
        "normals_from_depth", {.file = "normals_from_depth.comp"}, {prefix + "depth", prefix + "normal"},
        normal_parameters({view.camera, view.extent, view.border}), groups_for(view.extent));
    executor.run(std::span(&pass, 1), resources, watcher);
}

}  // namespace gloam::effect
