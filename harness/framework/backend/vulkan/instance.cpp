// SPDX-License-Identifier: MIT
#include "backend/vulkan/internal/instance.hpp"

#include <fmt/ranges.h>
#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <utility>

#include "backend/shader_cache.hpp"
#include "base/cached_file.hpp"
#include "base/number.hpp"
#include "base/text.hpp"

namespace gloam::backend::vulkan {
namespace {

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";

// Vulkan calls this from C, so it must not throw.
VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                          VkDebugUtilsMessageTypeFlagsEXT,
                                          const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    try {
        static_cast<MessageLog*>(user)->add(data->pMessage);
    } catch (...) {
    }
    return VK_FALSE;
}

bool has_validation_layer(const vk::raii::Context& loader) {
    return std::ranges::any_of(loader.enumerateInstanceLayerProperties(), [](const auto& layer) {
        return std::string_view(layer.layerName) == validation_layer;
    });
}

bool layer_has_extension(const vk::raii::Context& loader, std::string_view name) {
    const auto extensions = loader.enumerateInstanceExtensionProperties(std::string(validation_layer));
    return std::ranges::any_of(
        extensions, [&](const auto& extension) { return std::string_view(extension.extensionName) == name; });
}

// Ignored: "general" messages, in which the loader reports skipped drivers, and "performance" messages, which
// criticise the general image layout that keeps this room simple.
vk::DebugUtilsMessengerCreateInfoEXT messenger_info(MessageLog& log) {
    // The C structure, because the callback's type in the C++ structure depends on the version of the
    // headers.
    vk::DebugUtilsMessengerCreateInfoEXT info;
    info = VkDebugUtilsMessengerCreateInfoEXT{
        .sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT,
        .messageSeverity =
            VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT,
        .messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT,
        .pfnUserCallback = on_message,
        .pUserData = &log};
    return info;
}

std::string no_device() {
    std::string text(no_device_message);
    for (const auto& [variable, value] : chosen_drivers())
        text += fmt::format("; {} names the drivers \"{}\"", variable, value);
    return text;
}

vk::raii::Instance create(const vk::raii::Context& loader, const vk::InstanceCreateInfo& info) {
    try {
        return {loader, info};
    } catch (const vk::IncompatibleDriverError&) {
        throw std::runtime_error(no_device());
    } catch (const vk::OutOfHostMemoryError&) {  // older loaders, of a manifest that is no JSON
        if (chosen_drivers().empty()) throw;
        throw std::runtime_error(no_device());
    }
}

vk::raii::Instance create_validated(const vk::raii::Context& loader, vk::InstanceCreateInfo info,
                                    MessageLog& log) {
    if (!has_validation_layer(loader)) {
        throw std::runtime_error(fmt::format(
            "validation layer {} not found: install the package vulkan-validationlayers", validation_layer));
    }
    // Chained to the instance, it reports only while the instance is created and destroyed.
    auto messenger = messenger_info(log);
    std::vector<const char*> extensions{VK_EXT_DEBUG_UTILS_EXTENSION_NAME};
    const auto synchronization = vk::ValidationFeatureEnableEXT::eSynchronizationValidation;
    const vk::ValidationFeaturesEXT features{.enabledValidationFeatureCount = 1,
                                             .pEnabledValidationFeatures = &synchronization};
    if (layer_has_extension(loader, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME)) {
        extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
        messenger.pNext = &features;
    }
    info.pNext = &messenger;
    info.enabledLayerCount = 1;
    info.ppEnabledLayerNames = &validation_layer;
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    return create(loader, info);
}

// The loader lists added drivers before those of the system.
int rank(const vk::raii::PhysicalDevice& device) {
    if (device.getProperties().deviceType != vk::PhysicalDeviceType::eCpu) return 0;
    const auto chain =
        device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
    const vk::DriverId driver = chain.get<vk::PhysicalDeviceDriverProperties>().driverID;
    if (driver == vk::DriverId::eMesaLlvmpipe) return 1;
    return driver == vk::DriverId::eGoogleSwiftshader ? 3 : 2;
}

// Real GPUs first, in any order; software last.
std::size_t default_device(std::span<const DeviceInfo> devices) {
    const auto rank = [](const DeviceInfo& device) {
        constexpr std::array<std::string_view, 4> order{"discrete", "integrated", "virtual", "cpu"};
        const auto found = std::ranges::find(order, device.type);
        return std::max<std::ptrdiff_t>(found - order.begin(), 1);  // discrete and integrated alike
    };
    return static_cast<std::size_t>(std::ranges::min_element(devices, {}, rank) - devices.begin());
}

std::optional<std::size_t> by_index(std::span<const DeviceInfo> devices, std::string_view digits) {
    const auto index = base::number_from<std::size_t>(digits);
    return index && *index < devices.size() ? index : std::nullopt;
}

std::optional<std::size_t> by_name(std::span<const DeviceInfo> devices, std::string_view part) {
    auto found = std::ranges::find(devices, part, &DeviceInfo::name);
    if (found == devices.end())
        found = std::ranges::find_if(devices,
                                     [wanted = base::lower(std::string(part))](const DeviceInfo& device) {
                                         return base::lower(device.name).find(wanted) != std::string::npos;
                                     });
    if (found == devices.end()) return std::nullopt;
    return static_cast<std::size_t>(found - devices.begin());
}

std::string listing(std::span<const DeviceInfo> devices) {
    std::string text;
    for (const auto& device : devices) {
        text +=
            fmt::format("{}{} \"{}\" ({})", text.empty() ? "" : ", ", device.index, device.name, device.type);
    }
    return text;
}

std::string type_name(vk::PhysicalDeviceType type) {
    using enum vk::PhysicalDeviceType;
    static const std::map<vk::PhysicalDeviceType, const char*> names{
        {eCpu, "cpu"}, {eIntegratedGpu, "integrated"}, {eDiscreteGpu, "discrete"}, {eVirtualGpu, "virtual"}};
    const auto found = names.find(type);
    return found == names.end() ? "other" : found->second;
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
                       properties.driverVersion, base::hash_of(texts)[0],
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

bool filters_depth(const vk::raii::PhysicalDevice& device) {
    return static_cast<bool>(device.getFormatProperties(vk::Format::eD32Sfloat).optimalTilingFeatures &
                             vk::FormatFeatureFlagBits::eSampledImageFilterLinear);
}

}  // namespace

void MessageLog::add(std::string message) {
    std::ranges::replace(message, '\n', ' ');
    const std::lock_guard lock(mutex_);
    if (listener_) listener_(message);
    messages_.push_back(std::move(message));
}

std::vector<std::string> MessageLog::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(messages_, {});
}

vk::raii::Context open_loader() {
    try {
        return {};
    } catch (const std::runtime_error&) {
        throw std::runtime_error(
            "no Vulkan loader found: install libvulkan1 and a Vulkan driver, for example "
            "mesa-vulkan-drivers");
    }
}

vk::raii::Instance create_instance(const vk::raii::Context& loader, MessageLog* log) {
    backend::spare_a_full_disk();
    const vk::ApplicationInfo application{.pApplicationName = "gloam", .apiVersion = VK_API_VERSION_1_2};
    const vk::InstanceCreateInfo info{.pApplicationInfo = &application};
    return log ? create_validated(loader, info, *log) : create(loader, info);
}

vk::raii::DebugUtilsMessengerEXT create_messenger(const vk::raii::Instance& instance, MessageLog& log) {
    return {instance, messenger_info(log)};
}

std::vector<vk::raii::PhysicalDevice> physical_devices(const vk::raii::Instance& instance) {
    std::vector<vk::raii::PhysicalDevice> devices;
    try {
        for (auto& device : vk::raii::PhysicalDevices(instance)) {
            if (device.getProperties().apiVersion >= VK_API_VERSION_1_2) devices.push_back(std::move(device));
        }
    } catch (const vk::InitializationFailedError&) {
        // The loader's error code if drivers are installed but find no hardware.
    }
    std::ranges::stable_sort(devices, {}, rank);
    return devices;
}

std::size_t select_device(std::span<const DeviceInfo> devices, std::string_view selector) {
    if (devices.empty()) throw std::runtime_error(no_device());
    if (selector.empty()) return default_device(devices);
    const bool is_index = selector.find_first_not_of("0123456789") == std::string_view::npos;
    const auto found = is_index ? by_index(devices, selector) : by_name(devices, selector);
    if (!found) {
        throw std::runtime_error(
            fmt::format("no Vulkan device \"{}\"; there are: {}", selector, listing(devices)));
    }
    return *found;
}

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
        .samplers = {.subtexel_bits = limits.subTexelPrecisionBits,
                     .level_bits = limits.mipmapPrecisionBits,
                     .filters_depth = filters_depth(device)},
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

}  // namespace gloam::backend::vulkan
