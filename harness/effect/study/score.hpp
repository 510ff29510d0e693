// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "effect/ambient_occlusion.hpp"
#include "effect/errors.hpp"
#include "effect/pixel_classes.hpp"

namespace gloam::effect {

// What an image is compared with: the limit of its own estimator, the truth of the depth buffer (D), the
// truth of the geometry (G). An image without a pixel is not known.
enum class Against { limit, depth, geometry };
constexpr std::size_t references = 3;
using References = std::array<Truth, references>;

// The classes of PixelClasses. `young`: those in none of them, whose history is still short.
enum class PixelClass { all, settled, young, disoccluded, near_moving };
constexpr std::size_t pixel_classes = 5;
inline constexpr std::array<PixelClass, pixel_classes> all_classes{PixelClass::all, PixelClass::settled,
                                                                   PixelClass::young, PixelClass::disoccluded,
                                                                   PixelClass::near_moving};
[[nodiscard]] std::string_view name_of(Against reference);
[[nodiscard]] std::string_view name_of(PixelClass which);

// The mask of a class in a frame; `all` is an empty mask.
[[nodiscard]] Mask mask_of(const PixelClasses& classes, PixelClass which);

// Errors as sums of squares, so that those of frames add up.
struct SquaredErrors {
    double sum = 0.0;
    std::size_t count = 0;

    SquaredErrors& operator+=(const SquaredErrors& other);
    [[nodiscard]] double rmse() const;  // NaN for none
};

// Errors of a frame, or of several together, by reference and class of pixel.
struct Score {
    using Table = std::array<std::array<SquaredErrors, pixel_classes>, references>;
    Table raw{};
    Table filtered{};

    Score& operator+=(const Score& other);
    [[nodiscard]] double rmse_raw(Against reference, PixelClass which) const;
    [[nodiscard]] double rmse_filtered(Against reference, PixelClass which) const;
};

// Throws std::invalid_argument when a reference that is known is of another size.
[[nodiscard]] Score score_of(const Frame& frame, const References& references, const PixelClasses& classes);

}  // namespace gloam::effect
