// SPDX-License-Identifier: MIT
#include "gpu/internal/pipeline_cache.hpp"

#include <algorithm>
#include <span>

#include "gpu/internal/cache_file.hpp"
#include "gpu/internal/cache_header.hpp"

namespace gloam::gpu {
namespace {

std::vector<std::byte> load(const std::filesystem::path& file,
                            const vk::PhysicalDeviceProperties& properties) {
    if (file.empty()) return {};
    auto blob = read_cache_file(file);
    const DriverKey driver{properties.vendorID, properties.deviceID, properties.pipelineCacheUUID};
    if (!is_pipeline_cache_of(blob, driver)) blob.clear();
    return blob;
}

std::filesystem::path file_in(const std::filesystem::path& directory, const std::string& identity) {
    return directory.empty() ? std::filesystem::path{} : directory / ("pipelines-" + identity + ".bin");
}

// SwiftShader returns the data that it was given behind one more header, so its file would grow with every
// use.
bool is_news(std::span<const std::byte> data, std::span<const std::byte> loaded) {
    if (std::ranges::equal(data, loaded)) return false;
    const bool one_header_more =
        !loaded.empty() && data.size() == loaded.size() + sizeof(VkPipelineCacheHeaderVersionOne);
    return !(one_header_more && std::ranges::equal(data.last(loaded.size()), loaded));
}

}  // namespace

PipelineCache::PipelineCache(const vk::raii::Device& device, const vk::PhysicalDeviceProperties& properties,
                             const std::filesystem::path& directory, const std::string& identity)
    : file_(file_in(directory, identity)),
      loaded_(load(file_, properties)),
      cache_(device,
             vk::PipelineCacheCreateInfo{.initialDataSize = loaded_.size(), .pInitialData = loaded_.data()}) {
}

void PipelineCache::save() const noexcept {
    if (file_.empty()) return;
    try {
        const auto data = cache_.getData();
        const auto bytes = std::as_bytes(std::span(data));
        if (is_news(bytes, loaded_)) write_cache_file(file_, bytes);
    } catch (...) {
        // On failure the next process compiles again.
    }
}

}  // namespace gloam::gpu
