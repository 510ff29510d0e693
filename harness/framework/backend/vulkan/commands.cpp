// SPDX-License-Identifier: MIT
#include "backend/vulkan/commands.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "backend/vulkan/internal/context.hpp"
#include "backend/vulkan/internal/objects.hpp"

namespace gloam::gpu {
namespace {

vk::raii::Pipeline make_pipeline(const Context& context, const vk::raii::PipelineLayout& layout,
                                 const ComputeProgram& program) {
    const auto module = make_module(context, program.spirv);
    const Specialization specialization(program.constants);
    const vk::ComputePipelineCreateInfo info{.stage = {.stage = vk::ShaderStageFlagBits::eCompute,
                                                       .module = *module,
                                                       .pName = "main",
                                                       .pSpecializationInfo = &specialization.info},
                                             .layout = *layout};
    return {context.device, context.cache.handle(), info};
}

ComputeHandles create(const Context& context, const ComputeProgram& program) {
    auto set_layout = make_set_layout(context, program.bindings, vk::ShaderStageFlagBits::eCompute);
    auto layout =
        make_layout(context, set_layout, vk::ShaderStageFlagBits::eCompute, program.push_constant_bytes);
    auto pipeline = make_pipeline(context, layout, program);
    return {std::move(set_layout), std::move(layout), std::move(pipeline)};
}

void check_count(const Context& context, std::span<const BindingKind> kinds, BindingKind kind,
                 std::uint32_t limit) {
    const auto count = std::ranges::count(kinds, descriptor_type(kind), descriptor_type);
    if (count > limit) {
        throw std::invalid_argument(fmt::format("pipeline with {} {} bindings: device \"{}\" allows {}",
                                                count, name_of(kind), context.physical.info.name, limit));
    }
}

}  // namespace

Specialization::Specialization(std::span<const SpecializationConstant> constants) {
    for (const auto& constant : constants) {
        const auto offset = entries.size() * sizeof constant + offsetof(SpecializationConstant, bits);
        entries.push_back({.constantID = constant.id,
                           .offset = static_cast<std::uint32_t>(offset),
                           .size = sizeof constant.bits});
    }
    info = vk::SpecializationInfo{.mapEntryCount = static_cast<std::uint32_t>(entries.size()),
                                  .pMapEntries = entries.data(),
                                  .dataSize = constants.size_bytes(),
                                  .pData = constants.data()};
}

vk::raii::DescriptorSetLayout make_set_layout(const Context& context, std::span<const BindingKind> kinds,
                                              vk::ShaderStageFlags stages) {
    const auto& limits = context.physical.properties.limits;
    check_count(context, kinds, BindingKind::storage_buffer, limits.maxPerStageDescriptorStorageBuffers);
    check_count(context, kinds, BindingKind::storage_image, limits.maxPerStageDescriptorStorageImages);
    check_count(context, kinds, BindingKind::uniform_buffer, limits.maxPerStageDescriptorUniformBuffers);
    check_count(context, kinds, BindingKind::sampled_image,
                std::min(limits.maxPerStageDescriptorSampledImages, limits.maxPerStageDescriptorSamplers));
    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    for (std::uint32_t i = 0; i < kinds.size(); ++i)
        bindings.push_back({.binding = i,
                            .descriptorType = descriptor_type(kinds[i]),
                            .descriptorCount = 1,
                            .stageFlags = stages});
    return {context.device,
            vk::DescriptorSetLayoutCreateInfo{.bindingCount = static_cast<std::uint32_t>(bindings.size()),
                                              .pBindings = bindings.data()}};
}

vk::DescriptorType descriptor_type(BindingKind kind) {
    static constexpr std::array types{vk::DescriptorType::eStorageBuffer, vk::DescriptorType::eStorageImage,
                                      vk::DescriptorType::eCombinedImageSampler,
                                      vk::DescriptorType::eUniformBuffer};  // in the order of BindingKind
    return types.at(static_cast<std::size_t>(kind));
}

const char* name_of(BindingKind kind) {
    static constexpr std::array names{"storage buffer", "storage image", "sampled image", "uniform buffer"};
    return names.at(static_cast<std::size_t>(kind));
}

ComputePipeline::Impl::Impl(Context& owner, const ComputeProgram& made_of)
    : context(owner),
      bindings(made_of.bindings),
      program{{made_of.spirv.begin(), made_of.spirv.end()}, made_of.constants, made_of.bindings},
      handles(owner, create(owner, made_of)) {}

const PipelineProgram& program_of(const ComputePipeline& pipeline) {
    return pipeline.impl().program;
}

ComputePipeline::ComputePipeline(const Device& device, const ComputeProgram& program)
    : impl_(base::make_hidden<Impl>(device.impl(), program)) {}

namespace {

constexpr std::uint32_t sets_per_pool = 64;
constexpr std::uint32_t descriptors_per_pool = 256;  // of each kind

}  // namespace

const vk::raii::DescriptorSet& DescriptorAllocator::allocate(const ComputePipeline::Impl& pipeline) {
    return allocate(pipeline.context, pipeline.handles->set_layout, pipeline.bindings);
}

const vk::raii::DescriptorSet& DescriptorAllocator::allocate(const Context& context,
                                                             const vk::raii::DescriptorSetLayout& layout,
                                                             std::span<const BindingKind> bindings) {
    Counts needed{};
    for (const BindingKind kind : bindings) ++needed.at(static_cast<std::size_t>(kind));
    bool fits = sets_left_ > 0;
    for (std::size_t kind = 0; kind < binding_kinds; ++kind) fits = fits && needed[kind] <= left_[kind];
    if (!fits) add_pool(context, needed);
    vk::raii::DescriptorSets sets(
        context.device,
        vk::DescriptorSetAllocateInfo{
            .descriptorPool = *pools_.back(), .descriptorSetCount = 1, .pSetLayouts = &*layout});
    sets_left_ -= 1;
    for (std::size_t kind = 0; kind < binding_kinds; ++kind) left_[kind] -= needed[kind];
    return sets_.emplace_back(std::move(sets.front()));
}

void DescriptorAllocator::add_pool(const Context& context, const Counts& needed) {
    sets_left_ = sets_per_pool;
    std::array<vk::DescriptorPoolSize, binding_kinds> sizes;
    for (std::size_t kind = 0; kind < binding_kinds; ++kind) {
        left_[kind] = std::max(needed[kind], descriptors_per_pool);
        sizes[kind] = {.type = descriptor_type(static_cast<BindingKind>(kind)),
                       .descriptorCount = left_[kind]};
    }
    pools_.emplace_back(context.device, vk::DescriptorPoolCreateInfo{
                                            .flags = vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet,
                                            .maxSets = sets_left_,
                                            .poolSizeCount = sizes.size(),
                                            .pPoolSizes = sizes.data()});
}

void write_descriptors(const Context& context, const vk::raii::DescriptorSet& set,
                       std::span<const BindingKind> bindings, std::span<const Resource> resources) {
    std::vector<vk::DescriptorBufferInfo> buffers(resources.size());
    std::vector<vk::DescriptorImageInfo> images(resources.size());
    std::vector<vk::WriteDescriptorSet> writes;
    for (std::uint32_t i = 0; i < resources.size(); ++i) {
        vk::WriteDescriptorSet write{.dstSet = *set,
                                     .dstBinding = i,
                                     .descriptorCount = 1,
                                     .descriptorType = descriptor_type(bindings[i])};
        if (const auto* buffer = std::get_if<std::reference_wrapper<const Buffer>>(&resources[i])) {
            buffers[i] = vk::DescriptorBufferInfo{.buffer = *buffer->get().impl().handles->buffer,
                                                  .range = VK_WHOLE_SIZE};
            write.pBufferInfo = &buffers[i];
        } else if (const auto* sampled =
                       std::get_if<std::reference_wrapper<const SampledImage>>(&resources[i])) {
            const SampledHandles& handles = *sampled->get().impl().handles;
            images[i] = vk::DescriptorImageInfo{.sampler = *handles.sampler,
                                                .imageView = *handles.view,
                                                .imageLayout = vk::ImageLayout::eGeneral};
            write.pImageInfo = &images[i];
        } else if (const auto* layered =
                       std::get_if<std::reference_wrapper<const LayeredImage>>(&resources[i])) {
            images[i] = vk::DescriptorImageInfo{.imageView = *layered->get().impl().handles->view,
                                                .imageLayout = vk::ImageLayout::eGeneral};
            write.pImageInfo = &images[i];
        } else if (const auto* level = std::get_if<ImageLevel>(&resources[i])) {
            images[i] =
                vk::DescriptorImageInfo{.imageView = *level->image.get().impl().levels->at(level->level),
                                        .imageLayout = vk::ImageLayout::eGeneral};
            write.pImageInfo = &images[i];
        } else {
            const auto* linear = std::get_if<LinearImage>(&resources[i]);
            const Image& image =
                linear ? linear->image : std::get<std::reference_wrapper<const Image>>(resources[i]);
            images[i] = vk::DescriptorImageInfo{.sampler = linear ? *context.linear : *context.sampler,
                                                .imageView = *image.impl().handles->view,
                                                .imageLayout = vk::ImageLayout::eGeneral};
            write.pImageInfo = &images[i];
        }
        writes.push_back(write);
    }
    context.device.updateDescriptorSets(writes, nullptr);
}

namespace {

Recording create(const Context& context) {
    vk::raii::CommandBuffers buffers(context.device, {.commandPool = *context.command_pool,
                                                      .level = vk::CommandBufferLevel::ePrimary,
                                                      .commandBufferCount = 1});
    buffers.front().begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    device_barrier(buffers.front());
    return {.buffers = std::move(buffers), .descriptors = {}, .timestamps = {}, .framebuffers = {}};
}

void check_groups(const DeviceInfo& device, const std::array<std::uint32_t, 3>& groups) {
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (groups[i] > device.max_group_count[i]) {
            throw std::invalid_argument(fmt::format("dispatch: {} work groups in {}, device \"{}\" allows {}",
                                                    groups[i], "xyz"[i], device.name,
                                                    device.max_group_count[i]));
        }
    }
}

}  // namespace

Commands::Impl::Impl(Context& owner) : context(owner), handles(owner, create(owner)) {}

const vk::raii::CommandBuffer& Commands::Impl::recording() const {
    if (state != State::recording) throw std::runtime_error("these commands were submitted: record new ones");
    return handles->buffers.front();
}

void Commands::Impl::bind(const ComputePipeline& pipeline, std::span<const Resource> resources,
                          std::span<const std::byte> push_constants) {
    constexpr auto point = vk::PipelineBindPoint::eCompute;
    const auto& program = pipeline.impl();
    const auto& commands = recording();
    commands.bindPipeline(point, *program.handles->pipeline);
    if (!resources.empty()) {
        const auto& set = handles->descriptors.allocate(program);
        write_descriptors(context, set, program.bindings, resources);
        commands.bindDescriptorSets(point, *program.handles->layout, 0, *set, nullptr);
    }
    if (!push_constants.empty()) {
        commands.pushConstants<std::byte>(*program.handles->layout, vk::ShaderStageFlagBits::eCompute, 0,
                                          push_constants);
    }
}

Commands::Commands(const Device& device) : impl_(base::make_hidden<Impl>(device.impl())) {}

void Commands::dispatch(const ComputePipeline& pipeline, std::span<const Resource> resources,
                        std::array<std::uint32_t, 3> groups, std::span<const std::byte> push_constants) {
    check_groups(impl_->context.physical.info, groups);
    impl_->bind(pipeline, resources, push_constants);
    const auto& commands = impl_->recording();
    commands.dispatch(groups[0], groups[1], groups[2]);
    device_barrier(commands);
}

void Commands::dispatch(const ComputePipeline& pipeline, std::span<const Resource> resources,
                        const Buffer& groups, std::span<const std::byte> push_constants) {
    impl_->bind(pipeline, resources, push_constants);
    const auto& commands = impl_->recording();
    commands.dispatchIndirect(*groups.impl().handles->buffer, 0);
    device_barrier(commands);
}

std::size_t Commands::timestamp() {
    const auto& commands = impl_->recording();
    const std::size_t position = impl_->handles->timestamps.record(impl_->context, commands);
    // lavapipe delays a dispatch until something waits for it. Without a barrier, the time of the work before
    // the reading would count after it. One that makes nothing visible suffices, and takes 3 us less of an
    // H200.
    constexpr auto all = vk::PipelineStageFlagBits::eAllCommands;
    commands.pipelineBarrier(all, all, {}, nullptr, nullptr, nullptr);
    return position;
}

void Commands::submit() {
    const auto& commands = impl_->recording();
    host_barrier(commands);
    commands.end();
    impl_->state = Impl::State::submitted;
    impl_->context.run(commands);
    impl_->state = Impl::State::finished;
}

std::vector<double> Commands::times_ms() const {
    if (impl_->state != Impl::State::finished) {
        throw std::runtime_error("times of commands that have not been submitted and finished");
    }
    return impl_->handles->timestamps.read_ms(impl_->context);
}

}  // namespace gloam::gpu
