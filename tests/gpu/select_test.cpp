// SPDX-License-Identifier: MIT
#include "gpu/internal/select.hpp"

#include <gtest/gtest.h>

#include "gpu/gpu_test.hpp"

namespace gloam::gpu::test {
namespace select_test {

std::vector<DeviceInfo> machine(std::initializer_list<std::pair<const char*, const char*>> devices) {
    std::vector<DeviceInfo> infos;
    for (const auto& [name, type] : devices)
        infos.push_back({.index = infos.size(), .name = name, .type = type});
    return infos;
}

TEST(Select, DefaultIsTheFirstGpu) {
    EXPECT_EQ(select_device(machine({{"soft", "cpu"}, {"small", "integrated"}, {"big", "discrete"}}), ""),
              1u);
    EXPECT_EQ(select_device(machine({{"big", "discrete"}, {"small", "integrated"}}), ""), 0u);
    EXPECT_EQ(select_device(machine({{"soft", "cpu"}, {"guest", "virtual"}}), ""), 1u);
}

TEST(Select, DefaultIsTheFirstCpuDeviceWithoutGpu) {
    EXPECT_EQ(select_device(machine({{"odd", "other"}, {"soft", "cpu"}, {"softer", "cpu"}}), ""), 1u);
    EXPECT_EQ(select_device(machine({{"odd", "other"}}), ""), 0u);
}

TEST(Select, DigitsAreAnIndex) {
    const auto devices = machine({{"card 1", "discrete"}, {"card 2", "discrete"}});
    EXPECT_EQ(select_device(devices, "0"), 0u);
    EXPECT_EQ(select_device(devices, "1"), 1u);
    EXPECT_EQ(select_device(devices, "0001"), 1u);
}

TEST(Select, OtherTextIsPartOfTheNameInAnyCase) {
    const auto devices =
        machine({{"Radeon", "discrete"}, {"llvmpipe (LLVM 15)", "cpu"}, {"LLVM too", "cpu"}});
    EXPECT_EQ(select_device(devices, "LLVM"), 1u);
    EXPECT_EQ(select_device(devices, "too"), 2u);
    EXPECT_EQ(select_device(devices, "rADEON"), 0u);
    EXPECT_EQ(select_device(devices, "(llvm 15)"), 1u);
}

TEST(Select, AnUnknownDeviceListsThoseThereAre) {
    const auto devices = machine({{"Radeon", "discrete"}, {"llvmpipe", "cpu"}});
    for (const char* selector : {"2", "99999999999999999999999", "geforce", " 1"}) {
        expect_error<std::runtime_error>([&] { static_cast<void>(select_device(devices, selector)); },
                                         {selector, "0 \"Radeon\" (discrete)", "1 \"llvmpipe\" (cpu)"});
    }
}

TEST(Select, NoDeviceSaysWhatToInstall) {
    for (const char* selector : {"", "0", "llvmpipe"}) {
        expect_error<std::runtime_error>([&] { static_cast<void>(select_device({}, selector)); },
                                         {"no Vulkan device found", "mesa-vulkan-drivers"});
    }
}

}  // namespace select_test
}  // namespace gloam::gpu::test
