// SPDX-License-Identifier: MIT
// The room of a build without the headers of EGL and OpenGL ES: it has no devices, and nothing that needs
// one.
#include "backend/gl/device.hpp"

namespace gloam::backend::gl {

namespace {

[[noreturn]] void refuse() {
    throw Unavailable(
        "OpenGL devices are not available: gloam was built without the headers of EGL and OpenGL ES "
        "(libegl-dev, libgles-dev)");
}

}  // namespace

Device::Device(const std::string& /*name*/) : context_(nullptr, nullptr) {
    refuse();
}

std::unique_ptr<backend::Kernel> Device::make_kernel(const backend::KernelProgram& /*program*/) const {
    refuse();
}

std::vector<DeviceInfo> list_devices(const std::string& /*executor*/) {
    refuse();
}

}  // namespace gloam::backend::gl
