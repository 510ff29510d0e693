// SPDX-License-Identifier: MIT
#include "backend/vulkan/commands.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

#include "backend/vulkan/internal/context.hpp"
#include "backend/vulkan/internal/objects.hpp"

namespace gloam::backend::vulkan {
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
    return {context.device, context.cache, info};
}

ComputePipeline::Handles create(Context& context, const ComputeProgram& program) {
    auto set_layout = make_set_layout(context, program.bindings, vk::ShaderStageFlagBits::eCompute);
    auto layout =
        make_layout(context, set_layout, vk::ShaderStageFlagBits::eCompute, program.push_constant_bytes);
    auto pipeline = make_pipeline(context, layout, program);
    return {context, program.bindings, std::move(set_layout), std::move(layout), std::move(pipeline)};
}

constexpr std::uint32_t queries_per_pool = 64;

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

// What a descriptor says of a resource.
using Info = std::variant<vk::DescriptorBufferInfo, vk::DescriptorImageInfo>;
struct InfoOf {
    const Context& context;

    static Info image(vk::ImageView view, vk::Sampler sampler) {
        return vk::DescriptorImageInfo{
            .sampler = sampler, .imageView = view, .imageLayout = vk::ImageLayout::eGeneral};
    }
    Info operator()(const Buffer& buffer) const {
        return vk::DescriptorBufferInfo{.buffer = *buffer.handles->buffer, .range = VK_WHOLE_SIZE};
    }
    Info operator()(const Image& all) const { return image(*all.handles->view, *context.sampler); }
    Info operator()(const SampledImage& all) const {
        return image(*all.handles->view, *all.handles->sampler);
    }
    Info operator()(const ImageLevel& one) const {
        return image(*one.image.get().handles->levels.at(one.level), {});
    }
    Info operator()(const LinearImage& all) const {
        return image(*all.image.get().handles->view, *context.linear);
    }
};

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

ComputePipeline::ComputePipeline(const Device& device, const ComputeProgram& program)
    : handles(owned(create(device.impl(), program))) {}

const std::vector<BindingKind>& ComputePipeline::bindings() const {
    return handles->bindings;
}

Commands::Commands(const Device& device)
    : handles(owned(Handles{.context = device.impl(), .buffers = begun(device.impl())})) {}

vk::DescriptorSet Commands::Handles::set_of(const vk::raii::DescriptorSetLayout& layout,
                                            std::span<const BindingKind> kinds,
                                            std::span<const Resource> resources) {
    std::vector<vk::DescriptorPoolSize> sizes;
    for (const BindingKind kind : kinds) sizes.push_back({.type = traits(kind).type, .descriptorCount = 1});
    pools.emplace_back(context.device, vk::DescriptorPoolCreateInfo{
                                           .flags = vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet,
                                           .maxSets = 1,
                                           .poolSizeCount = static_cast<std::uint32_t>(sizes.size()),
                                           .pPoolSizes = sizes.data()});
    vk::raii::DescriptorSets made(
        context.device,
        vk::DescriptorSetAllocateInfo{
            .descriptorPool = *pools.back(), .descriptorSetCount = 1, .pSetLayouts = &*layout});
    const vk::DescriptorSet set = *sets.emplace_back(std::move(made.front()));
    std::vector<Info> infos;
    for (const Resource& resource : resources) infos.push_back(std::visit(InfoOf{context}, resource));
    std::vector<vk::WriteDescriptorSet> writes;
    for (std::uint32_t i = 0; i < infos.size(); ++i)
        writes.push_back({.dstSet = set,
                          .dstBinding = i,
                          .descriptorCount = 1,
                          .descriptorType = traits(kinds[i]).type,
                          .pImageInfo = std::get_if<vk::DescriptorImageInfo>(&infos[i]),
                          .pBufferInfo = std::get_if<vk::DescriptorBufferInfo>(&infos[i])});
    context.device.updateDescriptorSets(writes, nullptr);
    return set;
}

void Commands::Handles::bind(const ComputePipeline& pipeline, std::span<const Resource> resources,
                             std::span<const std::byte> push_constants) {
    constexpr auto point = vk::PipelineBindPoint::eCompute;
    const auto& program = *pipeline.handles;
    const auto& commands = recording();
    commands.bindPipeline(point, *program.pipeline);
    if (!resources.empty()) {
        const auto set = set_of(program.set_layout, program.bindings, resources);
        commands.bindDescriptorSets(point, *program.layout, 0, set, nullptr);
    }
    if (!push_constants.empty())
        commands.pushConstants<std::byte>(*program.layout, vk::ShaderStageFlagBits::eCompute, 0,
                                          push_constants);
}

void Commands::dispatch(const ComputePipeline& pipeline, std::span<const Resource> resources,
                        std::array<std::uint32_t, 3> groups, std::span<const std::byte> push_constants) {
    check_groups(handles->context.physical.info, groups);
    handles->bind(pipeline, resources, push_constants);
    const auto& commands = handles->recording();
    commands.dispatch(groups[0], groups[1], groups[2]);
    device_barrier(commands);
}

void Commands::dispatch(const ComputePipeline& pipeline, std::span<const Resource> resources,
                        const Buffer& groups, std::uint32_t at, std::span<const std::byte> push_constants) {
    handles->bind(pipeline, resources, push_constants);
    const auto& commands = handles->recording();
    commands.dispatchIndirect(*groups.handles->buffer, at);
    device_barrier(commands);
}

std::size_t Commands::timestamp() {
    const auto& commands = handles->recording();
    if (handles->context.physical.timestamp_mask != 0) {
        const auto query = static_cast<std::uint32_t>(handles->readings % queries_per_pool);
        if (query == 0)
            commands.resetQueryPool(
                *handles->queries.emplace_back(handles->context.device,
                                               vk::QueryPoolCreateInfo{.queryType = vk::QueryType::eTimestamp,
                                                                       .queryCount = queries_per_pool}),
                0, queries_per_pool);
        commands.writeTimestamp(vk::PipelineStageFlagBits::eBottomOfPipe, *handles->queries.back(), query);
    }
    // lavapipe delays a dispatch until something waits for it. Without a barrier, the time of the work before
    // the reading would count after it. One that makes nothing visible suffices, and takes 3 us less of an
    // H200.
    constexpr auto all = vk::PipelineStageFlagBits::eAllCommands;
    commands.pipelineBarrier(all, all, {}, nullptr, nullptr, nullptr);
    return handles->readings++;
}

void Commands::submit() {
    const auto& commands = handles->recording();
    host_barrier(commands);
    commands.end();
    handles->context.run(commands);
}

std::vector<double> Commands::times_ms() const {
    const Physical& physical = handles->context.physical;
    std::vector<double> times(handles->readings, std::numeric_limits<double>::quiet_NaN());
    std::uint64_t start = 0;
    for (std::size_t first = 0; physical.timestamp_mask != 0 && first < times.size();
         first += queries_per_pool) {
        constexpr std::size_t tick = sizeof(std::uint64_t);
        const std::size_t count = std::min<std::size_t>(queries_per_pool, times.size() - first);
        const auto ticks = handles->queries[first / queries_per_pool]
                               .getResults<std::uint64_t>(0, static_cast<std::uint32_t>(count), count * tick,
                                                          tick, vk::QueryResultFlagBits::e64)
                               .second;
        if (first == 0) start = ticks[0];
        for (std::size_t i = 0; i < count; ++i) {
            // The clock may wrap around.
            const auto elapsed = static_cast<double>((ticks[i] - start) & physical.timestamp_mask);
            times[first + i] = elapsed * physical.info.timestamp_period_ns * 1e-6;
        }
    }
    return times;
}

}  // namespace gloam::backend::vulkan
