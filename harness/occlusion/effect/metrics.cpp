// SPDX-License-Identifier: MIT
#include "effect/metrics.hpp"

#include <limits>
#include <stdexcept>
#include <string>

#include "effect/similarity.hpp"

namespace gloam::effect {

Metrics metrics_of(std::span<const float> occlusion, std::span<const float> truth, gpu::Extent extent) {
    Metrics metrics{.raw = errors_of(occlusion, truth),
                    .similarity = structural_similarity(occlusion, truth, extent),
                    .remap = best_remap(occlusion, truth)};
    const std::vector<float> nearest = remapped(occlusion, metrics.remap);
    metrics.after_remap = errors_of(nearest, truth);
    metrics.similarity_after_remap = structural_similarity(nearest, truth, extent);
    return metrics;
}

Truth masked(std::span<const float> truth, const Mask& mask) {
    if (mask.size() != truth.size())
        throw std::invalid_argument("mask of " + std::to_string(mask.size()) + " pixels, truth of " +
                                    std::to_string(truth.size()));
    Truth result(truth.begin(), truth.end());
    for (std::size_t i = 0; i < result.size(); ++i) {
        if (mask[i] == 0) result[i] = std::numeric_limits<float>::quiet_NaN();
    }
    return result;
}

ClassErrors class_errors_of(std::span<const float> occlusion, std::span<const float> truth,
                            const PixelClasses& classes) {
    return {errors_of(occlusion, masked(truth, classes.disoccluded())),
            errors_of(occlusion, masked(truth, classes.near_moving())),
            errors_of(occlusion, masked(truth, classes.settled()))};
}

}  // namespace gloam::effect
