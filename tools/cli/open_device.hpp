// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "gpu/device.hpp"

namespace gloam::cli {

// Opens the device of --device and --validation; its pipelines are cached in cache_directory(). Throws like
// gpu::Device.
[[nodiscard]] gpu::Device open_device(const std::string& name, bool validation);

// Prints the validation messages since the last call. Returns the exit status: 0 without messages, otherwise
// 1.
[[nodiscard]] int validation_status(gpu::Device& device);

}  // namespace gloam::cli
