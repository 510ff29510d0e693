// SPDX-License-Identifier: MIT
// What does not fit a device is refused before Vulkan hears of it.
#include <unistd.h>

#include <iostream>

#include "backend/vulkan/gpu_test.hpp"
#include "base/process.hpp"

namespace gloam::backend::vulkan::test::mismatch_test {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

using MismatchTest = GpuTest;

TEST_F(MismatchTest, GroupCounts) {
    const ComputePipeline fill = pipeline_of(device(), fill_shader, 8);
    Buffer buffer(device(), 64);
    const std::vector<Resource> resources{buffer};
    Commands commands(device());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto limit = device().info().max_group_count[axis];
        if (limit == 0xffffffffu) continue;
        std::array<std::uint32_t, 3> groups{1, 1, 1};
        groups[axis] = limit + 1;
        expect_error<std::invalid_argument>(
            [&] { commands.dispatch(fill, resources, groups, bytes_of(std::array{0.0F, 0.0F})); },
            {std::string("in ") + "xyz"[axis], std::to_string(limit), std::to_string(limit + 1)});
    }
    commands.submit();  // the refused commands have left no trace
}

TEST_F(MismatchTest, PipelinesThatCannotBe) {
    const auto make = [&](ComputeProgram program) { ComputePipeline(device(), program); };
    const std::vector<std::uint32_t> garbage{0x12345678u, 0u, 0u, 0u, 0u, 0u};
    expect_error<std::invalid_argument>([&] { make({.spirv = {}}); }, {"not a SPIR-V module", "0 words"});
    expect_error<std::invalid_argument>([&] { make({.spirv = garbage}); },
                                        {"not a SPIR-V module", "0x12345678"});
    const module::Spirv fill = compiled(fill_shader);
    expect_error<std::invalid_argument>([&] { make({.spirv = fill, .push_constant_bytes = 6}); },
                                        {"6 bytes"});
    expect_error<std::invalid_argument>([&] { make({.spirv = fill, .push_constant_bytes = 1u << 20}); },
                                        {"1048576 bytes"});
    const std::vector<BindingKind> many(2'000'000, BindingKind::storage_buffer);
    expect_error<std::invalid_argument>([&] { make({.spirv = fill, .bindings = many}); },
                                        {"2000000 storage buffer bindings"});
}

constexpr auto timeout = 200ms;
constexpr std::uint32_t steps = 60'000;
using Groups = std::array<std::uint32_t, 3>;

// Number of work groups that keep this device busy for a few seconds, at any speed. If the driver computes on
// the processor, processor time is measured, because on a busy machine elapsed time does not measure the
// work.
Groups long_work() {
    const Device device({.device = variable("GLOAM_TEST_DEVICE")});
    const bool on_processor = device.info().type == "cpu";
    const auto now = [&] {
        return on_processor ? base::processor_time_of(getpid())
                            : std::chrono::nanoseconds(Clock::now().time_since_epoch());
    };
    const auto pipeline = pipeline_of(device, slow_shader, 4);
    const Buffer buffer(device, 4);
    run(device, pipeline, {buffer}, {1, 1, 1}, bytes_of(steps));  // a driver may compile only now
    for (Groups groups{64, 1, 1};; groups[1] *= 2) {
        const auto start = now();
        run(device, pipeline, {buffer}, groups, bytes_of(steps));
        if (now() - start > 50ms) return {groups[0], groups[1] * 40, 1};
    }
}

// Starts the work, and returns the message of the failure.
std::string message_of_hang(const Device& device, const ComputePipeline& pipeline, const Buffer& buffer,
                            const Groups& groups) {
    try {
        run(device, pipeline, {buffer}, groups, bytes_of(steps));
    } catch (const backend::Hang& error) {
        return error.what();
    }
    return "nothing thrown";
}

class TimeoutTest : public GpuTest {
  protected:
    // Submits nothing until the device takes it again.
    bool wait_until_idle() {
        for (const auto start = Clock::now(); Clock::now() - start < 120s;
             std::this_thread::sleep_for(20ms)) {
            try {
                Commands commands(device());
                commands.submit();
                return true;
            } catch (const backend::Hang&) {
            }
        }
        return false;
    }
};

TEST_F(TimeoutTest, ThrowsAndRecoversWhenTheWorkIsDone) {
    const auto groups = long_work();
    open({.timeout = timeout});
    const auto pipeline = pipeline_of(device(), slow_shader, 4);
    Buffer buffer(device(), 4);
    const auto start = Clock::now();
    const auto message = message_of_hang(device(), pipeline, buffer, groups);
    EXPECT_NE(message.find("within 0.2 s"), std::string::npos) << message;
    EXPECT_GE(Clock::now() - start, timeout);

    // It did not wait for the work, which still runs.
    expect_error<backend::Hang>([&] { Commands(device()).submit(); }, {"still runs", "timed out"});
    Image* refused = nullptr;
    EXPECT_THROW(refused = new Image(device(), {1, 1}, Format::r32f), backend::Hang);
    EXPECT_EQ(refused, nullptr);

    ASSERT_TRUE(wait_until_idle());
    buffer.as<std::uint32_t>()[0] = 0;
    run(device(), pipeline, {buffer}, {1, 1, 1}, bytes_of(std::uint32_t{1}));
    EXPECT_EQ(buffer.as<std::uint32_t>()[0], 1664525u + 1013904223u);
}

// Runs in a separate process and reports on stderr: all objects of a device that still works are destroyed.
[[noreturn]] void destroy_while_running() {
    const auto groups = long_work();
    std::string report;
    auto start = Clock::now();
    {
        Device device({.device = variable("GLOAM_TEST_DEVICE"),
                       .validation = Validation::on,
                       .timeout = timeout,
                       .on_validation_message = [&](const std::string& message) { report += message; }});
        const auto pipeline = pipeline_of(device, slow_shader, 4);
        const Buffer buffer(device, 4);
        report += message_of_hang(device, pipeline, buffer, groups);
        start = Clock::now();
    }
    const bool prompt = Clock::now() - start < 100ms;
    std::cerr << "saw: " << report << (prompt ? " (prompt)" : " (blocked)") << std::endl;
    std::_Exit(0);
}

TEST(TimeoutDeathTest, DestructionNeitherWaitsNorBreaksTheRules) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(destroy_while_running(), ::testing::ExitedWithCode(0),
                "saw: device .* within 0.2 s .prompt.");
}

}  // namespace gloam::backend::vulkan::test::mismatch_test
