// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "gl/device_name.hpp"
#include "gl/errors.hpp"

namespace gloam::gl {

namespace internal {
struct Context;  // EGL and OpenGL handles; defined inside this room only
}

// A device as it describes itself.
struct DeviceInfo {
    DeviceName name;
    std::string vendor;                    // "Mesa/X.org"
    std::string renderer;                  // "llvmpipe (LLVM 15.0.6, 256 bits)"
    std::string version;                   // "4.5 (Core Profile) Mesa 22.3.6"
    std::string glsl_version;              // "4.50"
    std::uint32_t max_texture_size = 0;    // texels, each side
    std::uint32_t max_draw_buffers = 0;    // targets of one draw
    std::uint32_t max_storage_blocks = 0;  // storage buffers of a compute shader; 0: it has none
    std::uint64_t max_storage_bytes = 0;   // largest storage buffer
    std::uint32_t max_texture_units = 0;   // textures of a fragment shader
};

// An open OpenGL or OpenGL ES context without a window, for use from the thread that made it. Everything made
// from it must die before it.
//
// Mesa reads the name of its software renderer from the environment, which is one for the whole process. The
// constructor sets LIBGL_ALWAYS_SOFTWARE and GALLIUM_DRIVER while it opens the display, and restores them: no
// other thread may read the environment meanwhile. A process has devices of one executor at a time.
//
// Throws std::invalid_argument for a name that is none; Unavailable; VersionRefused.
class Device {
  public:
    explicit Device(const std::string& name);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    [[nodiscard]] const DeviceInfo& info() const { return info_; }
    [[nodiscard]] internal::Context& context() const { return *context_; }

  private:
    std::unique_ptr<internal::Context> context_;
    DeviceInfo info_;
};

// The devices of an executor that can be opened in this process, in the order of versions(). Of "system" none
// where it is one of the other executors. Throws Unavailable where there is no EGL at all.
[[nodiscard]] std::vector<DeviceInfo> list_devices(const std::string& executor);

}  // namespace gloam::gl
