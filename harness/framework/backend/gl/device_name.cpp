// SPDX-License-Identifier: MIT
#include "backend/gl/device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace gloam::backend::gl {
namespace {

const char* prefix_of(Api api) {
    return api == Api::gl ? "gl:" : "es:";
}

}  // namespace

std::string to_string(const Version& version) {
    return fmt::format("OpenGL{} {}.{}", version.api == Api::gl ? "" : " ES", version.major, version.minor);
}

bool has_compute(const Version& version) {
    const std::tuple first = version.api == Api::gl ? std::tuple{4, 3} : std::tuple{3, 1};
    return std::tuple{version.major, version.minor} >= first;
}

std::string glsl_of(const Version& version) {
    if (version.api == Api::gl) return has_compute(version) ? "450" : "330";
    return fmt::format("3{}0es", version.minor);
}

std::string to_string(const DeviceName& name) {
    return fmt::format("{}{}-{}.{}", prefix_of(name.version.api), name.executor, name.version.major,
                       name.version.minor);
}

bool is_device_name(std::string_view text) {
    return text.starts_with(prefix_of(Api::gl)) || text.starts_with(prefix_of(Api::es));
}

std::optional<DeviceName> device_name_from(std::string_view text) {
    for (const std::string& executor : executors()) {
        for (const Version& version : versions()) {
            const DeviceName name{executor, version};
            if (to_string(name) == text) return name;
        }
    }
    return std::nullopt;
}

std::vector<std::string> executors() {
    return {"system", "llvmpipe", "softpipe"};
}

std::vector<Version> versions() {
    return {{Api::gl, 4, 5}, {Api::gl, 3, 3}, {Api::es, 3, 2}, {Api::es, 3, 1}, {Api::es, 3, 0}};
}

}  // namespace gloam::backend::gl
