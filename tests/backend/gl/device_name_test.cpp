// SPDX-License-Identifier: MIT
#include "backend/gl/device.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace gloam::gl {
namespace device_name_test {

TEST(DeviceNames, EveryNameIsReadBack) {
    std::set<std::string> names;
    for (const std::string& executor : executors()) {
        for (const Version& version : versions()) {
            const DeviceName name{executor, version};
            EXPECT_EQ(device_name_from(to_string(name)), name);
            EXPECT_TRUE(is_device_name(to_string(name)));
            names.insert(to_string(name));
        }
    }
    EXPECT_EQ(names.size(), executors().size() * versions().size());
    EXPECT_TRUE(names.contains("gl:llvmpipe-4.5"));
    EXPECT_TRUE(names.contains("es:softpipe-3.1"));
}

TEST(DeviceNames, OthersAreNone) {
    for (const char* text : {"", "gl", "gl:", "gl:llvmpipe", "gl:llvmpipe-4.6", "es:llvmpipe-3.3",
                             "GL:llvmpipe-4.5", "gl:llvmpipe-4.5 ", "llvmpipe"})
        EXPECT_FALSE(device_name_from(text)) << text;
    for (const char* text : {"", "gl", "llvmpipe", "interpreter", "0"})
        EXPECT_FALSE(is_device_name(text)) << text;
}

TEST(DeviceNames, ComputeShadersBeginWithTheirVersions) {
    EXPECT_TRUE(has_compute({Api::gl, 4, 5}));
    EXPECT_FALSE(has_compute({Api::gl, 3, 3}));
    EXPECT_TRUE(has_compute({Api::es, 3, 2}));
    EXPECT_TRUE(has_compute({Api::es, 3, 1}));
    EXPECT_FALSE(has_compute({Api::es, 3, 0}));
    EXPECT_EQ(to_string(Version{Api::es, 3, 1}), "OpenGL ES 3.1");
    EXPECT_EQ(to_string(Version{Api::gl, 4, 5}), "OpenGL 4.5");
}

}  // namespace device_name_test
}  // namespace gloam::gl
