// SPDX-License-Identifier: MIT
#pragma once

#include "shader/compile.hpp"

namespace gloam::shader {

// Decorations added to a module, everything else left as it is. What has the decoration already keeps it; a
// second call changes nothing. Both throw std::runtime_error when the words are no SPIR-V module.

// NoContraction on the result of every float arithmetic instruction (negation, sum, difference, product,
// quotient, remainder, modulo, dot and outer product, and products with matrices): neither contracted with
// another nor reordered. The extended instructions (sqrt, fma, ...) cannot carry it.
[[nodiscard]] Spirv with_no_contraction(const Spirv& module);

// RelaxedPrecision on every float32 scalar, vector or matrix result: it may be calculated with the range and
// precision of float16. Constants, and bit patterns that become floats (uintBitsToFloat), are left alone.
[[nodiscard]] Spirv with_relaxed_precision(const Spirv& module);

}  // namespace gloam::shader
