// SPDX-License-Identifier: MIT
#include "cli/drivers.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "cli/driver_probe.hpp"
#include "gpu/drivers.hpp"

namespace gloam::cli {
namespace {

using Manifests = std::vector<std::filesystem::path>;

bool holds(const Manifests& manifests, const std::filesystem::path& file) {
    return std::ranges::any_of(manifests, [&file](const auto& manifest) {
        std::error_code none;
        return std::filesystem::equivalent(manifest, file, none);
    });
}

// Throws if a driver that was requested by name has no device. If it crashes the process that loads it, the
// command reports that.
void require_driver(const std::filesystem::path& manifest) {
    const DriverTrouble driver = probe_driver(manifest);
    if (driver.reason != check::Reason::error) return;
    throw std::runtime_error(fmt::format("Vulkan driver {}: the Vulkan loader gets no device from it: {}",
                                         manifest.string(), driver.error));
}

void tell_the_loader(Manifests manifests) {
    const Manifests asked_for = manifests;
    const auto swiftshader = gpu::find_swiftshader();
    if (swiftshader && !gpu::drivers_are_chosen() && !holds(manifests, *swiftshader))
        manifests.push_back(*swiftshader);
    gpu::add_drivers(manifests);
    for (const auto& manifest : asked_for) {
        ask_for_driver(manifest);
        require_driver(manifest);
    }
}

}  // namespace

void add_driver_option(CLI::App& command) {
    auto manifests = std::make_shared<Manifests>();
    command
        .add_option("--driver", *manifests,
                    "manifest (ICD JSON file) of one more Vulkan driver; may be given again")
        ->allow_extra_args(false);
    command.parse_complete_callback([manifests] { tell_the_loader(*manifests); });
}

void add_device_options(CLI::App& command, std::string& device, bool& validation) {
    command.add_option("--device", device, "name or index of the device (gloam devices)");
    command.add_flag("--validation", validation, "Vulkan validation layers on; any message is an error");
    add_driver_option(command);
}

}  // namespace gloam::cli
