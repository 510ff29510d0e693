// SPDX-License-Identifier: MIT
#include "effect/internal/view_images.hpp"

#include <fmt/format.h>

#include <span>
#include <stdexcept>
#include <vector>

#include "effect/internal/frame_images.hpp"
#include "effect/internal/texels.hpp"

namespace gloam::effect {
namespace {

using enum gpu::Format;

void require_size(const char* what, std::size_t found, gpu::Extent extent) {
    if (found == pixels_of(extent)) return;
    throw std::invalid_argument(
        fmt::format("{}: {} pixels, expected {} x {}", what, found, extent.width, extent.height));
}

std::vector<float> texels_of(std::span<const std::vector<float>> layers) {
    std::vector<float> texels(4 * layers.front().size(), 0.0F);
    for (std::size_t l = 0; l < layers.size(); ++l) {
        for (std::size_t i = 0; i < layers[l].size(); ++i) texels[4 * i + l] = layers[l][i];
    }
    return texels;
}

void require_layers(std::span<const std::vector<float>> layers, gpu::Extent extent) {
    for (const std::vector<float>& layer : layers) require_size("a depth layer", layer.size(), extent);
    if (layers.size() <= std::size_t{scene::most_further_layers}) return;
    throw std::invalid_argument(fmt::format("{} depth layers behind the first: expected at most {}",
                                            layers.size(), scene::most_further_layers));
}

}  // namespace

ViewImages::ViewImages(const gpu::Device& device, gpu::Extent size)
    : depth(device, size, r32f), normal(device, size, rgba32f) {}

void ViewImages::take(const gpu::Device& device, const scene::GBuffer& view) {
    const gpu::Extent extent = depth.extent();
    require_size("depth", view.depth.size(), extent);
    if (!view.normal.empty()) require_size("normals", view.normal.size(), extent);
    if (!view.previous_position.empty())
        require_size("previous positions", view.previous_position.size(), extent);
    require_layers(view.layers, extent);
    take_surfaces(device, view);
    layers.reset();
    if (!view.layers.empty()) {
        layers.emplace(device, extent, rgba32f);
        layers->upload(texels_of(view.layers));
    }
    previous_position.reset();
    if (view.previous_position.empty()) return;
    previous_position.emplace(device, extent, rgba32f);
    previous_position->upload(texels_of(view.previous_position));
}

void ViewImages::take_linear(const gpu::Device& device, const scene::GBuffer& view) {
    if (!view.stored) return take(device, view);
    scene::GBuffer linear = view;
    linear.stored.reset();
    take(device, linear);
}

void ViewImages::take_surfaces(const gpu::Device& device, const scene::GBuffer& view) {
    stored_depth.reset();
    stored_normal.reset();
    if (!view.stored) {
        depth.upload(view.depth);
        if (!view.normal.empty()) normal.upload(texels_of(view.normal));
        return;
    }
    require_size("stored depth", view.stored->depth.size(), depth.extent());
    require_size("stored normals", view.stored->normal.size(),
                 view.normal.empty() ? gpu::Extent{} : depth.extent());
    stored_depth.emplace(device, depth.extent(), r32f);
    stored_depth->upload(view.stored->depth);
    if (view.stored->normal.empty()) return;
    stored_normal.emplace(device, depth.extent(), rgba32f);
    stored_normal->upload(texels_of(view.stored->normal));
}

}  // namespace gloam::effect
