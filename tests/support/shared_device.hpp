// SPDX-License-Identifier: MIT
#pragma once

#include "backend/vulkan/device.hpp"
#include "support/environment.hpp"

namespace gloam::test {

// The device of all tests of a process: the default one or $GLOAM_TEST_DEVICE, with the validation layers on.
// Opened when it is first asked for, closed after the last test.
class SharedDevice : public testing::Environment {
  public:
    [[nodiscard]] static std::shared_ptr<backend::vulkan::Device> get() {
        if (!device()) {
            device() = std::make_shared<backend::vulkan::Device>(
                backend::vulkan::DeviceOptions{.device = variable("GLOAM_TEST_DEVICE"),
                                               .validation = backend::vulkan::Validation::on,
                                               .cache_directory = variable("GLOAM_CACHE_DIR")});
        }
        return device();
    }

    void TearDown() override { device().reset(); }

  private:
    static std::shared_ptr<backend::vulkan::Device>& device() {
        static std::shared_ptr<backend::vulkan::Device> opened;
        return opened;
    }
};

// Closes the device before the layers and the driver that it uses are unloaded.
inline testing::Environment* const shared_device_environment =
    testing::AddGlobalTestEnvironment(new SharedDevice);  // NOLINT: GoogleTest owns it

}  // namespace gloam::test
