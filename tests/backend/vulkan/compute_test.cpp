// SPDX-License-Identifier: MIT
#include "backend/vulkan/gpu_test.hpp"

namespace gloam::backend::vulkan::test::compute_test {

using ComputeTest = GpuTest;

// A shader's specialization constants, and the number of its work groups.
std::vector<std::uint32_t> specialize(const Device& device,
                                      const std::vector<SpecializationConstant>& constants) {
    const ComputePipeline pipeline = pipeline_of(device, R"(
layout(local_size_x_id = 7) in;
layout(constant_id = 0) const float a_float = 1.5;
layout(constant_id = 3) const uint a_uint = 2u;
layout(constant_id = 4) const int an_int = 3;
layout(constant_id = 5) const bool a_bool = false;
layout(std430, binding = 0) buffer Values { uint values[]; };
void main() {
    if (gl_GlobalInvocationID.x == 0u) {
        values[0] = floatBitsToUint(a_float);
        values[1] = a_uint;
        values[2] = uint(an_int);
        values[3] = a_bool ? 1u : 0u;
        values[4] = gl_WorkGroupSize.x;
    }
    atomicAdd(values[5], 1u);
}
)",
                                                 0, {BindingKind::storage_buffer}, constants);
    Buffer buffer(device, 6 * sizeof(std::uint32_t));
    std::ranges::fill(buffer.as<std::uint32_t>(), 0u);
    run(device, pipeline, {buffer}, {2, 3, 5});
    const auto values = buffer.as<std::uint32_t>();
    return {values.begin(), values.end()};
}

TEST_F(ComputeTest, SpecializationConstantsAreSetByIdOrHaveTheirDefaults) {
    EXPECT_EQ(specialize(device(), {}),
              (std::vector<std::uint32_t>{std::bit_cast<std::uint32_t>(1.5f), 2u, 3u, 0u, 1u, 30u}));
    const std::vector<SpecializationConstant> constants{
        {5, 1u}, {0, std::bit_cast<std::uint32_t>(-0.25f)}, {7, 16u}, {4, 0xffffffffu}};
    EXPECT_EQ(
        specialize(device(), constants),
        (std::vector<std::uint32_t>{std::bit_cast<std::uint32_t>(-0.25f), 2u, 0xffffffffu, 1u, 16u, 480u}));
}

TEST_F(ComputeTest, EachDispatchHasItsOwnPushConstants) {
    const ComputePipeline fill = pipeline_of(device(), fill_shader, 8);
    std::vector<Buffer> buffers;
    for (int i = 0; i < 3; ++i) buffers.emplace_back(device(), 65 * sizeof(float));
    Commands commands(device());
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const std::array constants{static_cast<float>(i), 10.0f};  // copied: gone before submit()
        commands.dispatch(fill, std::vector<Resource>{buffers[i]}, {2, 1, 1}, bytes_of(constants));
    }
    commands.submit();
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        EXPECT_EQ(buffers[i].as<float>().front(), static_cast<float>(i));
        EXPECT_EQ(buffers[i].as<float>().back(), static_cast<float>(i) + 640.0f);
    }
}

// Every result of a dispatch depends on a neighbour's of the one before, so that any missing wait shows; also
// more descriptor sets than one pool has.
TEST_F(ComputeTest, EachDispatchSeesTheOneBefore) {
    constexpr std::size_t count = 5000;
    constexpr int steps = 301;
    const ComputePipeline chain = pipeline_of(device(), R"(
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer From { uint from[]; };
layout(std430, binding = 1) writeonly buffer To { uint to[]; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    uint n = uint(from.length());
    if (i < n) to[i] = 3u * from[i] + from[(i + n / 2u + 1u) % n];
}
)",
                                              0, {BindingKind::storage_buffer, BindingKind::storage_buffer});
    std::array buffers{Buffer(device(), count * 4), Buffer(device(), count * 4)};
    std::vector<std::uint32_t> expected(count);
    std::iota(expected.begin(), expected.end(), 1u);
    std::ranges::copy(expected, buffers[0].as<std::uint32_t>().begin());

    Commands commands(device());
    for (std::size_t step = 0; step < steps; ++step) {
        commands.dispatch(chain, std::vector<Resource>{buffers[step % 2], buffers[(step + 1) % 2]},
                          {(count + 63) / 64, 1, 1});
        std::vector<std::uint32_t> next(count);
        for (std::size_t i = 0; i < count; ++i)
            next[i] = 3 * expected[i] + expected[(i + count / 2 + 1) % count];
        expected = std::move(next);
    }
    commands.submit();
    const auto result = buffers[steps % 2].as<std::uint32_t>();
    EXPECT_EQ(std::vector(result.begin(), result.end()), expected);
}

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

TEST_F(ComputeTest, CommandsRunOnce) {
    Commands commands(device());
    commands.submit();
    expect_error<std::runtime_error>([&] { commands.submit(); }, {"submitted"});
    expect_error<std::runtime_error>([&] { commands.timestamp(); }, {"submitted"});
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
