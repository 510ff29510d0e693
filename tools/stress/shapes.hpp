// SPDX-License-Identifier: MIT
#pragma once

#include "effect/ambient_occlusion.hpp"
#include "stress/run.hpp"

namespace gloam::stress {

// Image sizes from 1 x 1 over odd primes and the edges of work groups to the device's limit: every pixel is
// written, a bare plane is open. Radii that are zero, negative, infinite or NaN, and sample counts from none
// to the most: what cannot be is refused, the rest is counted to the last sample.
[[nodiscard]] Rows shapes(const Context& context);

// The same with an effect of shapes_effect() that other methods may have used: it has compiled the passes
// that methods share.
[[nodiscard]] Rows shapes(const Context& context, effect::AmbientOcclusion& effect);
[[nodiscard]] effect::AmbientOcclusion shapes_effect(const Context& context);

// The row of one image size: pixels that are not as they must be, with each of the context's
// methods, with normals and without.
// A size at the device's limit is tried less often in a brief run.
[[nodiscard]] Row one_size(const Context& context, gpu::Extent size);

}  // namespace gloam::stress
