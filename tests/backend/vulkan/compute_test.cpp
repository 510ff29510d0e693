// SPDX-License-Identifier: MIT
#include "backend/vulkan/gpu_test.hpp"

namespace gloam::backend::vulkan::test::compute_test {

using ComputeTest = GpuTest;

// robustBufferAccess: what a faulty shader writes outside its buffer must hit neither the process nor another
// buffer.
TEST_F(ComputeTest, AccessOutsideABufferIsHarmless) {
    const ComputePipeline outside = pipeline_of(device(), R"(
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Values { uint values[]; };
layout(push_constant) uniform Constants { uint index; };
void main() {
    values[index] = 0xffffffffu;
    values[1] = values[index + 1u];
    values[0] = 1u;
}
)",
                                                4);
    std::vector<Buffer> buffers;
    for (int i = 0; i < 3; ++i) {
        buffers.emplace_back(device(), 16);
        std::ranges::fill(buffers.back().as<std::uint32_t>(), 5u);
    }
    for (const std::uint32_t index : {4u, 1u << 10, 1u << 20, 0x3ffffff0u, 0x7ffffff0u}) {
        run(device(), outside, {buffers[1]}, {1, 1, 1}, bytes_of(index));
        EXPECT_EQ(buffers[1].as<std::uint32_t>()[0], 1u);
        for (const std::size_t other : {0u, 2u}) {
            EXPECT_EQ(std::ranges::count(buffers[other].as<std::uint32_t>(), 5u), 4) << index;
        }
    }
}

class TimestampTest : public GpuTest {
  protected:
    void SetUp() override {
        if (device().info().timestamp_period_ns == 0.0) GTEST_SKIP() << "no timestamps on this device";
    }
};

TEST_F(TimestampTest, ReadTheWorkBetweenThem) {
    const ComputePipeline slow = pipeline_of(device(), slow_shader, 4);
    Buffer buffer(device(), 4);
    constexpr std::uint32_t steps = 60'000;
    Commands commands(device());
    const std::vector<Resource> resources{buffer};
    EXPECT_EQ(commands.timestamp(), 0u);
    commands.dispatch(slow, resources, {10, 1, 1}, bytes_of(steps));
    EXPECT_EQ(commands.timestamp(), 1u);
    commands.dispatch(slow, resources, {10, 20, 1}, bytes_of(steps));
    EXPECT_EQ(commands.timestamp(), 2u);

    const auto start = std::chrono::steady_clock::now();
    commands.submit();
    const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
    const auto times = commands.times_ms();
    ASSERT_EQ(times.size(), 3u);
    EXPECT_EQ(times[0], 0.0);
    EXPECT_GT(times[1], 0.0);
    EXPECT_GT(times[2], times[1]);
    // In milliseconds: a part of the wait.
    EXPECT_LT(times[2], 1.05 * wall.count() + 1.0);
}

// More readings than one query pool holds, and they never run backwards.
TEST_F(TimestampTest, AreMonotone) {
    Commands commands(device());
    for (std::size_t i = 0; i < 200; ++i) ASSERT_EQ(commands.timestamp(), i);
    commands.submit();
    const auto times = commands.times_ms();
    ASSERT_EQ(times.size(), 200u);
    EXPECT_EQ(times.front(), 0.0);
    EXPECT_TRUE(std::ranges::is_sorted(times));
}

}  // namespace gloam::backend::vulkan::test::compute_test
