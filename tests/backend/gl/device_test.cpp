// SPDX-License-Identifier: MIT
#include "backend/gl/device.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "backend/gl/opened.hpp"

namespace gloam::gl {
namespace device_test {

using testing::HasSubstr;
using testing::ThrowsMessage;

class OpenDevice : public Opened {};

TEST_F(OpenDevice, DescribesItself) {
    GLOAM_OPEN_OR_SKIP("gl:llvmpipe-4.5");
    const DeviceInfo& info = device().info();
    EXPECT_EQ(info.name, "gl:llvmpipe-4.5");
    EXPECT_THAT(info.renderer, HasSubstr("llvmpipe"));
    EXPECT_THAT(info.driver, HasSubstr("4.5"));
    EXPECT_GE(info.max_image_size, 2048U);
    EXPECT_GE(info.max_draw_buffers, 4U);
    EXPECT_GE(info.max_storage_blocks, 4U);
    EXPECT_GE(info.max_buffer_bytes, std::uint64_t{1} << 24);
}

// Both executors, one after the other, in one process.
TEST_F(OpenDevice, EachExecutorIsTheOneThatWasAskedFor) {
    for (const char* name : {"es:llvmpipe-3.0", "es:softpipe-3.0", "es:llvmpipe-3.0"}) {
        GLOAM_OPEN_OR_SKIP(name);
        EXPECT_THAT(device().info().renderer, HasSubstr(device().info().id.executor));
        EXPECT_EQ(device().info().max_storage_blocks, 0U);
        close();
    }
}

TEST_F(OpenDevice, TheEnvironmentStaysAsItWas) {
    GLOAM_OPEN_OR_SKIP("es:llvmpipe-3.0");
    close();
    ::setenv("GALLIUM_DRIVER", "softpipe", 1);
    ::unsetenv("LIBGL_ALWAYS_SOFTWARE");
    const bool opened = open("es:llvmpipe-3.0");
    const std::string driver = std::getenv("GALLIUM_DRIVER");
    ::unsetenv("GALLIUM_DRIVER");
    EXPECT_TRUE(opened) << skipped_;
    EXPECT_EQ(driver, "softpipe");
    EXPECT_EQ(std::getenv("LIBGL_ALWAYS_SOFTWARE"), nullptr);
}

TEST_F(OpenDevice, AnotherExecutorMustWait) {
    GLOAM_OPEN_OR_SKIP("es:softpipe-3.0");
    EXPECT_THAT(
        [] { const Device other("es:llvmpipe-3.0"); },
        ThrowsMessage<Unavailable>(HasSubstr("runs softpipe: close its devices before one of llvmpipe")));
    EXPECT_NO_THROW(const Device same("es:softpipe-3.1"));
}

TEST_F(OpenDevice, AVersionThatTheDriverLacksIsRefused) {
    GLOAM_OPEN_OR_SKIP("es:softpipe-3.0");
    close();
    // If a later softpipe has it, another refusal has to be found for this test.
    EXPECT_THAT([] { const Device device("gl:softpipe-4.5"); },
                ThrowsMessage<VersionRefused>(
                    HasSubstr("gl:softpipe-4.5: the driver makes no context of OpenGL 4.5 (EGL error 0x")));
}

TEST(OpenDeviceNames, WhatIsNoNameIsNoDevice) {
    EXPECT_THAT([] { const Device device("gl:nonsense-4.5"); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("no OpenGL device \"gl:nonsense-4.5\"")));
}

TEST_F(OpenDevice, AListHasWhatCanBeOpened) {
    GLOAM_OPEN_OR_SKIP("es:llvmpipe-3.0");
    close();
    const std::vector<DeviceInfo> devices = list_devices("llvmpipe");
    ASSERT_FALSE(devices.empty());
    for (const DeviceInfo& info : devices) {
        EXPECT_NO_THROW(const Device again(info.name));
        EXPECT_EQ(info.id.executor, "llvmpipe");
    }
}

}  // namespace device_test
}  // namespace gloam::gl
