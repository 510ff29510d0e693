// SPDX-License-Identifier: MIT
#include "cli/pack/vulkan_names.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace gloam::cli {

std::string vulkan_format(gpu::Format format) {
    switch (format) {
        case gpu::Format::r32f:
            return "VK_FORMAT_R32_SFLOAT";
        case gpu::Format::rgba32f:
            return "VK_FORMAT_R32G32B32A32_SFLOAT";
        case gpu::Format::rgba16f:
            return "VK_FORMAT_R16G16B16A16_SFLOAT";
        case gpu::Format::rgba16ui:
            return "VK_FORMAT_R16G16B16A16_UINT";
        case gpu::Format::depth32f:
            return "VK_FORMAT_D32_SFLOAT";
        case gpu::Format::r16f:
            return "VK_FORMAT_R16_SFLOAT";
        case gpu::Format::r8:
            return "VK_FORMAT_R8_UNORM";
        case gpu::Format::r32ui:
            return "VK_FORMAT_R32_UINT";
    }
    throw std::logic_error("an image format without a name");
}

std::string vulkan_descriptor(shader::BindingType type) {
    switch (type) {
        case shader::BindingType::storage_image:
            return "VK_DESCRIPTOR_TYPE_STORAGE_IMAGE";
        case shader::BindingType::sampled_image:
            return "VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER";
        case shader::BindingType::texture:
            return "VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE";
        case shader::BindingType::sampler:
            return "VK_DESCRIPTOR_TYPE_SAMPLER";
        case shader::BindingType::storage_buffer:
            return "VK_DESCRIPTOR_TYPE_STORAGE_BUFFER";
        case shader::BindingType::uniform_buffer:
            return "VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER";
    }
    throw std::logic_error("a descriptor type without a name");
}

std::string to_string(effect::PlannedImage::Origin origin) {
    switch (origin) {
        case effect::PlannedImage::Origin::engine:
            return "engine";
        case effect::PlannedImage::Origin::history:
            return "kept";
        case effect::PlannedImage::Origin::once:
            return "once";
        case effect::PlannedImage::Origin::frame:
            return "frame";
    }
    throw std::logic_error("an origin without a name");
}

std::vector<std::string> vulkan_usage(const PackedEffect& effect, const effect::PlannedImage& image) {
    using Origin = effect::PlannedImage::Origin;
    std::set<std::string> names{image.name};  // with the one that it is exchanged with
    for (const auto& [a, b] : effect.plan.exchanged)
        if (a == image.name || b == image.name) names.insert({a, b});
    std::vector<std::string> usage;
    const auto add = [&usage](const char* bit) {
        const std::string name = std::string("VK_IMAGE_USAGE_") + bit + "_BIT";
        if (std::ranges::find(usage, name) == usage.end()) usage.push_back(name);
    };
    for (const PackedPass& pass : effect.passes) {
        for (const shader::Binding& binding : pass.interface.bindings)
            if (names.contains(resource_at(pass, binding)))
                add(binding.type == shader::BindingType::storage_image ? "STORAGE" : "SAMPLED");
    }
    for (const effect::PlannedImage& other : effect.plan.images)  // filled, or cleared
        if (names.contains(other.name) && (other.origin == Origin::engine || other.origin == Origin::history))
            add("TRANSFER_DST");
    if (names.contains(effect.plan.result) || names.contains(effect.plan.later_result)) add("TRANSFER_SRC");
    return usage;
}

}  // namespace gloam::cli
