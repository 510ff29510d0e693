// SPDX-License-Identifier: MIT
#include "backend/vulkan/device.hpp"
#include "support/environment.hpp"

namespace gloam::test {
namespace {

// Where GLOAM_TEST_DEVICE asks for a browser's SwiftShader, the tests run on it; without one they are
// skipped.
class SwiftShader : public testing::Environment {
    void SetUp() override {
        if (variable("GLOAM_TEST_DEVICE") != "SwiftShader") return;
        if (!backend::vulkan::find_swiftshader())
            GTEST_SKIP() << "no SwiftShader here (Debian's package chromium has it)";
        backend::vulkan::add_swiftshader();
    }
};

[[maybe_unused]] testing::Environment* const environment =
    testing::AddGlobalTestEnvironment(new SwiftShader);  // NOLINT: GoogleTest owns it

}  // namespace
}  // namespace gloam::test
