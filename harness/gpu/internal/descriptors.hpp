// SPDX-License-Identifier: MIT
#pragma once

#include <array>
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
                                                          std::span<const BindingKind> bindings);
    [[nodiscard]] const vk::raii::DescriptorSet& allocate(const ComputePipeline::Impl& pipeline);

  private:
    using Counts = std::array<std::uint32_t, binding_kinds>;  // of descriptors, by kind
    void add_pool(const Context& context, const Counts& needed);

    std::uint32_t sets_left_ = 0;
    Counts left_{};
    std::vector<vk::raii::DescriptorPool> pools_;
    std::vector<vk::raii::DescriptorSet> sets_;  // declared after the pools, so that they are destroyed first
};

// Binds resources[i] to binding i of the set. bindings: the kinds of the set's layout, which the resources
// fit.
void write_descriptors(const Context& context, const vk::raii::DescriptorSet& set,
                       std::span<const BindingKind> bindings, std::span<const Resource> resources);

}  // namespace gloam::gpu
