// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <utility>

#include "effect/internal/passes.hpp"

namespace gloam::effect {

// The compute pipelines of the passes, each made when it is first asked for. A reference that was returned
// stays good.
class Pipelines {
  public:
    Pipelines(const gpu::Device& device, const scene::PassLibrary& library);

    // Each throws std::runtime_error where its shader does not compile.
    [[nodiscard]] const gpu::ComputePipeline& normals() const { return normals_; }
    [[nodiscard]] const gpu::ComputePipeline& occlusion(const Program& program);
    [[nodiscard]] const gpu::ComputePipeline& reprojection(const Program& program);
    // `precision`: of the image that the pass reads.
    [[nodiscard]] const gpu::ComputePipeline& filter(Filter filter, HistoryPrecision precision);
    [[nodiscard]] const gpu::ComputePipeline& remapping(HistoryPrecision precision);

  private:
    const gpu::Device* device_;
    scene::PassLibrary library_;
    gpu::ComputePipeline normals_;
    std::map<Program, gpu::ComputePipeline> occlusion_;
    std::map<Program, gpu::ComputePipeline> reprojection_;
    std::map<std::pair<Filter, HistoryPrecision>, gpu::ComputePipeline> filter_;
    std::map<HistoryPrecision, gpu::ComputePipeline> remapping_;
};

}  // namespace gloam::effect
