// SPDX-License-Identifier: MIT
#include "gpu/buffer.hpp"

#include <algorithm>
#include <numeric>

#include "gpu/gpu_test.hpp"
#include "shaders/fill_comp.h"

namespace gloam::gpu::test {
namespace buffer_test {

using BufferTest = GpuTest;

TEST_F(BufferTest, KeepsWhatTheHostWrites) {
    for (const std::size_t count : {1u, 3u, 1000u, 100'000u}) {
        Buffer buffer(device(), count * sizeof(std::uint32_t));
        ASSERT_EQ(buffer.size(), count * sizeof(std::uint32_t));
        ASSERT_EQ(buffer.as<std::uint32_t>().size(), count);
        std::iota(buffer.as<std::uint32_t>().begin(), buffer.as<std::uint32_t>().end(), 7u);
        const Buffer& view = buffer;
        EXPECT_EQ(view.bytes().size(), buffer.size());
        EXPECT_EQ(view.as<std::uint32_t>().front(), 7u);
        EXPECT_EQ(buffer.as<std::uint32_t>().back(), 6u + count);
    }
}

TEST_F(BufferTest, OfAnyNumberOfBytes) {
    for (const std::size_t bytes : {1u, 2u, 5u, 257u}) {
        Buffer buffer(device(), bytes);
        std::ranges::fill(buffer.bytes(), std::byte{0xa5});
        EXPECT_EQ(std::ranges::count(buffer.bytes(), std::byte{0xa5}), static_cast<std::ptrdiff_t>(bytes));
    }
}

TEST_F(BufferTest, TheDeviceSeesAllOfIt) {
    constexpr std::uint32_t count = 1'000'003;
    const ComputePipeline fill(
        device(), {.spirv = fill_comp, .bindings = {BindingKind::storage_buffer}, .push_constant_bytes = 8});
    Buffer buffer(device(), count * sizeof(float));
    std::ranges::fill(buffer.as<float>(), -1.0f);
    run(device(), fill, {buffer}, {(count + 63) / 64, 1, 1}, bytes_of(std::array{3.0f, 0.5f}));
    const auto values = buffer.as<float>();
    for (std::uint32_t i = 0; i < count; ++i) ASSERT_EQ(values[i], 3.0f + static_cast<float>(i) * 0.5f) << i;
}

TEST_F(BufferTest, MovesWithItsContent) {
    Buffer first(device(), 4);
    first.as<std::uint32_t>()[0] = 42;
    Buffer second(std::move(first));
    EXPECT_EQ(second.as<std::uint32_t>()[0], 42u);
    Buffer third(device(), 8);
    third = std::move(second);
    EXPECT_EQ(third.size(), 4u);
    EXPECT_EQ(third.as<std::uint32_t>()[0], 42u);
}

TEST_F(BufferTest, SizesThatCannotBe) {
    const auto most = std::to_string(device().info().max_buffer_bytes);
    expect_error<std::runtime_error>([&] { Buffer(device(), 0); }, {"buffer of 0 bytes", most.c_str()});
    const auto too_much = static_cast<std::size_t>(device().info().max_buffer_bytes) + 1;
    expect_error<std::runtime_error>([&] { Buffer(device(), too_much); },
                                     {std::to_string(too_much).c_str(), most.c_str()});
}

}  // namespace buffer_test
}  // namespace gloam::gpu::test
