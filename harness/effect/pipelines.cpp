// SPDX-License-Identifier: MIT
#include "effect/internal/pipelines.hpp"

namespace gloam::effect {
namespace {

// The value of that key, made where it is missing.
template <class Key, class Make>
const gpu::ComputePipeline& found_or_made(std::map<Key, gpu::ComputePipeline>& made, const Key& key,
                                          const Make& make) {
    const auto found = made.find(key);
    return found != made.end() ? found->second : made.emplace(key, make()).first->second;
}

}  // namespace

Pipelines::Pipelines(const gpu::Device& device, const scene::PassLibrary& library)
    : device_(&device), library_(library), normals_(normals_from_depth(device, library)) {}

const gpu::ComputePipeline& Pipelines::occlusion(const Program& program) {
    return found_or_made(occlusion_, program, [&] { return ambient_occlusion(*device_, library_, program); });
}

const gpu::ComputePipeline& Pipelines::reprojection(const Program& program) {
    return found_or_made(reprojection_, program, [&] { return reproject(*device_, library_, program); });
}

const gpu::ComputePipeline& Pipelines::filter(Filter filter, HistoryPrecision precision) {
    return found_or_made(filter_, {filter, precision},
                         [&] { return spatial_filter(*device_, library_, filter, precision); });
}

const gpu::ComputePipeline& Pipelines::remapping(HistoryPrecision precision) {
    return found_or_made(remapping_, precision, [&] { return remap(*device_, library_, precision); });
}

}  // namespace gloam::effect
