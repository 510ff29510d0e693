// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "gpu/internal/compute_impl.hpp"

namespace gloam::gpu {

// Descriptor sets for one recording, from pools that are added on demand.
class DescriptorAllocator {
  public:
    // A set with this layout, which has the given number of bindings of each kind.
    [[nodiscard]] const vk::raii::DescriptorSet& allocate(const Context& context,
                                                          const vk::raii::DescriptorSetLayout& layout,
                                                          std::uint32_t buffers, std::uint32_t images);
    [[nodiscard]] const vk::raii::DescriptorSet& allocate(const ComputePipeline::Impl& pipeline);

  private:
    void add_pool(const Context& context, std::uint32_t buffers, std::uint32_t images);

    std::uint32_t sets_left_ = 0;
    std::uint32_t buffers_left_ = 0;
    std::uint32_t images_left_ = 0;
    std::vector<vk::raii::DescriptorPool> pools_;
    std::vector<vk::raii::DescriptorSet> sets_;  // declared after the pools, so that they are destroyed first
};

// Binds resources[i] to binding i of the set. Their kinds must be those of the set's layout.
void write_descriptors(const Context& context, const vk::raii::DescriptorSet& set,
                       std::span<const Resource> resources);

}  // namespace gloam::gpu
