// SPDX-License-Identifier: MIT
#include "cli/gl_devices.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/json_bounds.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "check/lab.hpp"
#include "cli/check/checker.hpp"
#include "cli/check/worker.hpp"
#include "gl/device.hpp"

namespace gloam::cli {
namespace {

using nlohmann::json;

constexpr std::chrono::seconds time_to_list{30};

GlExecutor executor_from(const std::string& name, const std::string& line) {
    GlExecutor executor{.name = name};
    base::require_bounded_json(line);
    const json object = json::parse(line, nullptr, false);
    if (!object.is_object()) throw std::runtime_error("expected a JSON object");
    executor.error = object.at("error").get<std::string>();
    for (const json& device : object.at("devices"))
        executor.devices.push_back(report::device_from_json(device.get<std::string>()));
    return executor;
}

GlExecutor listed(const std::string& name) {
    const base::ProcessResult result =
        base::run_process(gl_listing_command(name), "", {.patience = time_to_list});
    if (!result.succeeded()) return {.name = name, .error = "its process " + base::one_line(result.how())};
    try {
        return executor_from(name, result.output.substr(0, result.output.find('\n')));
    } catch (const std::exception& error) {
        return {.name = name,
                .error = "its process answers what makes no sense: " + base::one_line(error.what())};
    }
}

}  // namespace

std::vector<GlExecutor> list_gl_executors() {
    std::vector<GlExecutor> executors;
    for (const std::string& name : gl::executors()) executors.push_back(listed(name));
    return executors;
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

std::string gl_devices_line(const std::string& executor) {
    json object{{"devices", json::array()}, {"error", ""}};
    try {
        for (const gl::DeviceInfo& info : gl::list_devices(executor))
            object["devices"].push_back(report::to_json(summary_of(check::opengl_info(info))));
    } catch (const std::exception& error) {
        object["error"] = error.what();
    }
    return object.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace gloam::cli
