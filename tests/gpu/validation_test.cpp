// SPDX-License-Identifier: MIT
// That messages arrive at all: without this, no other test's silence would mean anything.
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <optional>

#include "gpu/gpu_test.hpp"
#include "shaders/fill_comp.h"

namespace gloam::gpu::test {
namespace validation_test {

using ValidationTest = GpuTest;

bool any_mentions(const std::vector<std::string>& messages, const std::string& text) {
    return std::ranges::any_of(messages, [&](const auto& m) { return m.find(text) != std::string::npos; });
}

TEST_F(ValidationTest, SeesAShaderThatDisagreesWithItsBindings) {
    const ComputePipeline wrong(
        device(), {.spirv = fill_comp, .bindings = {BindingKind::storage_image}, .push_constant_bytes = 8});
    const auto messages = device().take_validation_messages();
    ASSERT_FALSE(messages.empty());
    EXPECT_TRUE(any_mentions(messages, "VUID-VkComputePipelineCreateInfo-layout")) << messages.front();
    for (const auto& message : messages) EXPECT_EQ(message.find('\n'), std::string::npos);
    EXPECT_TRUE(device().take_validation_messages().empty()) << "taken twice";
    EXPECT_EQ(take_messages(), messages) << "the listener hears the same";
}

TEST_F(ValidationTest, SeesMissingPushConstants) {
    const ComputePipeline wrong(device(), {.spirv = fill_comp, .bindings = {BindingKind::storage_buffer}});
    EXPECT_TRUE(any_mentions(take_messages(), "VUID-VkComputePipelineCreateInfo-layout"));
}

// A pipeline that outlives its device is an error of the caller, which only a listener can receive. It runs
// in a separate process, because the pipeline can never be destroyed.
[[noreturn]] void leave_a_pipeline_behind() {
    std::optional<Device> device(std::in_place,
                                 DeviceOptions{.device = device_name(),
                                               .validation = Validation::on,
                                               .on_validation_message = [](const std::string& message) {
                                                   std::cerr << message << std::endl;
                                               }});
    const ComputePipeline pipeline(
        *device, {.spirv = fill_comp, .bindings = {BindingKind::storage_buffer}, .push_constant_bytes = 8});
    device.reset();
    std::_Exit(0);
}

TEST(ValidationDeathTest, HearsTheDeviceClose) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(leave_a_pipeline_behind(), ::testing::ExitedWithCode(0), "VUID-vkDestroyDevice-device");
}

TEST(ValidationOff, HasNoMessages) {
    Device device({.device = device_name()});
    Commands commands(device);
    commands.submit();
    EXPECT_TRUE(device.take_validation_messages().empty());
}

}  // namespace validation_test
}  // namespace gloam::gpu::test
