// SPDX-License-Identifier: MIT
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>

#include "effect/ambient_occlusion.hpp"
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
// lavapipe compiles a pass anew for images whose width or height is a power of two: tests of all methods take
// other sizes where they may choose, so that what one of them has compiled serves the others.
template <class Base>
class OnDevice : public Base {
  protected:
    void TearDown() override { EXPECT_THAT(device_.take_validation_messages(), testing::IsEmpty()); }

    gpu::Device device_{{.device = variable("GLOAM_TEST_DEVICE"),
                         .validation = gpu::Validation::on,
                         .cache_directory = variable("GLOAM_CACHE_DIR")}};
    scene::PassLibrary passes_{GLOAM_GLSL_DIR, variable("GLOAM_CACHE_DIR")};

    // One for each size, so that pipelines are compiled once; begin() leaves no trace of what it held before
    // (configuration_study_test.cpp).
    [[nodiscard]] AmbientOcclusion& effect_for(gpu::Extent extent) const {
        return effects_.try_emplace(std::pair(extent.width, extent.height), device_, passes_, extent)
            .first->second;
    }

  private:
    mutable std::map<std::pair<std::uint32_t, std::uint32_t>, AmbientOcclusion> effects_;
};

}  // namespace gloam::effect
