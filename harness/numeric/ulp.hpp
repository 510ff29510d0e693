// SPDX-License-Identifier: MIT
#pragma once

namespace gloam::numeric {

// One unit in the last place of float32 at the real number x, by Harrison's definition: the distance of the
// two float32 neighbours that enclose x; at a power of two the smaller gap; below the smallest normal 2^-149;
// beyond the largest finite value 2^104. x = +-infinity or NaN: NaN.
[[nodiscard]] double ulp_size(double x);

// Distance of `got` from the exact result `want`, in ULP of `want`.
//   both NaN, or the same infinity: 0. Exactly one NaN: infinity. Infinity against a finite `want`: infinity,
//   unless |want| exceeds the largest float32, where both that value and infinity of the right sign are
//   exact. A `want` below the smallest normal also accepts 0, because Vulkan lets subnormal results be
//   flushed.
[[nodiscard]] double ulp_error(float got, double want);

// |got - want| with the same special cases: 0 where ulp_error is 0, infinity where it is infinity.
[[nodiscard]] double absolute_error(float got, double want);

// The float32 `steps` representable values above x (below, when negative), crossing zero once (+0 and -0 are
// one value), stopping at +-infinity. NaN stays NaN.
[[nodiscard]] float step(float x, int steps);

}  // namespace gloam::numeric
