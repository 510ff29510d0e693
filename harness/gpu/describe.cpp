// SPDX-License-Identifier: MIT
#include "gpu/internal/describe.hpp"

#include <algorithm>
#include <span>
#include <string>

#include "gpu/internal/fnv.hpp"
#include "gpu/internal/instance.hpp"

namespace gloam::gpu {
namespace {

std::string type_name(vk::PhysicalDeviceType type) {
    switch (type) {
        case vk::PhysicalDeviceType::eCpu:
            return "cpu";
        case vk::PhysicalDeviceType::eIntegratedGpu:
            return "integrated";
        case vk::PhysicalDeviceType::eDiscreteGpu:
            return "discrete";
        case vk::PhysicalDeviceType::eVirtualGpu:
            return "virtual";
        default:
            return "other";
    }
}

std::string version_text(std::uint32_t version) {
    return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                       VK_API_VERSION_PATCH(version));
}

// The driver's name and its own text, or its version if it has no text.
std::string driver_text(const vk::PhysicalDeviceProperties& properties,
                        const vk::PhysicalDeviceDriverProperties& driver) {
    const std::string info = driver.driverInfo;
    return fmt::format("{} {}", driver.driverName.data(),
                       info.empty() ? version_text(properties.driverVersion) : info);
}

// By the specification pipelineCacheUUID alone should suffice. Mesa's lavapipe has the same UUID and driver
// version 1 in every version; only its texts differ between versions of Mesa or LLVM.
std::string identity(const vk::PhysicalDeviceProperties& properties,
                     const vk::PhysicalDeviceDriverProperties& driver) {
    const auto texts = fmt::format("{}|{}", properties.deviceName.data(), driver_text(properties, driver));
    const auto& uuid = properties.pipelineCacheUUID;
    return fmt::format("{:08x}{:08x}{:08x}{:016x}{:02x}", properties.vendorID, properties.deviceID,
                       properties.driverVersion, fnv1a(std::as_bytes(std::span(texts))),
                       fmt::join(uuid.begin(), uuid.end(), ""));
}

FloatControls float_controls(const vk::PhysicalDeviceFloatControlsProperties& controls) {
    return {.preserves_signed_zero_inf_nan = controls.shaderSignedZeroInfNanPreserveFloat32 == VK_TRUE,
            .preserves_denormals = controls.shaderDenormPreserveFloat32 == VK_TRUE,
            .flushes_denormals = controls.shaderDenormFlushToZeroFloat32 == VK_TRUE,
            .rounds_to_even = controls.shaderRoundingModeRTEFloat32 == VK_TRUE,
            .rounds_to_zero = controls.shaderRoundingModeRTZFloat32 == VK_TRUE};
}

double timestamp_period(const vk::raii::PhysicalDevice& device, const vk::PhysicalDeviceLimits& limits) {
    const auto family = find_queue_family(device);
    const bool has_clock = family && device.getQueueFamilyProperties()[*family].timestampValidBits > 0;
    return has_clock ? static_cast<double>(limits.timestampPeriod) : 0.0;
}

}  // namespace

std::optional<std::uint32_t> find_queue_family(const vk::raii::PhysicalDevice& device) {
    const auto families = device.getQueueFamilyProperties();
    constexpr auto wanted = vk::QueueFlagBits::eGraphics | vk::QueueFlagBits::eCompute;
    const auto found = std::ranges::find_if(
        families, [&](const auto& family) { return (family.queueFlags & wanted) == wanted; });
    if (found == families.end()) return std::nullopt;
    return static_cast<std::uint32_t>(found - families.begin());
}

DeviceInfo describe(const vk::raii::PhysicalDevice& device, std::size_t index) {
    const auto chain =
        device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceMaintenance3Properties,
                              vk::PhysicalDeviceDriverProperties, vk::PhysicalDeviceSubgroupProperties,
                              vk::PhysicalDeviceFloatControlsProperties>();
    const auto& properties = chain.get<vk::PhysicalDeviceProperties2>().properties;
    const auto& driver = chain.get<vk::PhysicalDeviceDriverProperties>();
    const auto& limits = properties.limits;
    return {
        .index = index,
        .name = properties.deviceName,
        .type = type_name(properties.deviceType),
        .driver = driver_text(properties, driver),
        .api_version = version_text(properties.apiVersion),
        .identity = identity(properties, driver),
        .max_image_size =
            std::min({limits.maxImageDimension2D, limits.maxFramebufferWidth, limits.maxFramebufferHeight}),
        .max_buffer_bytes = std::min<std::uint64_t>(
            limits.maxStorageBufferRange,
            chain.get<vk::PhysicalDeviceMaintenance3Properties>().maxMemoryAllocationSize),
        .max_group_count = limits.maxComputeWorkGroupCount,
        .subgroup_size = chain.get<vk::PhysicalDeviceSubgroupProperties>().subgroupSize,
        .timestamp_period_ns = timestamp_period(device, limits),
        .float32 = float_controls(chain.get<vk::PhysicalDeviceFloatControlsProperties>()),
    };
}

std::vector<DeviceInfo> list_devices() {
    const auto loader = open_loader();
    const auto instance = create_instance(loader, nullptr);
    const auto devices = physical_devices(instance);
    std::vector<DeviceInfo> infos;
    for (const auto& device : devices) infos.push_back(describe(device, infos.size()));
    return infos;
}

}  // namespace gloam::gpu
