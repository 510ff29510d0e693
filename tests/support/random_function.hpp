// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace gloam::test {

// The GLSL text of a function random_SEED with loops, branches, switches, arrays, vectors, matrices, integers
// and calls, and of those that it calls. Floats are halves of small integers, so that each operation has one
// legal result, whatever the order that a compiler chooses. The same seed gives the same text.
[[nodiscard]] std::string random_function(std::uint64_t seed);

// The range of its parameter x (subject::range_from()). The others take any integers.
inline constexpr const char* random_function_range = "x=-16:16";

}  // namespace gloam::test
