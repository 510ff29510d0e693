// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "gpu/internal/vulkan.hpp"

namespace gloam::gpu {

// The driver's compiled pipelines, one file for each device identity. A damaged file, or one of another
// driver, is never passed to the driver: it counts as empty and is replaced.
class PipelineCache {
  public:
    // directory: empty: no cache.
    PipelineCache(const vk::raii::Device& device, const vk::PhysicalDeviceProperties& properties,
                  const std::filesystem::path& directory, const std::string& identity);

    // For pipeline creation.
    [[nodiscard]] const vk::raii::PipelineCache& handle() const { return cache_; }

    // Writes the file if it would contain more than the loaded one. A failure only costs time in the next
    // run.
    void save() const noexcept;

  private:
    std::filesystem::path file_;
    std::vector<std::byte> loaded_;
    vk::raii::PipelineCache cache_;
};

}  // namespace gloam::gpu
