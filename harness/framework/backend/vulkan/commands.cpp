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

ComputePipeline::Handles create(Context& context, const ComputeProgram& program) {
    auto set_layout = make_set_layout(context, program.bindings, vk::ShaderStageFlagBits::eCompute);
    auto layout =
        make_layout(context, set_layout, vk::ShaderStageFlagBits::eCompute, program.push_constant_bytes);
    auto pipeline = make_pipeline(context, layout, program);
    return {context,
            {{program.spirv.begin(), program.spirv.end()}, program.constants, program.bindings},
            std::move(set_layout),
            std::move(layout),
            std::move(pipeline)};
}

struct Kind {
    vk::DescriptorType type;
    const char* name;
};

Kind traits(BindingKind kind) {
    static constexpr std::array kinds{Kind{vk::DescriptorType::eStorageBuffer, "storage buffer"},
                                      Kind{vk::DescriptorType::eStorageImage, "storage image"},
                                      Kind{vk::DescriptorType::eCombinedImageSampler, "sampled image"},
                                      Kind{vk::DescriptorType::eUniformBuffer, "uniform buffer"}};
    return kinds.at(static_cast<std::size_t>(kind));
}

void check_count(const Context& context, std::span<const BindingKind> kinds, BindingKind kind,
                 std::uint32_t limit) {
    const auto count = std::ranges::count(kinds, kind);
    if (count > limit) {
        throw std::invalid_argument(fmt::format("pipeline with {} {} bindings: device \"{}\" allows {}",
                                                count, traits(kind).name, context.physical.info.name, limit));
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
                            .descriptorType = traits(kinds[i]).type,
                            .descriptorCount = 1,
                            .stageFlags = stages});
    return {context.device,
            vk::DescriptorSetLayoutCreateInfo{.bindingCount = static_cast<std::uint32_t>(bindings.size()),
                                              .pBindings = bindings.data()}};
}

const PipelineProgram& program_of(const ComputePipeline& pipeline) {
    return pipeline.handles().program;
}

ComputePipeline::ComputePipeline(const Device& device, const ComputeProgram& program)
    : handles_(owned(create(device.impl(), program))) {}

namespace {

constexpr std::uint32_t sets_per_pool = 64;
constexpr std::uint32_t descriptors_per_pool = 256;  // of each kind

}  // namespace

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
        sizes[kind] = {.type = traits(static_cast<BindingKind>(kind)).type, .descriptorCount = left_[kind]};
    }
    pools_.emplace_back(context.device, vk::DescriptorPoolCreateInfo{
                                            .flags = vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet,
                                            .maxSets = sets_left_,
                                            .poolSizeCount = sizes.size(),
                                            .pPoolSizes = sizes.data()});
}

namespace {

// What a descriptor says of a resource.
using Info = std::variant<vk::DescriptorBufferInfo, vk::DescriptorImageInfo>;
struct InfoOf {
    const Context& context;

    static Info image(vk::ImageView view, vk::Sampler sampler) {
        return vk::DescriptorImageInfo{
            .sampler = sampler, .imageView = view, .imageLayout = vk::ImageLayout::eGeneral};
    }
    Info operator()(const Buffer& buffer) const {
        return vk::DescriptorBufferInfo{.buffer = *buffer.handles().buffer, .range = VK_WHOLE_SIZE};
    }
    Info operator()(const Image& all) const { return image(*all.handles().view, *context.sampler); }
    Info operator()(const SampledImage& all) const {
        return image(*all.handles().view, *all.handles().sampler);
    }
    Info operator()(const LayeredImage& all) const { return image(*all.handles().view, {}); }
    Info operator()(const ImageLevel& one) const {
        return image(*one.image.get().handles().levels.at(one.level), {});
    }
    Info operator()(const LinearImage& all) const {
        return image(*all.image.get().handles().view, *context.linear);
    }
};

}  // namespace

void write_descriptors(const Context& context, const vk::raii::DescriptorSet& set,
                       std::span<const BindingKind> bindings, std::span<const Resource> resources) {
    std::vector<Info> infos;
    for (const Resource& resource : resources) infos.push_back(std::visit(InfoOf{context}, resource));
    std::vector<vk::WriteDescriptorSet> writes;
    for (std::uint32_t i = 0; i < infos.size(); ++i)
        writes.push_back({.dstSet = *set,
                          .dstBinding = i,
                          .descriptorCount = 1,
                          .descriptorType = traits(bindings[i]).type,
                          .pImageInfo = std::get_if<vk::DescriptorImageInfo>(&infos[i]),
                          .pBufferInfo = std::get_if<vk::DescriptorBufferInfo>(&infos[i])});
    context.device.updateDescriptorSets(writes, nullptr);
}

namespace {

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

const vk::raii::CommandBuffer& Commands::Handles::recording() const {
    if (state != State::recording) throw std::runtime_error("these commands were submitted: record new ones");
    return buffers.front();
}

Commands::Commands(const Device& device)
    : handles_(owned(Handles{.context = device.impl(), .buffers = begun(device.impl())})) {}

void Commands::Handles::bind(const ComputePipeline& pipeline, std::span<const Resource> resources,
                             std::span<const std::byte> push_constants) {
    constexpr auto point = vk::PipelineBindPoint::eCompute;
    const auto& program = pipeline.handles();
    const auto& commands = recording();
    commands.bindPipeline(point, *program.pipeline);
    if (!resources.empty()) {
        const auto& set = descriptors.allocate(program.context, program.set_layout, program.program.bindings);
        write_descriptors(program.context, set, program.program.bindings, resources);
        commands.bindDescriptorSets(point, *program.layout, 0, *set, nullptr);
    }
    if (!push_constants.empty())
        commands.pushConstants<std::byte>(*program.layout, vk::ShaderStageFlagBits::eCompute, 0,
                                          push_constants);
}

void Commands::dispatch(const ComputePipeline& pipeline, std::span<const Resource> resources,
                        std::array<std::uint32_t, 3> groups, std::span<const std::byte> push_constants) {
    check_groups(handles_->context.physical.info, groups);
    handles_->bind(pipeline, resources, push_constants);
    const auto& commands = handles_->recording();
    commands.dispatch(groups[0], groups[1], groups[2]);
    device_barrier(commands);
}

void Commands::dispatch(const ComputePipeline& pipeline, std::span<const Resource> resources,
                        const Buffer& groups, std::uint32_t at, std::span<const std::byte> push_constants) {
    handles_->bind(pipeline, resources, push_constants);
    const auto& commands = handles_->recording();
    commands.dispatchIndirect(*groups.handles().buffer, at);
    device_barrier(commands);
}

std::size_t Commands::timestamp() {
    const auto& commands = handles_->recording();
    const std::size_t position = handles_->timestamps.record(handles_->context, commands);
    // lavapipe delays a dispatch until something waits for it. Without a barrier, the time of the work before
    // the reading would count after it. One that makes nothing visible suffices, and takes 3 us less of an
    // H200.
    constexpr auto all = vk::PipelineStageFlagBits::eAllCommands;
    commands.pipelineBarrier(all, all, {}, nullptr, nullptr, nullptr);
    return position;
}

void Commands::submit() {
    const auto& commands = handles_->recording();
    host_barrier(commands);
    commands.end();
    handles_->state = Handles::State::submitted;
    handles_->context.run(commands);
    handles_->state = Handles::State::finished;
}

std::vector<double> Commands::times_ms() const {
    if (handles_->state != Handles::State::finished) {
        throw std::runtime_error("times of commands that have not been submitted and finished");
    }
    return handles_->timestamps.read_ms(handles_->context);
}

}  // namespace gloam::gpu
