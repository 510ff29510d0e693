// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "backend/vulkan/resources.hpp"
#include "effect/pixel_classes.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::effect {

// The reference of an image: the true occlusion of each pixel, NaN where it is unknown. All images that a
// function takes have one size.
using Truth = std::vector<float>;

// Errors of an image over the pixels whose truth is known; all 0 when there are none.
struct Errors {
    std::size_t compared = 0;
    double rmse = 0.0;
    double mean = 0.0;           // of the magnitude
    double percentile_99 = 0.0;  // of the magnitude
    double max = 0.0;            // of the magnitude
    double bias = 0.0;           // mean of image - truth
};

// Errors of an occlusion image.
[[nodiscard]] Errors errors_of(std::span<const float> occlusion, std::span<const float> truth);

// True occlusion at a world-space point, for a radius in world units.
using TrueOcclusion = std::function<double(const glm::dvec3& world, double radius)>;

// The truth of each pixel of a view. NaN at the background, and where the ball of the radius around the point
// comes within a pixel of the image's border, because the image does not show what is outside.
[[nodiscard]] Truth truth_of(const scene::GBuffer& view, double radius, const TrueOcclusion& true_occlusion);

// A reference image as truth: NaN at the background.
[[nodiscard]] Truth truth_from(const scene::GBuffer& view, std::span<const float> reference);

// numeric::structural_similarity() of an occlusion image and the truth, as visibility.
[[nodiscard]] double structural_similarity(std::span<const float> occlusion, std::span<const float> truth,
                                           backend::Extent extent);

// The remap of a visibility v in [0, 1] (CS-REMAP): v' = (b (v + a))^c, clamped to [0, 1]. A base below 0
// gives 0.
struct Remap {
    double a = 0.0;
    double b = 1.0;
    double c = 1.0;

    [[nodiscard]] double operator()(double visibility) const;
};

// Pixels of nearly equal visibility, as sums: those of several images can be added, and the squared error
// after a remap follows from them.
struct RemapBin {
    double count = 0.0;
    double visibility = 0.0;  // summed
    double truth = 0.0;       // summed, as visibility
    double square = 0.0;      // of the truth, summed
};

// Adds the pixels of an image with a truth to bins, which divide visibility 0 to 1.
void add_to_bins(std::span<RemapBin> bins, std::span<const float> occlusion, std::span<const float> truth);

// The remap with the least squared error over the pixels of bins; no remap without a pixel.
[[nodiscard]] Remap best_remap(std::span<const RemapBin> bins);

// The root mean square error after a remap, all pixels of a bin taken at their mean. NaN without a pixel.
[[nodiscard]] double remapped_rmse(std::span<const RemapBin> bins, const Remap& remap);

// The remap that minimises the root mean square difference of an occlusion image from the truth. It shows how
// accurate a method is apart from constant factors. The result is deterministic, and its error is never
// larger than without a remap. If no truth is known, the result is no remap.
[[nodiscard]] Remap best_remap(std::span<const float> occlusion, std::span<const float> truth);

// The occlusion image after a remap.
[[nodiscard]] std::vector<float> remapped(std::span<const float> occlusion, const Remap& remap);

// Differences between an occlusion image and the truth, over the pixels whose truth is known.
struct Metrics {
    Errors raw;
    double similarity = 1.0;  // SSIM
    Remap remap;              // the one that brings the image nearest to the truth
    Errors after_remap;
    double similarity_after_remap = 1.0;
};

// Calculates them.
[[nodiscard]] Metrics metrics_of(std::span<const float> occlusion, std::span<const float> truth,
                                 backend::Extent extent);

// The truth where the mask is set, NaN elsewhere.
[[nodiscard]] Truth masked(std::span<const float> truth, const Mask& mask);

// Errors by class of pixel, in the order of pixel_class_names.
using ClassErrors = std::array<Errors, pixel_class_names.size()>;
[[nodiscard]] ClassErrors class_errors_of(std::span<const float> occlusion, std::span<const float> truth,
                                          const PixelClasses& classes);

}  // namespace gloam::effect
