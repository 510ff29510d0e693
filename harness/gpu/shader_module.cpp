// SPDX-License-Identifier: MIT
#include "gpu/internal/shader_module.hpp"

#include <stdexcept>

namespace gloam::gpu {

vk::raii::ShaderModule make_module(const Context& context, std::span<const std::uint32_t> spirv) {
    constexpr std::size_t header_words = 5;
    constexpr std::uint32_t magic = 0x07230203;
    if (spirv.size() <= header_words || spirv[0] != magic) {
        throw std::invalid_argument(
            fmt::format("not a SPIR-V module: {} words, the first {:#010x}, expected {:#010x}", spirv.size(),
                        spirv.empty() ? 0u : spirv[0], magic));
    }
    return {context.device,
            vk::ShaderModuleCreateInfo{.codeSize = spirv.size_bytes(), .pCode = spirv.data()}};
}

void check_push_constant_size(const Context& context, std::uint32_t bytes) {
    const auto limit = context.physical.properties.limits.maxPushConstantsSize;
    if (bytes % 4 != 0 || bytes > limit) {
        throw std::invalid_argument(
            fmt::format("{} bytes of push constants: device \"{}\" allows multiples of 4 up to {}", bytes,
                        context.physical.info.name, limit));
    }
}

}  // namespace gloam::gpu
