// SPDX-License-Identifier: MIT
#pragma once

#include "gpu/compute.hpp"
#include "gpu/internal/guarded.hpp"
#include "gpu/program_of.hpp"

namespace gloam::gpu {

struct ComputeHandles {
    vk::raii::DescriptorSetLayout set_layout;
    vk::raii::PipelineLayout layout;
    vk::raii::Pipeline pipeline;
};

struct ComputePipeline::Impl {
    Impl(Context& owner, const ComputeProgram& program);

    Context& context;
    std::vector<BindingKind> bindings;
    std::uint32_t push_constant_bytes;
    PipelineProgram program;
    Guarded<ComputeHandles> handles;
};

constexpr std::size_t binding_kinds = 3;

[[nodiscard]] vk::DescriptorType descriptor_type(BindingKind kind);
[[nodiscard]] const char* name_of(BindingKind kind);

}  // namespace gloam::gpu
