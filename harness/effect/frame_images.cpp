// SPDX-License-Identifier: MIT
#include "effect/internal/frame_images.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "effect/internal/passes.hpp"
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

gpu::Format format_of(HistoryPrecision precision) {
    switch (precision) {
        case HistoryPrecision::float16:
            return rgba16f;
        case HistoryPrecision::packed:
            return rgba16ui;
        default:
            return rgba32f;
    }
}

std::size_t pixels_of(gpu::Extent extent) {
    return std::size_t{extent.width} * extent.height;
}

std::vector<float> channel(std::span<const float> texels, std::size_t which) {
    std::vector<float> values(texels.size() / 4);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = texels[4 * i + which];
    return values;
}

HistoryTexels history_in(const gpu::Image& image) {
    const std::vector<float> texels = image.download();
    HistoryTexels history{.occlusion = channel(texels, 0), .samples = channel(texels, 1)};
    if (image.format() != rgba16ui) return history;
    // The integers of a packed history, as in GloamPackedHistory.
    for (float& value : history.occlusion) value *= packed_occlusion_unit;
    for (float& value : history.samples) value /= 16.0F;
    return history;
}

FrameImages::FrameImages(const gpu::Device& device, gpu::Extent size, HistoryPrecision precision)
    : depth(device, size, r32f),
      normal(device, size, rgba32f),
      before(device, size, format_of(precision)),
      reprojected(device, size, format_of(precision)),
      after(device, size, format_of(precision)),
      half_filtered(device, size, r32f),
      filtered(device, size, r32f),
      tiles(device, size) {}

void FrameImages::take(const gpu::Device& device, const scene::GBuffer& view) {
    const gpu::Extent extent = depth.extent();
    require_size("depth", view.depth.size(), extent);
    if (!view.normal.empty()) require_size("normals", view.normal.size(), extent);
    if (!view.previous_position.empty())
        require_size("previous positions", view.previous_position.size(), extent);
    require_layers(view.layers, extent);
    depth.upload(view.depth);
    if (!view.normal.empty()) normal.upload(texels_of(view.normal));
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

void FrameImages::map(const gpu::Device& device) {
    if (mapped) return;
    mapped.emplace(device, depth.extent(), r32f);
    filtered_mapped.emplace(device, depth.extent(), r32f);
}

}  // namespace gloam::effect
