// SPDX-License-Identifier: MIT
#pragma once

#include "backend/vulkan/device.hpp"
#include "support/test.hpp"

namespace gloam::test {

// Every device at hand: those of the system's drivers, then a browser's SwiftShader. From the first call on,
// the process knows it by its name or index; the default device stays what it was.
inline std::vector<gpu::DeviceInfo> devices_at_hand() {
    static const bool added = [] {
        const auto manifest = gpu::find_swiftshader();
        if (manifest && !gpu::drivers_are_chosen()) gpu::add_drivers(std::array{*manifest});
        return true;
    }();
    static_cast<void>(added);
    return gpu::list_devices();
}

}  // namespace gloam::test
