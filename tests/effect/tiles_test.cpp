// SPDX-License-Identifier: MIT
#include "effect/internal/tiles.hpp"
#include "backend/vulkan/commands.hpp"
#include "backend/vulkan/resources.hpp"
#include "effect/internal/progress.hpp"
#include "on_device.hpp"
#include "shader/compile.hpp"

namespace gloam::effect::tiles_test {

// What the passes count of their tiles: by invocation and by group the same, and what was to be counted.

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

TEST(Progress, TheHistoryLagsUntilTheFirstFrameOfTheNextView) {
    Progress progress;
    EXPECT_FALSE(progress.has_view());
    progress.begin();
    EXPECT_TRUE(progress.has_view());
    EXPECT_FALSE(progress.history_lags());
    progress.count_frame();
    progress.advance();
    EXPECT_TRUE(progress.history_lags());
    progress.count_frame();
    EXPECT_FALSE(progress.history_lags());
}

TEST(Progress, SettlesAfterTwoFramesOfAView) {
    Progress progress;
    progress.begin();
    EXPECT_TRUE(progress.first_of_view());
    progress.count_frame();
    EXPECT_FALSE(progress.first_of_view());
    EXPECT_FALSE(progress.settled());
    progress.count_frame();
    EXPECT_TRUE(progress.settled());
    progress.advance();
    EXPECT_FALSE(progress.settled());
    EXPECT_TRUE(progress.first_of_view());
}

// Passes over lists of tiles, of one tile a group or of several: each pixel of the listed tiles has one
// invocation, and no other pixel has any.

constexpr std::uint32_t width = 37;  // pixels: the last tiles are not whole
constexpr std::uint32_t height = 22;

// Lists every other tile as shaded, and a few that the filter changes.
constexpr const char* listing_pass = R"(#version 450
layout(local_size_x = 8, local_size_y = 8) in;
#define GLOAM_LIST_BINDING 0
#include "passes/tiles/append.glsl"
void main() {
    uvec2 at = gl_GlobalInvocationID.xy;
    uvec2 tiles = tiles_of(ivec2(37, 22));
    bool inside = at.x < tiles.x && at.y < tiles.y;
    uint shaded = inside && (at.x + at.y) % 2u == 0u ? IN_LIST << SHADED_TILES : 0u;
    uint filtered = inside && at.x < 3u && at.y == 1u ? IN_LIST << FILTERED_Y_TILES : 0u;
    append_group(shaded | filtered, IN_LIST << SHADED_TILES | IN_LIST << FILTERED_Y_TILES, at, tiles);
}
)";

constexpr const char* visiting_pass = R"(#version 450
layout(local_size_x = 8, local_size_y = 8) in;
#define GLOAM_LIST_BINDING 0
#include "passes/tiles/listed.glsl"
layout(binding = 1, std430) buffer Visits { uint visits[]; };
void main() {
    Column column = column_of_invocation(ivec2(37, 22));
    for (int i = 0; i < column.pixels; ++i) {
        ivec2 pixel = column.first + ivec2(0, i);
        if (pixel.x < 37 && pixel.y < 22) atomicAdd(visits[pixel.y * 37 + pixel.x], 1u);
    }
}
)";

class ListedPixels : public OnDevice<testing::Test> {
  protected:
    [[nodiscard]] gpu::ComputePipeline pass(const char* text, std::size_t buffers,
                                            std::vector<gpu::SpecializationConstant> constants) const {
        const shader::Spirv spirv =
            shader::compile({.name = "lists.comp", .text = text}, {.include_roots = {GLOAM_GLSL_DIR}});
        return {device_,
                {.spirv = spirv,
                 .bindings = std::vector(buffers, gpu::BindingKind::storage_buffer),
                 .constants = std::move(constants)}};
    }

    // A buffer of lists, all of them empty.
    [[nodiscard]] gpu::Buffer no_tiles() const {
        constexpr std::size_t tiles = std::size_t{(width + side - 1) / side} * ((height + side - 1) / side);
        const std::vector<std::byte> headers = empty_lists();
        gpu::Buffer lists(device_, headers.size() + tile_lists * tiles * sizeof(std::uint32_t));
        std::ranges::copy(headers, lists.bytes().begin());
        return lists;
    }

    // How often each pixel was visited by a pass over a list.
    [[nodiscard]] std::vector<std::uint32_t> visits(TileLists list) const {
        const gpu::Buffer tiles = no_tiles();
        gpu::Buffer counts(device_, std::size_t{width} * height * sizeof(std::uint32_t));
        std::ranges::fill(counts.as<std::uint32_t>(), 0U);
        const gpu::ComputePipeline listing = pass(listing_pass, 1, {});
        const gpu::ComputePipeline visiting = pass(
            visiting_pass, 2, {{.id = 10, .bits = 1}, {.id = 11, .bits = static_cast<std::uint32_t>(list)}});
        const std::vector<gpu::Resource> lists{tiles};
        const std::vector<gpu::Resource> both{tiles, counts};
        gpu::Commands commands(device_);
        commands.dispatch(listing, lists, {1, 1, 1});
        commands.dispatch_indirect(visiting, both, tiles, offset_of(list));
        commands.submit();
        const auto found = counts.as<std::uint32_t>();
        return {found.begin(), found.end()};
    }
};

template <class Listed>
void expect_once(const std::vector<std::uint32_t>& visits, const Listed& listed) {
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x)
            ASSERT_EQ(visits[y * width + x], listed(x / side, y / side) ? 1U : 0U) << x << ", " << y;
    }
}

TEST_F(ListedPixels, EachOfAShadedTileOnce) {
    expect_once(visits(TileLists::shaded),
                [](std::uint32_t column, std::uint32_t row) { return (column + row) % 2 == 0; });
}

TEST_F(ListedPixels, EachOfAFilteredTileOnce) {
    expect_once(visits(TileLists::filtered_y),
                [](std::uint32_t column, std::uint32_t row) { return column < 3 && row == 1; });
}

}  // namespace gloam::effect::tiles_test
