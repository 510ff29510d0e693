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

}  // namespace gloam::effect
