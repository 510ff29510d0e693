// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "backend/vulkan/device.hpp"
#include "backend/vulkan/internal/vulkan.hpp"

namespace gloam::backend::vulkan {

// Collects the messages of the validation layers. Layers may call it from any thread.
class MessageLog {
  public:
    explicit MessageLog(std::function<void(const std::string&)> listener = {})
        : listener_(std::move(listener)) {}

    void add(std::string message);
    [[nodiscard]] std::vector<std::string> take();

  private:
    std::function<void(const std::string&)> listener_;
    std::mutex mutex_;
    std::vector<std::string> messages_;
};

// The loader. Throws std::runtime_error when libvulkan is not installed.
[[nodiscard]] vk::raii::Context open_loader();

// A Vulkan 1.2 instance. With a log, validation is on; the messages of the instance's own creation and
// destruction go to the log, which must outlive the instance. Throws std::runtime_error if there is no
// driver, or the validation layer is not installed.
[[nodiscard]] vk::raii::Instance create_instance(const vk::raii::Context& loader, MessageLog* log);

// Sends all messages between the instance's creation and destruction to the log.
[[nodiscard]] vk::raii::DebugUtilsMessengerEXT create_messenger(const vk::raii::Instance& instance,
                                                                MessageLog& log);

// The Vulkan 1.2 devices: hardware, then lavapipe, then other software, SwiftShader last; devices of one kind
// in the loader's order. DeviceInfo::index is an index into them.
[[nodiscard]] std::vector<vk::raii::PhysicalDevice> physical_devices(const vk::raii::Instance& instance);

// The first queue family for both graphics and compute.
[[nodiscard]] std::optional<std::uint32_t> find_queue_family(const vk::raii::PhysicalDevice& device);

// How the message begins if there is no usable driver; it is one line.
inline constexpr std::string_view no_device_message =
    "no Vulkan device found: install a Vulkan driver, for example mesa-vulkan-drivers; checks run without "
    "one "
    "with --device interpreter";

// The properties of a device. `index`: copied to the result.
[[nodiscard]] DeviceInfo describe(const vk::raii::PhysicalDevice& device, std::size_t index);

}  // namespace gloam::backend::vulkan
