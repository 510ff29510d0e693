// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "effect/internal/passes.hpp"
#include "effect/internal/tiles.hpp"

namespace gloam::effect {

// The compute pipelines of the passes. Each is compiled on first use. A returned reference stays valid as
// long as this object.
class Pipelines {
  public:
    Pipelines(const gpu::Device& device, const scene::PassLibrary& library);

    // Each throws std::runtime_error when its shader does not compile.
    [[nodiscard]] const gpu::ComputePipeline& normals() const { return normals_; }
    [[nodiscard]] const gpu::ComputePipeline& inputs(const InputProgram& program);
    [[nodiscard]] const gpu::ComputePipeline& occlusion(const Program& program);
    [[nodiscard]] const gpu::ComputePipeline& reprojection(const ReprojectionProgram& program);
    [[nodiscard]] const gpu::ComputePipeline& filter(const FilterProgram& program);
    // Like remap().
    [[nodiscard]] const gpu::ComputePipeline& remapping(std::optional<HistoryPrecision> history,
                                                        std::optional<TileLists> list, OutputFormat output);
    [[nodiscard]] const gpu::ComputePipeline& selection();
    [[nodiscard]] const gpu::ComputePipeline& filtered_selection();
    [[nodiscard]] const gpu::ComputePipeline& bounding();
    [[nodiscard]] const gpu::ComputePipeline& merging();
    [[nodiscard]] const gpu::ComputePipeline& opening();

  private:
    const gpu::Device* device_;
    scene::PassLibrary library_;
    gpu::ComputePipeline normals_;
    std::map<InputProgram, gpu::ComputePipeline> inputs_;
    std::map<Program, gpu::ComputePipeline> occlusion_;
    std::map<ReprojectionProgram, gpu::ComputePipeline> reprojection_;
    std::map<FilterProgram, gpu::ComputePipeline> filter_;
    std::map<std::tuple<std::optional<HistoryPrecision>, std::optional<TileLists>, OutputFormat>,
             gpu::ComputePipeline>
        remapping_;
    std::map<std::string, gpu::ComputePipeline> of_tiles_;
};

}  // namespace gloam::effect
