// SPDX-License-Identifier: MIT
#include "gpu/device.hpp"

#include <algorithm>
#include <set>

#include "gpu/environment.hpp"
#include "gpu/gpu_test.hpp"
#include "gpu/internal/features.hpp"

namespace gloam::gpu::test {
namespace device_test {

using DeviceTest = GpuTest;

TEST(Devices, DescribeThemselves) {
    const std::set<std::string> types{"cpu", "integrated", "discrete", "virtual", "other"};
    const auto devices = list_devices();
    ASSERT_FALSE(devices.empty());
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const auto& device = devices[i];
        EXPECT_EQ(device.index, i);
        EXPECT_FALSE(device.name.empty());
        EXPECT_FALSE(device.driver.empty());
        EXPECT_TRUE(types.contains(device.type)) << device.type;
        EXPECT_EQ(device.api_version.substr(0, 2), "1.") << device.api_version;
        EXPECT_EQ(std::ranges::count(device.api_version, '.'), 2) << device.api_version;
        EXPECT_EQ(device.identity.size(), 72u);
        EXPECT_EQ(device.identity.find_first_not_of("0123456789abcdef"), std::string::npos)
            << device.identity;
        // The least that Vulkan 1.2 allows.
        EXPECT_GE(device.max_image_size, 4096u);
        EXPECT_GE(device.max_buffer_bytes, 1u << 27);
        for (const auto count : device.max_group_count) EXPECT_GE(count, 65535u);
        EXPECT_GE(device.subgroup_size, 1u);
        EXPECT_GE(device.timestamp_period_ns, 0.0);
    }
}

TEST_F(DeviceTest, RobustBufferAccessIsOnUnlessSwitchedOff) {
    EXPECT_EQ(features_of({}).robustBufferAccess, VK_TRUE);
    EXPECT_EQ(features_of({.robust_buffer_access = false}).robustBufferAccess, VK_FALSE);
    open({.robust_buffer_access = false});
    Buffer buffer(device(), 16);
    EXPECT_EQ(buffer.size(), 16U);
}

TEST_F(DeviceTest, OpensByIndexAndByName) {
    for (const auto& listed : list_devices()) {
        for (const auto& selector : {std::to_string(listed.index), listed.name}) {
            const Device device({.device = selector});
            EXPECT_EQ(device.info().name, listed.name);
            EXPECT_EQ(device.info().identity, listed.identity);
        }
    }
}

TEST_F(DeviceTest, OpensAndClosesWithoutAMessage) {
    open();
    close();
    open();
    EXPECT_TRUE(device().take_validation_messages().empty());
}

TEST_F(DeviceTest, TwoAtOnce) {
    open();
    const Device other({.device = device_name()});
    EXPECT_EQ(other.info().name, device().info().name);
}

TEST(Devices, AnUnknownNameListsTheNames) {
    expect_error<std::runtime_error>([] { Device({.device = "no such device"}); },
                                     {"\"no such device\"", list_devices().front().name.c_str()});
}

TEST(Devices, ATimeoutMustBePositive) {
    expect_error<std::invalid_argument>([] { Device({.timeout = std::chrono::milliseconds(0)}); }, {"0 ms"});
    expect_error<std::invalid_argument>([] { Device({.timeout = std::chrono::milliseconds(-3)}); },
                                        {"-3 ms"});
}

TEST(Devices, NoDriverIsOneClearLine) {
    // The name of the variable changed with the loader's versions.
    const ScopedVariable old_name("VK_ICD_FILENAMES", "/nonexistent/icd.json");
    const ScopedVariable new_name("VK_DRIVER_FILES", "/nonexistent/icd.json");
    expect_error<std::runtime_error>([] { static_cast<void>(list_devices()); },
                                     {"no Vulkan device found", "install", "mesa-vulkan-drivers"});
    expect_error<std::runtime_error>([] { Device device; },
                                     {"no Vulkan device found", "install", "mesa-vulkan-drivers"});
    expect_error<std::runtime_error>([] { Device({.validation = Validation::on}); },
                                     {"no Vulkan device found", "install", "mesa-vulkan-drivers"});
}

TEST(Devices, AMissingValidationLayerNamesItsPackage) {
    const ScopedVariable path("VK_LAYER_PATH", "/nonexistent");
    expect_error<std::runtime_error>([] { Device({.validation = Validation::on}); },
                                     {"VK_LAYER_KHRONOS_validation", "vulkan-validationlayers"});
    EXPECT_NO_THROW(Device({.device = device_name()}));
}

}  // namespace device_test
}  // namespace gloam::gpu::test
