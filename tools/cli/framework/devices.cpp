// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "backend/backend.hpp"
#include "base/text.hpp"
#include "base/version.hpp"
#include "cli/framework/open_device.hpp"
#include "subject/lab.hpp"

namespace gloam::cli {
namespace {

const char* yes(bool value) {
    return value ? "yes" : "no";
}

void print_float_controls(const backend::FloatControls& float32) {
    fmt::print(
        "   float32: keeps NaN, infinity and -0: {}; keeps subnormals: {}; can flush subnormals: {}; can "
        "round to nearest even: {}; can round to zero: {}\n",
        yes(float32.preserves_signed_zero_inf_nan), yes(float32.preserves_denormals),
        yes(float32.flushes_denormals), yes(float32.rounds_to_even), yes(float32.rounds_to_zero));
}

void print_device(const backend::DeviceInfo& device) {
    fmt::print("{}: {}\n", device.index, device.name);
    fmt::print("   type {}, driver {}, Vulkan {}{}\n", device.type, device.driver, device.api_version,
               device.manifest.empty() ? "" : ", " + device.manifest);
    fmt::print("   largest image {}, largest buffer {} MiB, subgroup {}, timestamps {}\n",
               device.max_image_size, device.max_buffer_bytes >> 20, device.subgroup_size,
               yes(device.timestamp_period_ns > 0.0));
    print_float_controls(device.float32);
}

void print_json(const Drivers& drivers) {
    nlohmann::ordered_json all = record::json_of(drivers.devices);
    for (const auto& [name, listing] : list_opengl())
        for (const backend::DeviceInfo& device : listing.devices)
            all.push_back({{"index", nullptr},
                           {"name", device.name},
                           {"type", device.type},
                           {"driver", device.driver},
                           {"api_version", device.api_version}});
    all.push_back(record::json_of(subject::interpreter_backend()->info()));
    all.back()["index"] = nullptr;
    fmt::print("{}\n", nlohmann::ordered_json{{"gloam", base::version()}, {"devices", all}}.dump(2));
}

int run_devices(bool json) {
    const Drivers drivers = load_drivers();
    for (const BrokenDriver& driver : drivers.broken) say_skipped(driver);
    if (drivers.devices.empty() && drivers.broken.empty())
        fmt::print(stderr, "gloam: {}\n",
                   base::one_line(drivers.error.empty() ? "there is no Vulkan device" : drivers.error));
    if (json) {
        print_json(drivers);
        return 0;
    }
    for (const backend::DeviceInfo& device : drivers.devices) print_device(device);
    for (const auto& [name, listing] : list_opengl()) {
        for (const backend::DeviceInfo& device : listing.devices)
            fmt::print("{}: {}, {}\n", device.name, device.api_version, device.driver);
        if (!listing.error.empty()) fmt::print("OpenGL on {}: {}\n", name, listing.error);
    }
    fmt::print("interpreter: for `gloam check --device interpreter`\n");
    print_float_controls(subject::interpreter_backend()->info().float32);
    return 0;
}

}  // namespace

Command devices_command() {
    static bool json = false;
    return {
        .name = "devices",
        .about =
            "the Vulkan and OpenGL devices here and the interpreter, and what their float controls report",
        .options = {{"--json", &json, "as JSON"}, driver_option()},
        .run = [] { return run_devices(json); },
        .examples = "  gloam devices --json\n"};
}

}  // namespace gloam::cli
