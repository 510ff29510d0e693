// SPDX-License-Identifier: MIT
#include "cli/framework/open_device.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "backend/vulkan/device.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "cli/environment.hpp"
#include "cli/framework/check/checker.hpp"

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

namespace {

namespace fs = std::filesystem;

constexpr double seconds_to_load = 30.0;

// Time limit for loading a driver. Throws std::invalid_argument.
std::chrono::milliseconds time_to_load() {
    const char* text = std::getenv("GLOAM_DRIVER_SECONDS");
    if (text == nullptr) return std::chrono::milliseconds(static_cast<int>(1e3 * seconds_to_load));
    constexpr double most = 86'400.0;
    char* end = nullptr;
    const double seconds = std::strtod(text, &end);
    if (end == text || *end != '\0' || !(seconds >= 0.1 && seconds <= most)) {
        throw std::invalid_argument(
            fmt::format("GLOAM_DRIVER_SECONDS \"{}\": expected seconds, 0.1 to {}", text, most));
    }
    return std::chrono::milliseconds(static_cast<std::int64_t>(1e3 * seconds));
}

// Counts the devices, with this driver alone or, for an empty path, with all.
DriverTrouble tried(const fs::path& manifest) {
    DriverTrouble trouble{.manifest = manifest};
    const auto fail = [&](check::Reason reason, const std::string& why) {
        trouble.reason = reason;
        trouble.error = base::one_line(why);
        return trouble;
    };
    const std::chrono::milliseconds patience = time_to_load();
    const base::ProcessResult result =
        base::run_process(listing_command(manifest), "", {.patience = patience});
    if (result.end == base::ProcessResult::End::time) {
        const double seconds = std::chrono::duration<double>(patience).count();
        return fail(check::Reason::hang, fmt::format("does not load within {:g} s", seconds));
    }
    if (result.output.empty()) return fail(check::Reason::crash, "its process " + result.how());
    try {
        const Greeting greeting =
            report::from_line<Greeting>(result.output.substr(0, result.output.find('\n')));
        if (!greeting.error.empty()) return fail(check::Reason::error, greeting.error);
        if (greeting.devices.empty()) return fail(check::Reason::error, "gives no device");
    } catch (const std::exception& error) {
        return fail(check::Reason::error, error.what());
    }
    return trouble;
}

bool does_not_load(const DriverTrouble& driver) {
    return driver.reason == check::Reason::crash || driver.reason == check::Reason::hang;
}

std::vector<fs::path>& asked_for() {
    static std::vector<fs::path> drivers;
    return drivers;
}

void choose(const std::vector<fs::path>& manifests) {
    std::string list;
    for (const fs::path& manifest : manifests) list += (list.empty() ? "" : ":") + manifest.string();
    ::setenv("VK_DRIVER_FILES", list.c_str(), 1);
    ::setenv("VK_ICD_FILENAMES", list.c_str(), 1);  // for loaders that support only the older name
    ::unsetenv("VK_ADD_DRIVER_FILES");
}

// The manifests of the drivers that the Vulkan loader would load, in its order, as it says itself.
std::vector<fs::path> driver_manifests() {
    const std::string log =
        base::run_process(manifests_command(), "",
                          {.environment = {"VK_LOADER_DEBUG=driver", "VK_LOADER_DRIVERS_DISABLE=*"}})
            .output;
    std::istringstream lines(log.substr(std::min(log.size(), log.find("Found the following files:"))));
    std::string line;
    std::getline(lines, line);
    std::vector<fs::path> manifests;
    while (std::getline(lines, line)) {
        line.erase(0, line.find_first_not_of(' ', line.find(':') + 1));
        std::error_code none;
        if (!fs::is_regular_file(line, none)) break;
        manifests.emplace_back(line);
    }
    return manifests;
}

// Loads this driver alone. `reason` is none if it has a device.
DriverTrouble probe_driver(const fs::path& manifest) {
    const fs::path file = fs::absolute(manifest);
    DriverTrouble driver = tried(file);
    driver.asked_for = std::ranges::find(asked_for(), file) != asked_for().end();
    return driver;
}

}  // namespace

const std::vector<fs::path>& drivers_asked_for() {
    return asked_for();
}

LeftOut leave_out_bad_drivers() {
    if (!does_not_load(tried({}))) return {};
    LeftOut left_out{.drivers = {}, .others = false};
    std::vector<fs::path> good;
    for (const fs::path& manifest : driver_manifests()) {
        DriverTrouble driver = probe_driver(manifest);
        left_out.others = left_out.others || driver.reason == check::Reason::none;
        if (does_not_load(driver)) {
            left_out.drivers.push_back(std::move(driver));
        } else {
            good.push_back(manifest);
        }
    }
    if (left_out.others) choose(good);
    return left_out;
}

void require_good_drivers() {
    static bool done = false;
    if (std::exchange(done, true)) return;
    const LeftOut left_out = leave_out_bad_drivers();
    for (const DriverTrouble& driver : left_out.drivers) {
        const std::string what = fmt::format("Vulkan driver {}: {}", driver.manifest.string(), driver.error);
        if (!left_out.others) throw std::runtime_error(what);
        fmt::print(stderr, "gloam: {}; it is skipped\n", what);
    }
}

namespace {

using Manifests = std::vector<fs::path>;

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
    const Manifests named = manifests;
    const auto swiftshader = gpu::find_swiftshader();
    if (swiftshader && !gpu::drivers_are_chosen() && !holds(manifests, *swiftshader))
        manifests.push_back(*swiftshader);
    gpu::add_drivers(manifests);
    for (const auto& manifest : named) {
        asked_for().push_back(fs::absolute(manifest));
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
