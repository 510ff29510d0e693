// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "backend/backend.hpp"
#include "base/hidden.hpp"

namespace gloam::backend::gl {

// There is no EGL library, no display without a window, or no such software renderer.
class Unavailable : public backend::Error {
    using backend::Error::Error;
};

// The driver makes no context of the version that was asked for.
class VersionRefused : public Unavailable {
    using Unavailable::Unavailable;
};

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

// The version of GLSL in which its kernels are written: "450", "330", "320es", "310es", "300es".
[[nodiscard]] std::string glsl_of(const Version& version);

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

namespace internal {
struct Context;  // EGL and OpenGL handles; defined inside this room only
}

// A device as it describes itself. OpenGL says nothing of NaN, infinity, -0 and subnormals.
struct DeviceInfo : backend::DeviceInfo {
    DeviceName id;
    std::string renderer;                  // "llvmpipe (LLVM 15.0.6, 256 bits)"
    std::uint32_t max_storage_blocks = 0;  // storage buffers of a compute shader; 0: it has none
};

// An open OpenGL or OpenGL ES context without a window, for use from the thread that made it. Everything made
// from it must die before it.
//
// Mesa reads the name of its software renderer from the environment, which is one for the whole process. The
// constructor sets LIBGL_ALWAYS_SOFTWARE and GALLIUM_DRIVER while it opens the display, and restores them: no
// other thread may read the environment meanwhile. A process has devices of one executor at a time.
//
// Throws std::invalid_argument for a name that is none; Unavailable. What a driver rejects, and any other
// error that a call sets, are backend::Error: "NAME: line 12: its message [the text of that line]".
class Device : public backend::Backend {
  public:
    explicit Device(const std::string& name);

    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    [[nodiscard]] std::unique_ptr<backend::Kernel> make_kernel(
        const backend::KernelProgram& program) const override;
    [[nodiscard]] internal::Context& context() const { return *context_; }

  private:
    base::Hidden<internal::Context> context_;
    DeviceInfo info_;
};

// The devices of an executor that can be opened in this process, in the order of versions(). Of "system" none
// where it is one of the other executors. Throws Unavailable where there is no EGL at all.
[[nodiscard]] std::vector<DeviceInfo> list_devices(const std::string& executor);

}  // namespace gloam::backend::gl
