// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/errors.hpp"
#include "effect/pixel_classes.hpp"

namespace gloam::effect {

// The limit skips the first `limit_first` samples of a sequence and takes the next `limit_samples`.
constexpr std::uint32_t limit_first = 1'024;
constexpr std::uint32_t limit_samples = 4'096;

// The value to which an estimator converges on one view: the mean of its samples 1025 to 5120, without
// rotation. It shares no sample with an effect that has taken at most 1024. The difference between both
// therefore contains the errors of both.
class Limit {
  public:
    // The device must outlive this object. Throws like AmbientOcclusion.
    Limit(const gpu::Device& device, const scene::PassLibrary& passes, gpu::Extent extent);

    // The limit for each pixel of a view. Throws like AmbientOcclusion.
    [[nodiscard]] std::vector<float> of(const scene::GBuffer& view, const Settings& settings);

  private:
    AmbientOcclusion effect_;
};

// The references of an image: the limit of its own estimator, the depth truth (D) and the geometry truth (G).
// An empty image is an unknown reference.
enum class Against { limit, depth, geometry };
constexpr std::size_t references = 3;
using References = std::array<Truth, references>;

// The classes of PixelClasses. `young`: the pixels in no other class, whose history is still short.
enum class PixelClass { all, settled, young, disoccluded, near_moving };
constexpr std::size_t pixel_classes = 5;
inline constexpr std::array<PixelClass, pixel_classes> all_classes{PixelClass::all, PixelClass::settled,
                                                                   PixelClass::young, PixelClass::disoccluded,
                                                                   PixelClass::near_moving};
[[nodiscard]] std::string_view name_of(Against reference);
[[nodiscard]] std::string_view name_of(PixelClass which);

// The mask of a class in a frame; `all` is an empty mask.
[[nodiscard]] Mask mask_of(const PixelClasses& classes, PixelClass which);

// Errors as sums of squares, so that the errors of frames can be added.
struct SquaredErrors {
    double sum = 0.0;
    std::size_t count = 0;

    SquaredErrors& operator+=(const SquaredErrors& other);
    [[nodiscard]] double rmse() const;  // NaN without pixels
};

// Errors of one or more frames, by reference and class of pixel.
struct Score {
    using Table = std::array<std::array<SquaredErrors, pixel_classes>, references>;
    Table raw{};
    Table filtered{};

    Score& operator+=(const Score& other);
    [[nodiscard]] double rmse_raw(Against reference, PixelClass which) const;
    [[nodiscard]] double rmse_filtered(Against reference, PixelClass which) const;
};

// The errors of a frame. Throws std::invalid_argument when a known reference has another size.
[[nodiscard]] Score score_of(const Frame& frame, const References& references, const PixelClasses& classes);

// A frame of a view that stands still.
struct StillFrame {
    double samples = 0.0;                  // taken by a pixel so far, mean over the pixels that need samples
    double weight = 0.0;                   // counted in the mean: the samples taken, up to the cap
    std::array<double, references> raw{};  // RMSE; NaN if the reference is unknown
    std::array<double, references> filtered{};
    double bias = 0.0;  // mean of image - limit
};

// Convergence of the effect on a view that stands still: `frames` frames, each compared with the references.
// Throws like AmbientOcclusion.
[[nodiscard]] std::vector<StillFrame> study_still(const gpu::Device& device, const scene::PassLibrary& passes,
                                                  const scene::GBuffer& view, const Settings& settings,
                                                  const References& truth, int frames,
                                                  const std::function<void(double)>& progress = {});

// Slope of the raw image's mean square error against the limit, as a function of the samples taken, on
// logarithmic axes (least squares). It uses the frames before the weight reaches its cap. -1 for independent
// samples. NaN for fewer than two such frames.
[[nodiscard]] double convergence_slope(const std::vector<StillFrame>& frames, double weight_max);

}  // namespace gloam::effect
