// SPDX-License-Identifier: MIT
#pragma once

#include "backend/vulkan/commands.hpp"
#include "module/compile.hpp"
#include "support/environment.hpp"
#include "support/files.hpp"

namespace gloam::backend::vulkan::test {

// Opens devices with validation, and fails on any message, those of closing the device included.
class GpuTest : public ::testing::Test {
  protected:
    // Opens (or opens again) the device of the test.
    Device& open(DeviceOptions options = {}) {
        device_.reset();
        options.device = variable("GLOAM_TEST_DEVICE");
        options.validation = Validation::on;
        options.on_validation_message = [this](const std::string& message) { messages_.push_back(message); };
        return device_.emplace(options);
    }

    Device& device() { return device_ ? *device_ : open(); }
    void close() { device_.reset(); }

    // For tests that provoke messages.
    std::vector<std::string> take_messages() { return std::exchange(messages_, {}); }

    void TearDown() override {
        device_.reset();
        for (const auto& message : messages_) ADD_FAILURE() << message;
    }

  private:
    std::vector<std::string> messages_;
    std::optional<Device> device_;  // last: closing it still adds messages
};

// A value as push constants.
template <class T>
    requires std::is_trivially_copyable_v<T>
std::span<const std::byte> bytes_of(const T& value) {
    return std::as_bytes(std::span(&value, 1));
}

// The module of a shader without its #version line.
inline module::Spirv compiled(const std::string& text, source::Stage stage = source::Stage::compute) {
    return module::compile({"test", "#version 450\n" + text}, {.stage = stage});
}

// A pipeline of a compute shader, without its #version line.
inline ComputePipeline pipeline_of(const Device& device, const std::string& text,
                                   std::uint32_t push_constant_bytes = 0,
                                   std::vector<BindingKind> bindings = {BindingKind::storage_buffer}) {
    return {device, {compiled(text), std::move(bindings), push_constant_bytes, {}}};
}

// values[i] = first + i * step.
inline constexpr const char* fill_shader = R"(
layout(local_size_x = 64) in;
layout(std430, binding = 0) writeonly buffer Values { float values[]; };
layout(push_constant) uniform Constants { float first; float step; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < uint(values.length())) values[i] = first + float(i) * step;
}
)";

// Chains of dependent steps (a linear congruential generator) that no compiler can shorten; one a work group.
// At most 65535 steps: lavapipe ends an invocation's loops there without a word.
inline constexpr const char* slow_shader = R"(
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Values { uint sum; };
layout(push_constant) uniform Constants { uint steps; };
void main() {
    uint x = gl_WorkGroupID.x + gl_WorkGroupID.y + 1u;
    for (uint i = 0u; i < steps; ++i) x = (x ^ i) * 1664525u + 1013904223u;
    atomicAdd(sum, x);
}
)";

// Runs a pipeline once, alone.
inline void run(const Device& device, const ComputePipeline& pipeline, const std::vector<Resource>& resources,
                std::array<std::uint32_t, 3> groups, std::span<const std::byte> push_constants = {}) {
    Commands commands(device);
    commands.dispatch(pipeline, resources, groups, push_constants);
    commands.submit();
}

}  // namespace gloam::backend::vulkan::test
