// SPDX-License-Identifier: MIT
#pragma once

#include "shader/compile.hpp"

namespace gloam::shader {

// Adds decorations to a module and changes nothing else. An existing decoration is kept, so a second call
// changes nothing. Both throw std::runtime_error for words that are not a SPIR-V module.

// Adds NoContraction to the result of every float arithmetic instruction (negation, sum, difference, product,
// quotient, remainder, modulo, dot and outer product, and products with matrices), so that it is neither
// contracted nor reordered. The extended instructions (sqrt, fma, ...) do not support this decoration.
[[nodiscard]] Spirv with_no_contraction(const Spirv& module);

// Adds RelaxedPrecision to every float32 scalar, vector or matrix result, so that it may be calculated with
// the range and precision of float16. Constants, and bit patterns that become floats (uintBitsToFloat), are
// not decorated.
[[nodiscard]] Spirv with_relaxed_precision(const Spirv& module);

}  // namespace gloam::shader
