// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "backend/vulkan/device.hpp"
#include "cli/commands.hpp"
#include "judge/answer.hpp"
#include "record/members.hpp"

namespace gloam::cli {

// Opens the device of --device and --validation; pipelines are cached. Throws like backend::vulkan::Device.
[[nodiscard]] backend::vulkan::Device open_device(const std::string& name, bool validation);

// Prints the validation messages since the last call. Returns the exit status: 0 without messages, else 1.
[[nodiscard]] int validation_status(backend::vulkan::Device& device);

// --driver of a command that opens devices. Before the command runs, the Vulkan loader gets the manifests of
// these drivers alone; without any, a browser's SwiftShader besides its own, unless the environment chooses
// the drivers itself. A driver without a device is an error.
[[nodiscard]] Option driver_option();

// What another process said that listed devices.
struct Listing {
    std::vector<backend::DeviceInfo> devices;
    std::string error;                           // why there are none
    judge::Reason reason = judge::Reason::none;  // crash, hang: it ended, or was ended, without a word
};

// What each executor of OpenGL and OpenGL ES has (backend/gl/device.hpp), by its name. Each is opened in a
// process of its own: what a driver does to that costs no more than its devices.
[[nodiscard]] std::vector<std::pair<std::string, Listing>> list_opengl();

// The names of all OpenGL devices. Throws std::runtime_error that says why where there is none.
[[nodiscard]] std::vector<std::string> gl_device_names();

// A Vulkan driver that crashes, exits or hangs while it loads: its listing says why there are no devices.
struct BrokenDriver : Listing {
    std::filesystem::path manifest;
};

struct Drivers : Listing {
    std::vector<BrokenDriver> broken;
};

// Lists the Vulkan devices. Where that ends the process that does it, each driver is tried alone, and broken
// ones are left out in this process and in those that it starts, if another has a device. Call it while there
// is only one thread. Throws std::runtime_error that names a driver of --driver without a device.
[[nodiscard]] Drivers load_drivers();

// The same for commands that need one device: names the broken drivers on standard error. Throws
// std::runtime_error if only they have devices.
void require_good_drivers();

// "gloam: Vulkan driver FILE: its process ended ...; it is skipped", on standard error.
void say_skipped(const BrokenDriver& driver);

// What stands before a program's name, so that the Vulkan loader finds this device as it does here:
// "VK_DRIVER_FILES=FILE ", or nothing.
[[nodiscard]] std::string loader_words(const std::string& device, const std::string& manifest);

// Its one line of JSON, without the reason; a device as `gloam devices --json` shows it.
GLOAM_MEMBERS(Listing, devices, error)

}  // namespace gloam::cli

namespace gloam::backend {

template <class Io>
void members(Io& io, FloatControls& float32) {
    record::each(io, "signed_zero_inf_nan_preserve", float32.preserves_signed_zero_inf_nan, "denorm_preserve",
                 float32.preserves_denormals, "denorm_flush_to_zero", float32.flushes_denormals,
                 "rounding_mode_rte", float32.rounds_to_even, "rounding_mode_rtz", float32.rounds_to_zero);
}

template <class Io>
void members(Io& io, DeviceInfo& d) {
    record::each(io, "index", d.index, "name", d.name);
    io.member("manifest", d.manifest, record::Present::if_any);
    record::each(io, "type", d.type, "driver", d.driver, "api_version", d.api_version, "max_image_size",
                 d.max_image_size, "max_buffer_bytes", d.max_buffer_bytes, "subgroup_size", d.subgroup_size,
                 "timestamp_period_ns", d.timestamp_period_ns, "float32", d.float32);
}

}  // namespace gloam::backend
