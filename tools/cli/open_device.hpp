// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "gpu/device.hpp"

namespace gloam::cli {

// The device that --device and --validation name; its pipelines are kept in cache_directory(). Throws like
// gpu::Device.
[[nodiscard]] gpu::Device open_device(const std::string& name, bool validation);

// Prints what the validation layers found since the last call. Returns the exit status: 0 nothing, else 1.
[[nodiscard]] int validation_status(gpu::Device& device);

}  // namespace gloam::cli
