// SPDX-License-Identifier: MIT
#include "effect/internal/frame_images.hpp"

namespace gloam::effect {
namespace {

using enum gpu::Format;

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
    : inputs(device, size),
      before(device, size, format_of(precision)),
      reprojected(device, size, format_of(precision)),
      after(device, size, format_of(precision)),
      half_filtered(device, size, r32f),
      filtered(device, size, r32f),
      tiles(device, size) {}

void FrameImages::watch_objects(const gpu::Device& device) {
    if (inputs.previous_position && !displacement) displacement.emplace(device, inputs.depth.extent(), r32ui);
}

void FrameImages::map(const gpu::Device& device, OutputFormat output) {
    const gpu::Format format = format_of(output);
    if (mapped && mapped->format() == format) return;
    mapped.emplace(device, inputs.depth.extent(), format);
    filtered_mapped.emplace(device, inputs.depth.extent(), format);
}

}  // namespace gloam::effect
