// SPDX-License-Identifier: MIT
#include "effect/internal/pipelines.hpp"

namespace gloam::effect {
namespace {

// The value for a key; made if it is missing.
template <class Key, class Make>
const gpu::ComputePipeline& found_or_made(std::map<Key, gpu::ComputePipeline>& made, const Key& key,
                                          const Make& make) {
    const auto found = made.find(key);
    return found != made.end() ? found->second : made.emplace(key, make()).first->second;
}

}  // namespace

Pipelines::Pipelines(const gpu::Device& device, const scene::PassLibrary& library)
    : device_(&device), library_(library), normals_(normals_from_depth(device, library)) {}

const gpu::ComputePipeline& Pipelines::inputs(const InputProgram& program) {
    return found_or_made(inputs_, program, [&] { return take_inputs(*device_, library_, program); });
}

const gpu::ComputePipeline& Pipelines::occlusion(const Program& program) {
    return found_or_made(occlusion_, program, [&] { return ambient_occlusion(*device_, library_, program); });
}

const gpu::ComputePipeline& Pipelines::reprojection(const ReprojectionProgram& program) {
    return found_or_made(reprojection_, program, [&] { return reproject(*device_, library_, program); });
}

const gpu::ComputePipeline& Pipelines::filter(const FilterProgram& program) {
    return found_or_made(filter_, program, [&] { return spatial_filter(*device_, library_, program); });
}

const gpu::ComputePipeline& Pipelines::remapping(std::optional<HistoryPrecision> history,
                                                 std::optional<TileLists> list, OutputFormat output) {
    return found_or_made(remapping_, {history, list, output},
                         [&] { return remap(*device_, library_, history, list, output); });
}

const gpu::ComputePipeline& Pipelines::selection() {
    return found_or_made(of_tiles_, std::string("select"), [&] { return select_tiles(*device_, library_); });
}

const gpu::ComputePipeline& Pipelines::bounding() {
    return found_or_made(of_tiles_, std::string("bound"), [&] { return bound_tiles(*device_, library_); });
}

const gpu::ComputePipeline& Pipelines::merging() {
    return found_or_made(of_tiles_, std::string("merge"), [&] { return merge_bounds(*device_, library_); });
}

const gpu::ComputePipeline& Pipelines::opening() {
    return found_or_made(of_tiles_, std::string("open"), [&] { return open_tiles(*device_, library_); });
}

const gpu::ComputePipeline& Pipelines::filtered_selection() {
    return found_or_made(of_tiles_, std::string("select_filtered"),
                         [&] { return select_filtered_tiles(*device_, library_); });
}

}  // namespace gloam::effect
