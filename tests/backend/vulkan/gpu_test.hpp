// SPDX-License-Identifier: MIT
#pragma once

#include "backend/vulkan/commands.hpp"
#include "support/environment.hpp"
#include "support/files.hpp"

namespace gloam::gpu::test {

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

// Runs a pipeline once, alone.
inline void run(const Device& device, const ComputePipeline& pipeline, const std::vector<Resource>& resources,
                std::array<std::uint32_t, 3> groups, std::span<const std::byte> push_constants = {}) {
    Commands commands(device);
    commands.dispatch(pipeline, resources, groups, push_constants);
    commands.submit();
}

}  // namespace gloam::gpu::test
