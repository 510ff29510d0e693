// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "check/answer.hpp"
#include "shader/compile.hpp"

namespace gloam::check {

// Runs a compute module before and after a compiler on the interpreter, each time with the same random
// contents of all that it binds, and compares every word of it afterwards, to the bit; all NaNs are equal. A
// module whose float operations are not all NoContraction may be rearranged legally: decorate it first.
// Interfaces are those of Pass, with names. `inputs`: the number of runs. A run of the module before that
// accesses memory outside of an array is not judged. Throws std::invalid_argument for another interface;
// backend::Unsupported for an instruction that the interpreter does not know.
[[nodiscard]] Answer compare_modules(const std::string& name, const shader::Spirv& before,
                                     const shader::Spirv& after, std::size_t inputs, std::uint64_t seed);

}  // namespace gloam::check
