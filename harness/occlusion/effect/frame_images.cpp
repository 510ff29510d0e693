// SPDX-License-Identifier: MIT
#include "effect/internal/frame_images.hpp"

namespace gloam::effect {
namespace {

using enum gpu::Format;

}  // namespace

gpu::Format format_of(HistoryPrecision precision) {
    return precision == HistoryPrecision::packed ? rgba16ui : rgba32f;
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

std::vector<float> expanded(const std::vector<float>& half, gpu::Extent extent) {
    const std::size_t columns = (extent.width + 1) / 2;
    std::vector<float> all;
    all.reserve(pixels_of(extent));
    for (std::size_t y = 0; y < extent.height; ++y)
        for (std::size_t x = 0; x < extent.width; ++x) all.push_back(half[y / 2 * columns + x / 2]);
    return all;
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

}  // namespace gloam::effect
