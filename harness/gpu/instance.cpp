// SPDX-License-Identifier: MIT
#include "gpu/internal/instance.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "gpu/internal/select.hpp"

namespace gloam::gpu {
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

vk::raii::Instance create(const vk::raii::Context& loader, const vk::InstanceCreateInfo& info) {
    try {
        return {loader, info};
    } catch (const vk::IncompatibleDriverError&) {
        throw std::runtime_error(no_device_message);
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
    switch (chain.get<vk::PhysicalDeviceDriverProperties>().driverID) {
        case vk::DriverId::eMesaLlvmpipe:
            return 1;
        case vk::DriverId::eGoogleSwiftshader:
            return 3;
        default:
            return 2;
    }
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

}  // namespace gloam::gpu
