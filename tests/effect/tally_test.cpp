// SPDX-License-Identifier: MIT
// What the passes count of their tiles: by invocation and by group the same, and what was to be counted.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "effect/internal/tiles.hpp"
#include "gpu/buffer.hpp"
#include "gpu/commands.hpp"
#include "gpu/compute.hpp"
#include "on_device.hpp"
#include "shader/compile.hpp"

namespace gloam::effect {
namespace tally_test {

constexpr std::uint32_t columns = 3;
constexpr std::uint32_t rows = 2;
constexpr std::uint32_t side = 8;

// One more tile than there are along each axis; pixels of many kinds, and some of none.
constexpr const char* counting_pass = R"(#version 450
layout(local_size_x = 8, local_size_y = 8) in;
#define GLOAM_STATE_BINDING 0
#include "passes/tiles/tally.glsl"
void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    uint number = pixel.y * 1000u + pixel.x;
    uint kind = number % 5u == 0u   ? COUNT_BACKGROUND
                : number % 5u == 1u ? COUNT_BELOW_LIMIT
                : number % 5u == 2u ? COUNT_FROZEN
                                    : 0u;
    if (number % 3u == 0u) kind += COUNT_FILTERED;
    count_tile(entry_of(gl_WorkGroupID.xy), uvec2(3u, 2u), number % 7u == 0u ? 2048u : 0u, kind);
}
)";

std::vector<TileState> expected() {
    std::vector<TileState> states(columns * rows);
    for (std::uint32_t y = 0; y < side * rows; ++y) {
        for (std::uint32_t x = 0; x < side * columns; ++x) {
            const std::uint32_t number = y * 1000 + x;
            TileState& state = states[y / side * columns + x / side];
            state.missed += number % 7 == 0 ? 2048 : 0;
            if (number % 5 < 3) state.pixels += 1U << 8U * (number % 5);
            if (number % 3 == 0) state.pixels += 1U << 24U;
        }
    }
    return states;
}

class Tally : public OnDevice<testing::Test> {
  protected:
    [[nodiscard]] std::vector<TileState> counted(std::uint32_t how) const {
        const shader::Spirv spirv = shader::compile({.name = "counting.comp", .text = counting_pass},
                                                    {.include_roots = {GLOAM_GLSL_DIR}});
        const gpu::ComputePipeline pass(device_, {.spirv = spirv,
                                                  .bindings = {gpu::BindingKind::storage_buffer},
                                                  .constants = {{.id = 0, .bits = how}}});
        gpu::Buffer states(device_, columns * rows * sizeof(TileState));
        std::ranges::fill(states.as<TileState>(), TileState{});
        const std::vector<gpu::Resource> resources{states};
        gpu::Commands commands(device_);
        commands.dispatch(pass, resources, {columns + 1, rows + 1, 1});
        commands.submit();
        const auto found = states.as<TileState>();
        return {found.begin(), found.end()};
    }
};

void expect_same(const std::vector<TileState>& found, const std::vector<TileState>& wanted) {
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].flags, wanted[i].flags) << "tile " << i;
        EXPECT_EQ(found[i].missed, wanted[i].missed) << "tile " << i;
        EXPECT_EQ(found[i].pixels, wanted[i].pixels) << "tile " << i;
    }
}

TEST_F(Tally, CountsByInvocation) {
    expect_same(counted(1), expected());
}

TEST_F(Tally, CountsByGroup) {
    expect_same(counted(2), expected());
}

TEST_F(Tally, CountsNothingUnasked) {
    expect_same(counted(0), std::vector<TileState>(expected().size()));
}

}  // namespace tally_test
}  // namespace gloam::effect
