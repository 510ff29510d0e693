// SPDX-License-Identifier: MIT
#include "cli/drivers.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <system_error>
#include <vector>

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

void tell_the_loader(Manifests manifests) {
    const auto swiftshader = gpu::find_swiftshader();
    if (swiftshader && !gpu::drivers_are_chosen() && !holds(manifests, *swiftshader))
        manifests.push_back(*swiftshader);
    gpu::add_drivers(manifests);
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

}  // namespace gloam::cli
