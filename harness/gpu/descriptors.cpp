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
    const auto count = [&](BindingKind kind) {
        return static_cast<std::uint32_t>(std::ranges::count(pipeline.bindings, kind));
    };
    return allocate(pipeline.context, pipeline.handles->set_layout, count(BindingKind::storage_buffer),
                    count(BindingKind::storage_image));
}

const vk::raii::DescriptorSet& DescriptorAllocator::allocate(const Context& context,
                                                             const vk::raii::DescriptorSetLayout& layout,
                                                             std::uint32_t buffers, std::uint32_t images) {
    if (sets_left_ == 0 || buffers_left_ < buffers || images_left_ < images) {
        add_pool(context, buffers, images);
    }
    vk::raii::DescriptorSets sets(
        context.device,
        vk::DescriptorSetAllocateInfo{
            .descriptorPool = *pools_.back(), .descriptorSetCount = 1, .pSetLayouts = &*layout});
    sets_left_ -= 1;
    buffers_left_ -= buffers;
    images_left_ -= images;
    return sets_.emplace_back(std::move(sets.front()));
}

void DescriptorAllocator::add_pool(const Context& context, std::uint32_t buffers, std::uint32_t images) {
    sets_left_ = sets_per_pool;
    buffers_left_ = std::max(buffers, descriptors_per_pool);
    images_left_ = std::max(images, descriptors_per_pool);
    const std::array sizes{
        vk::DescriptorPoolSize{.type = vk::DescriptorType::eStorageBuffer, .descriptorCount = buffers_left_},
        vk::DescriptorPoolSize{.type = vk::DescriptorType::eStorageImage, .descriptorCount = images_left_}};
    pools_.emplace_back(context.device, vk::DescriptorPoolCreateInfo{
                                            .flags = vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet,
                                            .maxSets = sets_left_,
                                            .poolSizeCount = sizes.size(),
                                            .pPoolSizes = sizes.data()});
}

void write_descriptors(const Context& context, const vk::raii::DescriptorSet& set,
                       std::span<const Resource> resources) {
    std::vector<vk::DescriptorBufferInfo> buffers(resources.size());
    std::vector<vk::DescriptorImageInfo> images(resources.size());
    std::vector<vk::WriteDescriptorSet> writes;
    for (std::uint32_t i = 0; i < resources.size(); ++i) {
        vk::WriteDescriptorSet write{.dstSet = *set, .dstBinding = i, .descriptorCount = 1};
        if (const auto* buffer = std::get_if<std::reference_wrapper<const Buffer>>(&resources[i])) {
            buffers[i] = vk::DescriptorBufferInfo{.buffer = *buffer->get().impl().handles->buffer,
                                                  .range = VK_WHOLE_SIZE};
            write.descriptorType = vk::DescriptorType::eStorageBuffer;
            write.pBufferInfo = &buffers[i];
        } else {
            const Image& image = std::get<std::reference_wrapper<const Image>>(resources[i]);
            images[i] = vk::DescriptorImageInfo{.imageView = *image.impl().handles->view,
                                                .imageLayout = vk::ImageLayout::eGeneral};
            write.descriptorType = vk::DescriptorType::eStorageImage;
            write.pImageInfo = &images[i];
        }
        writes.push_back(write);
    }
    context.device.updateDescriptorSets(writes, nullptr);
}

}  // namespace gloam::gpu
