// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/check_report.hpp"

namespace gloam::cli {

// The OpenGL and OpenGL ES devices of one executor (gl/device_name.hpp), or why there are none.
struct GlExecutor {
    std::string name;
    std::vector<report::DeviceSummary> devices;
    std::string error;
};

// Those of every executor. Each is opened in a process of its own: what a driver does to that costs no more
// than its devices.
[[nodiscard]] std::vector<GlExecutor> list_gl_executors();

// The names of all devices. Throws std::runtime_error that says why where there is none.
[[nodiscard]] std::vector<std::string> gl_device_names();

// Greets with the devices of an executor: what such a process does.
[[nodiscard]] std::string gl_devices_line(const std::string& executor);

}  // namespace gloam::cli
