// SPDX-License-Identifier: MIT
#include "effect/internal/tiles.hpp"
#include "backend/vulkan/commands.hpp"
#include "backend/vulkan/resources.hpp"
#include "effect/internal/progress.hpp"
#include "shader/compile.hpp"
#include "skips.hpp"
#include "support/method_names.hpp"
#include "surface_views.hpp"

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

// Passes over lists of tiles: for any number of tiles in a group, each pixel of the listed tiles has one
// invocation, and no other pixel has any.

constexpr std::uint32_t width = 37;  // pixels: the last tiles are not whole
constexpr std::uint32_t height = 22;

// Lists every other tile as open, and a few that the filter changes.
constexpr const char* listing_pass = R"(#version 450
layout(local_size_x = 8, local_size_y = 8) in;
#define GLOAM_LIST_BINDING 0
#include "passes/tiles/append.glsl"
void main() {
    uvec2 at = gl_GlobalInvocationID.xy;
    uvec2 tiles = tiles_of(ivec2(37, 22));
    bool inside = at.x < tiles.x && at.y < tiles.y;
    uint open = inside && (at.x + at.y) % 2u == 0u ? IN_LIST << OPEN_TILES : 0u;
    uint filtered = inside && at.x < 3u && at.y == 1u ? IN_LIST << FILTERED_Y_TILES : 0u;
    append_group(open | filtered, IN_LIST << OPEN_TILES | IN_LIST << FILTERED_Y_TILES, at, tiles);
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

class ListedPixels : public OnDevice<testing::TestWithParam<std::uint32_t>> {
  protected:
    [[nodiscard]] gpu::ComputePipeline pass(const char* text, std::size_t buffers,
                                            std::vector<gpu::SpecializationConstant> constants) const {
        constants.push_back({.id = 13, .bits = GetParam()});
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

TEST_P(ListedPixels, EachOfAnOpenTileOnce) {
    expect_once(visits(TileLists::open),
                [](std::uint32_t column, std::uint32_t row) { return (column + row) % 2 == 0; });
}

TEST_P(ListedPixels, EachOfAFilteredTileOnce) {
    expect_once(visits(TileLists::filtered_y),
                [](std::uint32_t column, std::uint32_t row) { return column < 3 && row == 1; });
}

INSTANTIATE_TEST_SUITE_P(Tiles, ListedPixels, testing::Values(1U, 2U, 4U, 8U),
                         [](const auto& asked) { return std::to_string(asked.param) + "_a_group"; });

// Tiles that are proven open take no taps, and their images stay bit-identical.

class OpenTiles : public Skips {};

class OpenFloor : public OpenTiles, public testing::WithParamInterface<std::string> {};

TEST_P(OpenFloor, TakesNoTaps) {
    const Settings settings = with_method(quick(Settings{}), GetParam());
    for (const float bump : {0.0F, 0.02F, 0.3F}) {
        const std::vector<Frame> frames = expect_same({{floor_view({160, 90}, bump), 5}}, settings);
        const Work& work = frames.front().work;
        const std::uint64_t with_geometry = work.tiles - work.tiles_background;
        EXPECT_GT(work.tiles_open, 0U);
        // Far away the rounding of positions exceeds the bias.
        if (bump == 0.0F) {
            EXPECT_GT(work.tiles_open, with_geometry / 4);
        } else {
            EXPECT_LT(work.tiles_open, with_geometry);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, OpenFloor, testing::ValuesIn(test::method_names([](const MethodInfo& method) {
                             return method.open_proof != OpenProof::none;
                         })),
                         test::parameter_name);

TEST_F(OpenTiles, OfAFloorFewTilesCannotBeProvenOpen) {
    const Work work = run({{floor_view({160, 90}, 0.0F), 1}}, quick(Settings{})).front().work;
    EXPECT_GT(work.tiles_open, (work.tiles - work.tiles_background) / 2);
}

// Blocks of pixels that begin far behind the floor and end in front of it, along x and along y.
TEST_F(OpenTiles, ASurfaceThatComesNearWithinATileIsSeen) {
    scene::GBuffer view = floor_view({160, 90}, 0.0F);
    const auto ramp = [&](std::size_t left, std::size_t top, bool along_y) {
        const float near = view.depth[160 * (top + 7) + left + 7] - 0.3F;
        for (std::size_t y = 0; y < 8; ++y)
            for (std::size_t x = 0; x < 8; ++x)
                view.depth[160 * (top + y) + left + x] =
                    1.0F / std::lerp(1.0F / 40.0F, 1.0F / near, static_cast<float>(along_y ? y : x) / 7.0F);
    };
    ramp(80, 56, false);
    ramp(32, 64, true);
    const Frame frame = expect_same({{view, 2}}, quick(Settings{})).front();
    EXPECT_GT(frame.work.tiles_open, 0U);
    EXPECT_GT(frame.occlusion[160 * 60 + 90], 0.0F);
    EXPECT_GT(frame.occlusion[160 * 74 + 36], 0.0F);
}

// A sample reaches 60 pixels here, of 128 that the coarsest blocks have on a side: the step lies at the end
// of the reach of the pixels in the middle, in another block.
TEST_F(OpenTiles, AStepAtTheEndOfTheReachIsSeen) {
    constexpr gpu::Extent wide{192, 48};
    constexpr float depth = 5.0F;
    Settings settings = quick(Settings{});
    settings.samples = settings.samples_converged = 256;
    settings.filter = Filter::none;
    const scene::CameraFrame camera = scene::make_frame({.fovy_rad = 0.25}, 4.0);
    settings = with_radius(settings, 120.0F * depth / (192.0F * camera.p00_p11().x));
    scene::GBuffer view = wall_of(wide, [&](std::uint32_t x, std::uint32_t) {
        return depth - (x >= 144 ? 0.3F * settings.radius : 0.0F);
    });
    view.camera = camera;
    const Frame frame = expect_same({{view, 1}}, settings).front();
    EXPECT_GT(frame.work.tiles_open, 0U);
    EXPECT_GT(frame.occlusion[24 * wide.width + 95], 0.0F);
}

// A floor that ends at a tile's border, and a wall behind it: it is further away than every point of the
// floor's samples. Some are blocked for all that: they are compared at a pixel's centre, where a plane
// through them lies behind the wall.
TEST_F(OpenTiles, AWallBehindAllSamplesIsSeen) {
    constexpr gpu::Extent extent{16, 96};
    constexpr std::uint32_t end = 56;  // the first row of the floor, at depth 11.7
    Settings settings = with_radius(quick(Settings{}), 0.3F);
    settings.own.range = 50.0F;
    settings.samples = settings.samples_converged = 256;
    settings.filter = Filter::none;
    std::uint64_t open = 0;
    float most = 0.0F;
    for (float behind = 12.1F; behind < 13.6F; behind += 0.1F) {
        SCOPED_TRACE(behind);
        scene::GBuffer view = wall(extent, behind);
        const float row = 2.0F / (96.0F * std::abs(view.camera.p00_p11().y));
        for (std::uint32_t i = end * extent.width; i < extent.width * extent.height; ++i) {
            view.depth[i] = 1.0F / (row * (static_cast<float>(i / extent.width) - 47.5F));
            view.normal[i] = {0, 1, 0};
        }
        const Frame frame = expect_same({{view, 1}}, settings).front();
        open += frame.work.tiles_open;
        most = std::max(most, *std::max_element(frame.occlusion.begin() + end * extent.width,
                                                frame.occlusion.begin() + (end + 1) * extent.width));
    }
    EXPECT_GT(open, 0U);
    EXPECT_GT(most, 0.1F);
}

TEST_F(OpenTiles, TheUnitOfLengthChangesNoProof) {
    const auto open = [&](float scale) {
        scene::GBuffer view = floor_view({160, 90}, 0.3F);
        for (float& depth : view.depth) depth *= scale;
        const Settings settings = quick(Settings{});
        return run({{view, 1}}, with_radius(settings, scale * settings.radius)).front().work.tiles_open;
    };
    EXPECT_GT(open(1.0F), 0U);
    EXPECT_EQ(open(0x1p-8F), open(1.0F));
}

TEST_F(OpenTiles, APixelThatRisesByMoreThanTheBiasIsSeen) {
    const scene::GBuffer flat = floor_view({160, 90}, 0.0F);
    const Settings settings = quick(Settings{});
    const std::uint64_t open = run({{flat, 1}}, settings).front().work.tiles_open;
    const auto with_spike = [&](float biases) {
        scene::GBuffer view = flat;
        view.depth[60 * 160 + 83] -= biases * settings.bias;
        return expect_same({{view, 3}}, settings).front().work.tiles_open;
    };
    EXPECT_EQ(with_spike(0.1F), open) << "no sample is compared so closely";
    const std::uint64_t with_higher = with_spike(1.05F);
    EXPECT_LT(with_higher, open);
    EXPECT_LE(with_spike(20.0F), with_higher);
}

TEST_F(OpenTiles, SurfacesReadFromTheDepthChainMayLieBeyondTheRadius) {
    Settings settings = with_method(quick(Settings{}), "alchemy");
    const std::vector<Stay> stays{{floor_view({160, 90}, 0.0F), 2}};
    EXPECT_GT(expect_same(stays, settings).front().work.tiles_open, 0U);
    settings.own.mip_distance = 4.0F;
    EXPECT_EQ(expect_same(stays, settings).front().work.tiles_open, 0U);
}

TEST_F(OpenTiles, OfScenes) {
    std::uint64_t open = 0;
    for (const std::string name : {"columns", "far", "moving"}) {
        SCOPED_TRACE(name);
        Settings settings = settings_for(name);
        settings.samples = settings.samples_converged = 16;
        settings.invalidation = Invalidation::none;
        std::vector<Stay> stays;
        for (int i = 0; i < 2; ++i) stays.push_back({view(name, 3 * i, {320, 180})});
        for (const Frame& frame : expect_same(stays, settings)) open += frame.work.tiles_open;
    }
    EXPECT_GT(open, 30U);
}

}  // namespace gloam::effect::tiles_test
