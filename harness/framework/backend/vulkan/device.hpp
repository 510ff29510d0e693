// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "backend/backend.hpp"

namespace gloam::backend::vulkan {

using backend::DeviceInfo;
using backend::FloatControls;

// All devices that the Vulkan loader finds and that support Vulkan 1.2: hardware, then lavapipe, then other
// software, SwiftShader last. Empty when there is none.
// Throws std::runtime_error when there is no Vulkan loader or driver at all.
[[nodiscard]] std::vector<DeviceInfo> list_devices();

// The index in `devices` of the device that DeviceOptions::device selects. Throws std::runtime_error if there
// is no device, or if none matches (the message lists the existing ones).
[[nodiscard]] std::size_t select_device(std::span<const DeviceInfo> devices, std::string_view selector);

enum class Validation { off, on };

struct DeviceOptions {
    std::string
        device;  // index, or part of the name in any case; empty: the first GPU, else the first CPU device
    Validation validation = Validation::off;
    std::filesystem::path cache_directory;  // for compiled pipelines; empty: no cache
    // Longest wait for one submission, positive. It is longer if the driver computes on a processor that
    // others use as well (base::wait_patiently()).
    std::chrono::milliseconds timeout{60'000};
    // True: out-of-bounds accesses of a shader to its buffers are harmless. False: they are undefined, as in
    // engines without this feature; use it only for shaders without such accesses.
    bool robust_buffer_access = true;
    // Called with each validation message immediately, also with those during the device's destruction, which
    // take_validation_messages() cannot return. It may be called from any thread, but never from two at once.
    // It must not throw and must not use the device.
    std::function<void(const std::string&)> on_validation_message;
};

// An open Vulkan device with one queue, for one thread at a time. All objects made from it must be destroyed
// before it. Throws backend::Error; std::runtime_error if there is no device, if there is no device with that
// name (the message lists the existing ones), or if validation was requested and its layer is not installed;
// std::invalid_argument for a timeout that is not positive.
//
// While a submission that timed out still runs, further submissions throw. Vulkan forbids destroying objects
// in use, so destroyed objects are kept until the work has finished; then the device works as before. If the
// device is destroyed before that, it does not wait, because the work may never end: it leaks itself and the
// kept objects on purpose, as it does at the end of a process where it is static and validated. Otherwise its
// destructor writes the compiled pipelines to the cache directory.
class Device : public backend::Backend {
  public:
    explicit Device(const DeviceOptions& options = {});
    ~Device() override;

    [[nodiscard]] const DeviceInfo& info() const override;
    [[nodiscard]] std::unique_ptr<backend::Kernel> make_kernel(
        const backend::KernelProgram& program) const override;
    [[nodiscard]] std::vector<std::string> take_validation_messages() override;

    struct Impl;  // Vulkan handles; defined inside this room only
    [[nodiscard]] Impl& impl() const { return *impl_; }

  private:
    std::unique_ptr<Impl> impl_;
};

// Drivers that the Vulkan loader does not find by itself. A driver is specified by its manifest, a small JSON
// file with the path of the driver's library.

// The folders in which Chromium and Chrome keep SwiftShader, a Vulkan driver in software.
[[nodiscard]] std::vector<std::filesystem::path> swiftshader_folders();

// SwiftShader's manifest in the first of these folders that contains it together with its library.
[[nodiscard]] std::optional<std::filesystem::path> find_swiftshader(
    const std::vector<std::filesystem::path>& folders = swiftshader_folders());

// What the environment selects: VK_DRIVER_FILES or else VK_ICD_FILENAMES, and VK_ADD_DRIVER_FILES, where they
// are set, even if empty.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> chosen_drivers();

// Makes these the only drivers of list_devices() and Device, in this process and those that it starts, by
// environment variables of the Vulkan loader. Call it before anything else of this room, while there is only
// one thread. Throws std::runtime_error with the file's name if it is missing, is not a driver manifest, or
// its library is missing; then nothing has changed.
void choose_drivers(std::span<const std::filesystem::path> manifests);

// Adds find_swiftshader() to those that the Vulkan loader finds, unless there are chosen_drivers().
void add_swiftshader();

}  // namespace gloam::backend::vulkan
