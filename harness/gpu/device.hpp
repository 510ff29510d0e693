// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace gloam::gpu {

// What a driver reports of float32 arithmetic (VkPhysicalDeviceFloatControlsProperties).
struct FloatControls {
    bool preserves_signed_zero_inf_nan = false;
    bool preserves_denormals = false;
    bool flushes_denormals = false;
    bool rounds_to_even = false;
    bool rounds_to_zero = false;
};

// One Vulkan device, as it describes itself. `index` is its position in list_devices().
struct DeviceInfo {
    std::size_t index = 0;
    std::string name;         // "llvmpipe (LLVM 15.0.6, 256 bits)"
    std::string type;         // "cpu", "integrated", "discrete", "virtual" or "other"
    std::string driver;       // driver name and its own version text (or, where it has none, its version)
    std::string api_version;  // "1.3.230"
    std::string identity;     // hexadecimal; changes whenever a compiled pipeline can no longer be used
    std::uint32_t max_image_size = 0;  // pixels, each side of a 2-D image
    std::uint64_t max_buffer_bytes = 0;
    std::array<std::uint32_t, 3> max_group_count{};
    std::uint32_t subgroup_size = 0;
    double timestamp_period_ns = 0.0;  // 0: the device has no timestamps
    FloatControls float32;
};

// All devices that the Vulkan loader finds and that support Vulkan 1.2: hardware, then lavapipe, then other
// software, SwiftShader last. Empty when there is none.
// Throws std::runtime_error when there is no Vulkan loader or driver at all.
[[nodiscard]] std::vector<DeviceInfo> list_devices();

enum class Validation { off, on };

struct DeviceOptions {
    std::string
        device;  // index, or part of the name in any case; empty: the first GPU, else the first CPU device
    Validation validation = Validation::off;
    std::filesystem::path cache_directory;  // where compiled pipelines are kept; empty: nowhere
    // Longest wait for one submission, positive; longer where the driver computes on a processor that others
    // use, too (base::Patience).
    std::chrono::milliseconds timeout{60'000};
    // On: a shader that reaches past its buffers harms nothing. Off: that is undefined, as in engines that
    // leave it off; only for shaders that do not.
    bool robust_buffer_access = true;
    // Called with each validation message as it comes, also with those of closing the device, when nobody can
    // ask for them any more. May be called from any thread, never from two at once; must not throw nor call
    // back into the device.
    std::function<void(const std::string&)> on_validation_message;
};

// An open Vulkan device with one queue, for use from one thread at a time. Everything made from it must die
// before it. Throws std::runtime_error: no device, no device of that name (the message lists those there
// are), validation asked for and its layer not installed; std::invalid_argument: a timeout that is not
// positive.
//
// While a submission that timed out still runs, further submissions throw, and what is destroyed is only put
// aside, for Vulkan forbids destroying what may be in use: once the work has finished, all is as before. A
// device that is closed before that does not wait, since that might be for ever: it is leaked, on purpose,
// with all that was put aside. Otherwise, closing writes the compiled pipelines to the cache directory.
class Device {
  public:
    explicit Device(const DeviceOptions& options = {});
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    [[nodiscard]] const DeviceInfo& info() const;

    // Messages of the validation layers (warnings and errors, one line each) since the last call, oldest
    // first.
    [[nodiscard]] std::vector<std::string> take_validation_messages();

    struct Impl;  // Vulkan handles; defined inside this room only
    [[nodiscard]] Impl& impl() const { return *impl_; }

  private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace gloam::gpu
