// SPDX-License-Identifier: MIT
#include "gpu/compute.hpp"

#include <algorithm>
#include <stdexcept>

#include "gpu/internal/compute_impl.hpp"
#include "gpu/internal/shader_module.hpp"

namespace gloam::gpu {
namespace {

void check_count(const Context& context, const ComputeProgram& program, BindingKind kind,
                 std::uint32_t limit) {
    const auto count = std::ranges::count(program.bindings, kind);
    if (count > limit) {
        throw std::invalid_argument(
            fmt::format("compute pipeline with {} {} bindings: device \"{}\" allows {}", count, name_of(kind),
                        context.physical.info.name, limit));
    }
}

vk::raii::DescriptorSetLayout make_set_layout(const Context& context, const ComputeProgram& program) {
    const auto& limits = context.physical.properties.limits;
    check_count(context, program, BindingKind::storage_buffer, limits.maxPerStageDescriptorStorageBuffers);
    check_count(context, program, BindingKind::storage_image, limits.maxPerStageDescriptorStorageImages);
    check_count(context, program, BindingKind::sampled_image,
                std::min(limits.maxPerStageDescriptorSampledImages, limits.maxPerStageDescriptorSamplers));
    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    for (const auto kind : program.bindings) {
        bindings.push_back({.binding = static_cast<std::uint32_t>(bindings.size()),
                            .descriptorType = descriptor_type(kind),
                            .descriptorCount = 1,
                            .stageFlags = vk::ShaderStageFlagBits::eCompute});
    }
    return {context.device,
            vk::DescriptorSetLayoutCreateInfo{.bindingCount = static_cast<std::uint32_t>(bindings.size()),
                                              .pBindings = bindings.data()}};
}

vk::raii::PipelineLayout make_layout(const Context& context, const vk::raii::DescriptorSetLayout& set_layout,
                                     std::uint32_t push_constant_bytes) {
    check_push_constant_size(context, push_constant_bytes);
    const vk::PushConstantRange range{.stageFlags = vk::ShaderStageFlagBits::eCompute,
                                      .size = push_constant_bytes};
    return {context.device,
            vk::PipelineLayoutCreateInfo{.setLayoutCount = 1,
                                         .pSetLayouts = &*set_layout,
                                         .pushConstantRangeCount = push_constant_bytes > 0 ? 1u : 0u,
                                         .pPushConstantRanges = &range}};
}

vk::raii::Pipeline make_pipeline(const Context& context, const vk::raii::PipelineLayout& layout,
                                 const ComputeProgram& program) {
    const auto module = make_module(context, program.spirv);
    const auto& constants = program.constants;
    std::vector<vk::SpecializationMapEntry> entries;
    for (const auto& constant : constants) {
        const auto offset = entries.size() * sizeof constant + offsetof(SpecializationConstant, bits);
        entries.push_back({.constantID = constant.id,
                           .offset = static_cast<std::uint32_t>(offset),
                           .size = sizeof constant.bits});
    }
    const vk::SpecializationInfo specialization{.mapEntryCount = static_cast<std::uint32_t>(entries.size()),
                                                .pMapEntries = entries.data(),
                                                .dataSize = constants.size() * sizeof(SpecializationConstant),
                                                .pData = constants.data()};
    const vk::ComputePipelineCreateInfo info{.stage = {.stage = vk::ShaderStageFlagBits::eCompute,
                                                       .module = *module,
                                                       .pName = "main",
                                                       .pSpecializationInfo = &specialization},
                                             .layout = *layout};
    return {context.device, context.cache.handle(), info};
}

ComputeHandles create(const Context& context, const ComputeProgram& program) {
    auto set_layout = make_set_layout(context, program);
    auto layout = make_layout(context, set_layout, program.push_constant_bytes);
    auto pipeline = make_pipeline(context, layout, program);
    return {std::move(set_layout), std::move(layout), std::move(pipeline)};
}

}  // namespace

vk::DescriptorType descriptor_type(BindingKind kind) {
    switch (kind) {
        case BindingKind::storage_buffer:
            return vk::DescriptorType::eStorageBuffer;
        case BindingKind::storage_image:
            return vk::DescriptorType::eStorageImage;
        case BindingKind::sampled_image:
            return vk::DescriptorType::eCombinedImageSampler;
    }
    throw std::invalid_argument("unknown kind of binding");
}

const char* name_of(BindingKind kind) {
    switch (kind) {
        case BindingKind::storage_buffer:
            return "storage buffer";
        case BindingKind::storage_image:
            return "storage image";
        case BindingKind::sampled_image:
            return "sampled image";
    }
    throw std::invalid_argument("unknown kind of binding");
}

ComputePipeline::Impl::Impl(Context& owner, const ComputeProgram& made_of)
    : context(owner),
      bindings(made_of.bindings),
      push_constant_bytes(made_of.push_constant_bytes),
      program{{made_of.spirv.begin(), made_of.spirv.end()}, made_of.constants, made_of.bindings},
      handles(owner, create(owner, made_of)) {}

const PipelineProgram& program_of(const ComputePipeline& pipeline) {
    return pipeline.impl().program;
}

ComputePipeline::ComputePipeline(const Device& device, const ComputeProgram& program)
    : impl_(std::make_unique<Impl>(device.impl(), program)) {}
ComputePipeline::~ComputePipeline() = default;
ComputePipeline::ComputePipeline(ComputePipeline&&) noexcept = default;
ComputePipeline& ComputePipeline::operator=(ComputePipeline&&) noexcept = default;

}  // namespace gloam::gpu
