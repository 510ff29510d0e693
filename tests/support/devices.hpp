// SPDX-License-Identifier: MIT
#pragma once

#include "backend/vulkan/device.hpp"
#include "support/test.hpp"

namespace gloam::test {

// Every device at hand: those of the system's drivers, then a browser's SwiftShader. From the first call on,
// the process knows it by its name or index; the default device stays what it was.
inline std::vector<backend::DeviceInfo> devices_at_hand() {
    static const bool added = [] {
        const auto manifest = backend::vulkan::find_swiftshader();
        if (manifest && !backend::vulkan::drivers_are_chosen())
            backend::vulkan::add_drivers(std::array{*manifest});
        return true;
    }();
    static_cast<void>(added);
    return backend::vulkan::list_devices();
}

}  // namespace gloam::test
