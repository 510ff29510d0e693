// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "gpu/device.hpp"
#include "gpu/internal/vulkan.hpp"

namespace gloam::gpu {

// Keeps what the validation layers say. Layers may call from any thread.
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

// A Vulkan 1.2 instance. With a log, validation is on, and messages of creating and destroying the instance
// itself go to the log, which must live longer. Throws std::runtime_error: no driver, or the validation layer
// is not installed.
[[nodiscard]] vk::raii::Instance create_instance(const vk::raii::Context& loader, MessageLog* log);

// Sends the messages of everything between creating and destroying the instance to the log.
[[nodiscard]] vk::raii::DebugUtilsMessengerEXT create_messenger(const vk::raii::Instance& instance,
                                                                MessageLog& log);

// Vulkan 1.2 devices: hardware first, then lavapipe, then other software, SwiftShader last, and within these
// in the loader's order. DeviceInfo::index counts through them.
[[nodiscard]] std::vector<vk::raii::PhysicalDevice> physical_devices(const vk::raii::Instance& instance);

}  // namespace gloam::gpu
