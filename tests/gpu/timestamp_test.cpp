// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cmath>

#include "gpu/gpu_test.hpp"
#include "shaders/slow_comp.h"

namespace gloam::gpu::test {
namespace timestamp_test {

class TimestampTest : public GpuTest {
  protected:
    void SetUp() override {
        if (device().info().timestamp_period_ns == 0.0) GTEST_SKIP() << "no timestamps on this device";
    }
};

TEST_F(TimestampTest, ReadTheWorkBetweenThem) {
    const ComputePipeline slow(
        device(), {.spirv = slow_comp, .bindings = {BindingKind::storage_buffer}, .push_constant_bytes = 4});
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
    // In milliseconds: a part of the wait, and by far the most. The factor of 100 is for a busy machine; a
    // wrong unit is a factor of 1000.
    EXPECT_GT(times[2], 0.01 * wall.count());
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

TEST_F(TimestampTest, AreThereOnlyAfterSubmit) {
    Commands commands(device());
    commands.timestamp();
    expect_error<std::runtime_error>([&] { static_cast<void>(commands.times_ms()); }, {"not been submitted"});
}

}  // namespace timestamp_test
}  // namespace gloam::gpu::test
