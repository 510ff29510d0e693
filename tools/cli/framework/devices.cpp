// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "backend/backend.hpp"
#include "backend/gl/device.hpp"
#include "backend/vulkan/device.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "base/version.hpp"
#include "check/lab.hpp"
#include "cli/framework/check/checker.hpp"
#include "cli/framework/open_device.hpp"

namespace gloam::cli {
namespace {

const char* yes(bool value) {
    return value ? "yes" : "no";
}

void print_float_controls(const backend::FloatControls& float32) {
    fmt::print(
        "   float32: keeps NaN, infinity and -0: {}; keeps subnormals: {}; can flush subnormals: {}; "
        "can round to nearest even: {}; can round to zero: {}\n",
        yes(float32.preserves_signed_zero_inf_nan), yes(float32.preserves_denormals),
        yes(float32.flushes_denormals), yes(float32.rounds_to_even), yes(float32.rounds_to_zero));
}

void print_device(const gpu::DeviceInfo& device) {
    fmt::print("{}: {}\n", device.index, device.name);
    fmt::print("   type {}, driver {}, Vulkan {}\n", device.type, device.driver, device.api_version);
    fmt::print("   largest image {}, largest buffer {} MiB, subgroup {}, timestamps {}\n",
               device.max_image_size, device.max_buffer_bytes >> 20, device.subgroup_size,
               yes(device.timestamp_period_ns > 0.0));
    print_float_controls(device.float32);
}

nlohmann::ordered_json to_json(const gpu::DeviceInfo& device) {
    return {{"index", device.index},
            {"name", device.name},
            {"type", device.type},
            {"driver", device.driver},
            {"api_version", device.api_version},
            {"max_image_size", device.max_image_size},
            {"max_buffer_bytes", device.max_buffer_bytes},
            {"subgroup_size", device.subgroup_size},
            {"timestamp_period_ns", device.timestamp_period_ns},
            {"float32",
             {{"signed_zero_inf_nan_preserve", device.float32.preserves_signed_zero_inf_nan},
              {"denorm_preserve", device.float32.preserves_denormals},
              {"denorm_flush_to_zero", device.float32.flushes_denormals},
              {"rounding_mode_rte", device.float32.rounds_to_even},
              {"rounding_mode_rtz", device.float32.rounds_to_zero}}}};
}

nlohmann::ordered_json opengl_json(const report::DeviceSummary& device) {
    return {{"index", nullptr},
            {"name", device.name},
            {"type", device.type},
            {"driver", device.driver},
            {"api_version", device.api_version}};
}

constexpr std::chrono::seconds time_to_list{30};

// The OpenGL and OpenGL ES devices of one executor (backend/gl/device.hpp), or why there are none.
struct GlExecutor {
    std::string name;
    std::vector<report::DeviceSummary> devices;
    std::string error;
};

GlExecutor listed(const std::string& name) {
    const base::ProcessResult result =
        base::run_process(gl_listing_command(name), "", {.patience = time_to_list});
    if (!result.succeeded()) return {.name = name, .error = "its process " + base::one_line(result.how())};
    try {
        Greeting greeting = report::from_line<Greeting>(result.output.substr(0, result.output.find('\n')));
        return {.name = name, .devices = std::move(greeting.devices), .error = std::move(greeting.error)};
    } catch (const std::exception& error) {
        return {.name = name,
                .error = "its process answers what makes no sense: " + base::one_line(error.what())};
    }
}

// Those of every executor. Each is opened in a process of its own: what a driver does to that costs no more
// than its devices.
std::vector<GlExecutor> list_gl_executors() {
    std::vector<GlExecutor> executors;
    for (const std::string& name : gl::executors()) executors.push_back(listed(name));
    return executors;
}

// One line for each: what it is called, and who executes it.
void print_opengl(const std::vector<GlExecutor>& executors) {
    for (const GlExecutor& executor : executors) {
        for (const report::DeviceSummary& device : executor.devices)
            fmt::print("{}: {}, {}\n", device.name, device.api_version, device.driver);
        if (!executor.error.empty()) fmt::print("OpenGL on {}: {}\n", executor.name, executor.error);
    }
}

void run_devices(bool json) {
    require_good_drivers();
    const auto devices = gpu::list_devices();
    if (devices.empty()) {
        throw std::runtime_error(
            "no Vulkan device found: install a Vulkan driver, for example mesa-vulkan-drivers; `gloam check "
            "--device interpreter` needs none");
    }
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const gpu::DeviceInfo& device : devices) {
        if (json) {
            all.push_back(to_json(device));
        } else {
            print_device(device);
        }
    }
    const std::vector<GlExecutor> opengl = list_gl_executors();
    if (json) {
        for (const GlExecutor& executor : opengl)
            for (const report::DeviceSummary& device : executor.devices) all.push_back(opengl_json(device));
        all.push_back(to_json(check::interpreter()->info()));
        all.back()["index"] = nullptr;
        fmt::print("{}\n", nlohmann::ordered_json{{"gloam", base::version()}, {"devices", all}}.dump(2));
    } else {
        print_opengl(opengl);
        fmt::print("interpreter: for `gloam check --device interpreter`\n");
        print_float_controls(check::interpreter()->info().float32);
    }
}

}  // namespace

void add_devices(CLI::App& app) {
    auto json = std::make_shared<bool>(false);
    CLI::App* command = app.add_subcommand(
        "devices",
        "the Vulkan and OpenGL devices here and the interpreter, and what their float controls report");
    command->add_flag("--json", *json, "as JSON");
    add_driver_option(*command);
    command->callback([json] { run_devices(*json); });
}

std::vector<std::string> gl_device_names() {
    std::vector<std::string> names;
    std::string error;
    for (const GlExecutor& executor : list_gl_executors()) {
        if (error.empty()) error = executor.error;
        for (const report::DeviceSummary& device : executor.devices) names.push_back(device.name);
    }
    if (names.empty()) throw std::runtime_error(error.empty() ? "there is no OpenGL device" : error);
    return names;
}

}  // namespace gloam::cli
