// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gloam::gl {

enum class Api { gl, es };

// A version of OpenGL (core profile) or OpenGL ES.
struct Version {
    Api api = Api::gl;
    int major = 0;
    int minor = 0;

    friend bool operator==(const Version&, const Version&) = default;
};

// "OpenGL 4.5", "OpenGL ES 3.1".
[[nodiscard]] std::string to_string(const Version& version);

// Whether the version has compute shaders: OpenGL 4.3 and OpenGL ES 3.1.
[[nodiscard]] bool has_compute(const Version& version);

// A device: what executes, and through which version of the interface. Executors are Mesa's software
// renderers "llvmpipe" and "softpipe", and "system": what EGL chooses where no environment variable asks for
// software.
struct DeviceName {
    std::string executor;
    Version version;

    friend bool operator==(const DeviceName&, const DeviceName&) = default;
};

// "gl:llvmpipe-4.5", "es:softpipe-3.1", and back. Nothing for another text.
[[nodiscard]] std::string to_string(const DeviceName& name);
[[nodiscard]] std::optional<DeviceName> device_name_from(std::string_view text);

// Whether the text begins as the name of such a device does: with "gl:" or "es:".
[[nodiscard]] bool is_device_name(std::string_view text);

// The executors, and the versions that are tried: OpenGL 4.5 and 3.3, OpenGL ES 3.2, 3.1 and 3.0.
[[nodiscard]] std::vector<std::string> executors();
[[nodiscard]] std::vector<Version> versions();

}  // namespace gloam::gl
