// SPDX-License-Identifier: MIT
#include "gpu/internal/descriptors.hpp"

#include <algorithm>
#include <array>

#include "gpu/internal/buffer_impl.hpp"
#include "gpu/internal/image_impl.hpp"

namespace gloam::gpu {
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
        } else {
            const Image& image = std::get<std::reference_wrapper<const Image>>(resources[i]);
            images[i] = vk::DescriptorImageInfo{.sampler = *context.sampler,
                                                .imageView = *image.impl().handles->view,
                                                .imageLayout = vk::ImageLayout::eGeneral};
            write.pImageInfo = &images[i];
        }
        writes.push_back(write);
    }
    context.device.updateDescriptorSets(writes, nullptr);
}

}  // namespace gloam::gpu
