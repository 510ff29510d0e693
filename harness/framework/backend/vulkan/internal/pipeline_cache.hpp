// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "backend/vulkan/internal/vulkan.hpp"

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
    std::string loaded_;
    vk::raii::PipelineCache cache_;
};

// The fields of a pipeline cache's header that identify the driver.
struct DriverKey {
    std::uint32_t vendor = 0;
    std::uint32_t device = 0;
    std::array<std::uint8_t, 16> uuid{};
};

// Whether the blob begins with a complete header (VkPipelineCacheHeaderVersionOne) of this driver.
[[nodiscard]] bool is_pipeline_cache_of(std::span<const std::byte> blob, const DriverKey& driver);

}  // namespace gloam::gpu
