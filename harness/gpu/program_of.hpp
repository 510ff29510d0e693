// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "gpu/compute.hpp"

namespace gloam::gpu {

// What a pipeline was made of, for whoever runs it elsewhere.
struct PipelineProgram {
    std::vector<std::uint32_t> spirv;
    std::vector<SpecializationConstant> constants;
};
[[nodiscard]] const PipelineProgram& program_of(const ComputePipeline& pipeline);

}  // namespace gloam::gpu
