// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "backend/backend.hpp"
#include "module/compile.hpp"

// What a GPU's compiler makes of a compute shader, without a GPU (docs/cost.md).
namespace gloam::cost {

// Of one invocation. Both sides of each branch count, and the body of a loop that is left counts once.
struct Cost {
    std::uint64_t instructions = 0;
    std::uint64_t valu = 0;  // vector instructions: the arithmetic of an invocation
    std::uint64_t loads = 0;
    std::uint64_t stores = 0;     // and atomic operations
    std::uint64_t registers = 0;  // vector registers of an invocation
    std::uint64_t waves = 0;      // that a SIMD unit holds with so many registers
    std::uint64_t spilled = 0;    // vector registers that went to memory
    std::uint64_t loops = 0;      // that were not unrolled
    std::uint64_t in_loops = 0;   // instructions in these

    friend bool operator==(const Cost&, const Cost&) = default;
};

struct CostField {
    std::string_view name;
    std::uint64_t Cost::* value;
};
inline constexpr std::array cost_fields{CostField{"instructions", &Cost::instructions},
                                        CostField{"valu", &Cost::valu},
                                        CostField{"loads", &Cost::loads},
                                        CostField{"stores", &Cost::stores},
                                        CostField{"registers", &Cost::registers},
                                        CostField{"waves", &Cost::waves},
                                        CostField{"spilled", &Cost::spilled},
                                        CostField{"loops", &Cost::loops},
                                        CostField{"in_loops", &Cost::in_loops}};

// The instructions, loads, stores and loops of RADV's text of a program: the rest stays 0.
[[nodiscard]] Cost counted(std::string_view assembly);

// The chips, the usual one first.
inline constexpr std::array families{"NAVI21", "NAVI31", "POLARIS10"};

struct CostOptions {
    std::string family = "NAVI21";
    std::vector<backend::Constant> constants = {};  // specialization constants; others have their default
    bool validation = false;                        // Vulkan's layers are on; any message is an error
};

// The cost of a compute shader with the entry point "main". Another process compiles it, under the limits of
// all compilers of foreign texts (base::compiler_limits). Throws std::invalid_argument for another family,
// with those known; base::WorkError, for example backend::vulkan::no_radv_message where RADV is not
// installed; base::LimitError.
[[nodiscard]] Cost cost_of(const module::Spirv& module, const CostOptions& options = {});
// What each of several modules costs; one process compiles all of them.
[[nodiscard]] std::vector<Cost> costs_of(std::span<const module::Spirv> modules,
                                         const CostOptions& options = {});

}  // namespace gloam::cost
