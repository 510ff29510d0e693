// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "gpu/compute.hpp"

namespace gloam::gpu {

// The parts of a pipeline, for running it elsewhere.
struct PipelineProgram {
    std::vector<std::uint32_t> spirv;
    std::vector<SpecializationConstant> constants;
    std::vector<BindingKind> bindings;
};
[[nodiscard]] const PipelineProgram& program_of(const ComputePipeline& pipeline);

}  // namespace gloam::gpu
