// SPDX-License-Identifier: MIT
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "gpu/device.hpp"
#include "scene/pass_library.hpp"

namespace gloam::effect {

// A variable of the environment; "" where it is not set.
inline std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

// A test of passes on the device that tests run on, under validation: any message fails it.
// Base: testing::Test, or testing::TestWithParam of something.
template <class Base>
class OnDevice : public Base {
  protected:
    void TearDown() override { EXPECT_THAT(device_.take_validation_messages(), testing::IsEmpty()); }

    gpu::Device device_{{.device = variable("GLOAM_TEST_DEVICE"),
                         .validation = gpu::Validation::on,
                         .cache_directory = variable("GLOAM_CACHE_DIR")}};
    scene::PassLibrary passes_{GLOAM_GLSL_DIR, variable("GLOAM_CACHE_DIR")};
};

}  // namespace gloam::effect
