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

gpu::Format format_of(OutputFormat output) {
    switch (output) {
        case OutputFormat::r16f:
            return r16f;
        case OutputFormat::r8:
            return r8;
        default:
            return r32f;
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
    if (!displacement) displacement.emplace(device, extent, r32ui);
}

void FrameImages::take_surfaces(const gpu::Device& device, const scene::GBuffer& view) {
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

void FrameImages::map(const gpu::Device& device, OutputFormat output) {
    const gpu::Format format = format_of(output);
    if (mapped && mapped->format() == format) return;
    mapped.emplace(device, depth.extent(), format);
    filtered_mapped.emplace(device, depth.extent(), format);
}

}  // namespace gloam::effect
