// SPDX-License-Identifier: MIT
#include "effect/internal/frame_images.hpp"

namespace gloam::effect {
namespace {

using enum gpu::Format;

}  // namespace

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
    return {.occlusion = channel(texels, 0), .samples = channel(texels, 1)};
}

}  // namespace gloam::effect
