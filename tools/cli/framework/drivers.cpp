// SPDX-License-Identifier: MIT
#include "cli/framework/open_device.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "backend/gl/device.hpp"
#include "backend/vulkan/device.hpp"
#include "base/number.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "cli/environment.hpp"
#include "cli/framework/check/worker.hpp"
#include "record/failures.hpp"
#include "subject/lab.hpp"

namespace gloam::cli {

namespace {

namespace fs = std::filesystem;

constexpr double seconds_to_load = 30.0;

// Time limit for loading drivers. Throws std::invalid_argument.
std::chrono::duration<double> time_to_load() {
    const char* text = std::getenv("GLOAM_DRIVER_SECONDS");
    if (text == nullptr) return std::chrono::duration<double>(seconds_to_load);
    constexpr double most = 86'400.0;
    const double seconds = base::number_from<double>(text).value_or(0.0);
    if (seconds >= 0.1 && seconds <= most) return std::chrono::duration<double>(seconds);
    throw std::invalid_argument(
        fmt::format("GLOAM_DRIVER_SECONDS \"{}\": expected seconds, 0.1 to {}", text, most));
}

Listing listed(const std::string& what, std::vector<std::string> environment = {}) {
    const std::chrono::duration<double> patience = time_to_load();
    const base::ProcessResult result = base::run_process(
        listing_command(what), {.patience = std::chrono::ceil<std::chrono::milliseconds>(patience),
                                .environment = std::move(environment)});
    if (result.end == base::ProcessResult::End::time)
        return {.error = fmt::format("does not load within {:g} s", patience.count()),
                .reason = judge::Reason::hang};
    if (result.output.empty())
        return {.error = base::one_line("its process " + result.how()), .reason = judge::Reason::crash};
    try {
        return record::from_line<Listing>(result.output.substr(0, result.output.find('\n')));
    } catch (const std::exception& error) {
        return {.error = "its process answers what makes no sense: " + base::one_line(error.what())};
    }
}

// What tells the loader to load these drivers only, the second name for loaders that support only that.
std::vector<std::string> only(const std::string& manifests) {
    return {"VK_DRIVER_FILES=" + manifests, "VK_ICD_FILENAMES=" + manifests};
}

// The manifests of the drivers that the Vulkan loader would load, in its order, as it says itself.
std::vector<fs::path> driver_manifests() {
    const std::string log =
        base::run_process(listing_command("manifests"),
                          {.environment = {"VK_LOADER_DEBUG=driver", "VK_LOADER_DRIVERS_DISABLE=*"}})
            .output;
    std::istringstream lines(log.substr(std::min(log.size(), log.find("Found the following files:"))));
    std::string line;
    std::getline(lines, line);
    std::vector<fs::path> manifests;
    while (std::getline(lines, line)) {
        line.erase(0, line.find_first_not_of(' ', line.find(':') + 1));
        std::error_code none;
        if (fs::is_regular_file(line, none)) manifests.emplace_back(line);  // others are no names, or missing
    }
    return manifests;
}

std::string cause_of(const BrokenDriver& driver) {
    return fmt::format("Vulkan driver {}: {}", driver.manifest.string(), driver.error);
}

std::vector<fs::path> asked_for;  // manifests of --driver

void tell_the_loader() {
    for (fs::path& manifest : asked_for) manifest = fs::absolute(manifest);
    if (asked_for.empty())
        backend::vulkan::add_swiftshader();
    else
        backend::vulkan::choose_drivers(asked_for);
}

// Names the manifests of devices: of all with --driver, else of those that share a name with another
// driver's.
void name_manifests(std::vector<backend::DeviceInfo>& devices) {
    const auto shares_name = [&](const backend::DeviceInfo& device) {
        return std::ranges::count(devices, device.name, &backend::DeviceInfo::name) > 1;
    };
    if (asked_for.empty() && std::ranges::none_of(devices, shares_name)) return;
    std::vector<backend::DeviceInfo> named;
    for (const fs::path& manifest : asked_for.empty() ? driver_manifests() : asked_for) {
        const Listing alone = asked_for.size() == 1 ? Listing{devices} : listed("vulkan", only(manifest));
        if (alone.devices.empty() && !asked_for.empty())
            throw std::runtime_error(fmt::format(
                "Vulkan driver {}: the Vulkan loader gets no device from it (VK_LOADER_DEBUG=all says more)",
                manifest.string()));
        for (const backend::DeviceInfo& device : alone.devices)
            named.emplace_back(device).manifest = manifest.string();
    }
    const std::vector<backend::DeviceInfo> all = named;
    for (backend::DeviceInfo& device : devices) {
        const auto found = std::ranges::find_if(named, [&](const backend::DeviceInfo& one) {
            return one.name == device.name && one.driver == device.driver;
        });
        if (found == named.end()) continue;
        const bool shares = std::ranges::any_of(all, [&](const backend::DeviceInfo& other) {
            return other.name == found->name && other.manifest != found->manifest;
        });
        if (shares || !asked_for.empty())
            device.manifest = found->manifest, device.of_manifest = found->index;
        named.erase(found);
    }
}

}  // namespace

backend::vulkan::Device open_device(const std::string& name, bool validation) {
    require_good_drivers();
    return backend::vulkan::Device(
        {.device = name,
         .validation = validation ? backend::vulkan::Validation::on : backend::vulkan::Validation::off,
         .cache_directory = cache_directory()});
}

int validation_status(backend::vulkan::Device& device) {
    const auto messages = device.take_validation_messages();
    for (const std::string& message : messages) fmt::print(stderr, "gloam: {}\n", message);
    return messages.empty() ? 0 : 1;
}

void say_skipped(const BrokenDriver& driver) {
    fmt::print(stderr, "gloam: {}; it is skipped\n", cause_of(driver));
}

std::vector<std::pair<std::string, Listing>> list_opengl() {
    std::vector<std::pair<std::string, Listing>> executors;
    for (const std::string& name : backend::gl::executors()) executors.emplace_back(name, listed(name));
    return executors;
}

std::vector<std::string> gl_device_names() {
    std::vector<std::string> names;
    std::string error;
    for (const auto& [name, listing] : list_opengl()) {
        if (error.empty()) error = listing.error;
        for (const backend::DeviceInfo& device : listing.devices) names.push_back(device.name);
    }
    if (names.empty()) throw std::runtime_error(error.empty() ? "there is no OpenGL device" : error);
    return names;
}

Drivers load_drivers() {
    Drivers found{listed("vulkan"), {}};
    if (found.reason == judge::Reason::none) {
        name_manifests(found.devices);
        return found;
    }
    std::string others;
    const std::vector<fs::path> manifests = driver_manifests();
    for (const fs::path& manifest : manifests) {
        const Listing alone = manifests.size() == 1 ? Listing(found) : listed("vulkan", only(manifest));
        if (alone.reason == judge::Reason::none)
            others += (others.empty() ? "" : ":") + manifest.string();
        else
            found.broken.push_back({alone, manifest});
    }
    found.error =
        found.broken.empty() ? "the Vulkan drivers: " + found.error : cause_of(found.broken.front());
    if (others.empty()) return found;
    found.devices = listed("vulkan", only(others)).devices;
    for (const char* variable : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"})
        ::setenv(variable, others.c_str(), 1);
    return found;
}

void require_good_drivers() {
    const Drivers found = load_drivers();
    if (found.devices.empty() && !found.broken.empty()) throw std::runtime_error(found.error);
    for (const BrokenDriver& driver : found.broken) say_skipped(driver);
}

std::string loader_words(const std::string& device, const std::string& manifest) {
    if (!manifest.empty()) return "VK_DRIVER_FILES=" + record::shell_word(manifest) + " ";
    std::string words;
    if (device == subject::interpreter_name || backend::gl::is_device_name(device)) return words;
    for (const auto& [variable, value] : backend::vulkan::chosen_drivers())
        if (value != backend::vulkan::find_swiftshader() || device.starts_with("SwiftShader"))
            words += variable + "=" + record::shell_word(value) + " ";
    return words;
}

Option driver_option() {
    return {"--driver", &asked_for, repeated,
            "manifest (ICD JSON file) of a Vulkan driver, instead of the installed ones; may be given again",
            tell_the_loader};
}

}  // namespace gloam::cli
