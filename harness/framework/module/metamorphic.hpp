// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "module/compile.hpp"

namespace gloam::shader {

// Changes of a module that leave its meaning as it is: a right compiler gives the same results for both.
// GraphicsFuzz (Donaldson et al. 2017) and spirv-fuzz find faults of compilers in this way.
//
// Values: operands of commutative operations are exchanged, comparisons turned round, vectors taken apart. An
// operation moves to a function of its own. A constant is added to a zero that only the device knows. A value
// is negated twice, its bits are reinterpreted twice, or a select takes it. Memory: a loaded value is stored
// again, a store precedes one that overwrites it. Control flow: branches never taken, loops of one round,
// negated conditions, branches as switches, selects as branches with a phi, divided blocks. Straight code
// becomes the cases of a switch in a loop.
struct Metamorphism {
    Spirv module;
    std::vector<std::string> changes;  // the name of each change made, in order
};

// How many changes a seed stands for.
inline constexpr std::size_t metamorphic_changes = 24;

// Makes the changes of a seed at these positions (counted from 0), in order; a change that finds no place is
// left out. The same arguments give the same module. Throws std::runtime_error for words that are not a
// SPIR-V module.
[[nodiscard]] Metamorphism metamorphic(const Spirv& module, std::uint64_t seed,
                                       const std::vector<std::size_t>& positions);

}  // namespace gloam::shader
