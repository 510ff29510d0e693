// SPDX-License-Identifier: MIT
#include "cli/open_device.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "cli/environment.hpp"

namespace gloam::cli {

gpu::Device open_device(const std::string& name, bool validation) {
    require_good_drivers();
    return gpu::Device({.device = name,
                        .validation = validation ? gpu::Validation::on : gpu::Validation::off,
                        .cache_directory = cache_directory()});
}

int validation_status(gpu::Device& device) {
    const auto messages = device.take_validation_messages();
    for (const std::string& message : messages) fmt::print(stderr, "gloam: {}\n", message);
    return messages.empty() ? 0 : 1;
}

}  // namespace gloam::cli
