// SPDX-License-Identifier: MIT
// The frame with tiles: each pixel is swept only where half size varies, and one does not see where.
#include <glm/gtc/packing.hpp>

#include "effect/internal/frame.hpp"
#include "effect/planned_run.hpp"
#include "on_device.hpp"
#include "support/lab.hpp"
#include "support/poison.hpp"
#include "surface_views.hpp"

namespace gloam::effect::tiles_test {

constexpr backend::Extent odd{83, 45};

Settings tiles(const std::string& changes) {
    return with({}, "preset=quality output=r32f bent_normals=on " + changes);
}

class Tiles : public OnDevice<testing::Test> {
  protected:
    void expect_same(const std::vector<scene::GBuffer>& views, const Settings& one, const Settings& other,
                     const char* what) const {
        const std::vector<Frame> left = run(views, one);
        const std::vector<Frame> right = run(views, other);
        for (std::size_t i = 0; i < left.size(); ++i) {
            EXPECT_TRUE(same_bits(left[i].filtered, right[i].filtered, left[i].extent.width)) << what << i;
            EXPECT_EQ(left[i].bent, right[i].bent) << what << i;
        }
        EXPECT_GT(std::ranges::max(left.back().filtered), 0.1F);
    }
};

// Where all tiles are marked it is the frame that sweeps each pixel, and where none is the one at half size,
// to the bit: for each kind of camera, poisoned depth, and in sequences.
TEST_F(Tiles, AreFullSizeOrHalf) {
    std::vector<scene::GBuffer> views = sequence_of("moving", odd, 3);
    std::vector<std::pair<const char*, std::vector<scene::GBuffer>>> cases{{"moving", views}};
    for (const Engine& engine : engines) cases.push_back({engine.depth, {drawn(seen_by(engine), odd)}});
    test::poison(views.back());
    cases.push_back({"poisoned", {views.back()}});
    const Settings all = tiles("radius=0.6 mark=0");
    const Settings none = tiles("radius=0.6 mark=1");
    for (const auto& [name, shown] : cases) {
        expect_same(shown, all, with(all, "resolution=full"), name);
        expect_same(shown, none, with(none, "resolution=half steps=5 samples=10"), name);
    }
}

// More groups of refine, of two tiles each, than a dimension of a dispatch has: 65,535.
TEST_F(Tiles, AreListedInLargeViews) {
    scene::GBuffer view = wall({1, 1}, 1.0F);
    view.extent = {4096, 2176};
    view.normal.clear();
    view.depth.resize(std::size_t{view.extent.width} * view.extent.height);
    for (std::size_t i = 0; i < view.depth.size(); ++i)
        view.depth[i] = 1.0F + 0.001F * static_cast<float>(i % view.extent.width / 5 % 3);
    const Settings all = with({}, "preset=quality radius=0.01 history=off mark=0 steps=1 samples=2");
    const std::vector<float> listed = run(view, all).filtered;
    EXPECT_EQ(listed, run(view, with(all, "resolution=full")).filtered);
    EXPECT_GT(std::ranges::max(listed), 0.05F);
}

// Full-size texels are valid in marked tiles and around them. Nothing else is read of them: neither what is
// no texel, nor one of the right depth with another occlusion.
TEST_F(Tiles, AreAllThatIsRead) {
    const scene::GBuffer& view = drawn("columns", odd);
    const Settings settings = tiles("radius=0.6 history=off");
    const Plan plan = frame_plan(settings, view);
    std::vector<std::vector<subject::Word>> shown;
    for (const subject::Word poison : {0U, 0x7FC00000U, 0xFEFF0000U}) {
        PlanMemory memory(plan, view);
        std::vector<subject::Word>& texels = memory.images.at("full_texels").front().words;
        for (std::size_t i = 0; i < texels.size(); ++i)
            texels[i] =
                poison | (poison == 0xFEFF0000U ? glm::packHalf1x16(view.depth[i] / settings.radius) : 0U);
        std::ranges::fill(memory.images.at("full_bends").front().words, poison);
        effect::run(test::make_lab(), plan, passes_, memory);
        shown.push_back(memory.image("shown").words);
        std::ranges::copy(memory.image("bent").words, std::back_inserter(shown.back()));
    }
    for (const std::vector<subject::Word>& poisoned : shown) EXPECT_EQ(poisoned, shown[0]);
}

// Of neighbours on one surface: squares of how much more one of them differs from the truth than the other,
// in occlusion and in bent normal. First those across the borders of a marked and another tile, then those a
// pixel or two beside.
using Squares = std::array<std::vector<glm::dvec2>, 2>;

void add_seams(const scene::GBuffer& view, const Frame& shown, const Frame& truth, Squares& sums) {
    const auto [width, height] = view.extent;
    const std::uint32_t columns = tiles_of(view.extent).width;
    const auto square = [&](std::size_t p, std::size_t q) {
        const glm::dvec3 bent(shown.bent[p] - truth.bent[p] - shown.bent[q] + truth.bent[q]);
        const float occlusion = shown.filtered[p] - truth.filtered[p] - shown.filtered[q] + truth.filtered[q];
        return glm::dvec2(std::pow(occlusion, 2.0), glm::dot(bent, bent));
    };
    for (const bool down : {false, true})
        for (std::uint32_t y = 3; y + 3 < height; ++y)
            for (std::uint32_t x = 3; x + 3 < width; ++x) {
                if ((down ? y : x) % 8 != 0) continue;
                const std::size_t step = down ? width : 1;
                const std::size_t first = y * std::size_t{width} + x;
                const std::size_t tile = std::size_t{y / 8} * columns + x / 8;
                if (shown.tiles[tile] == shown.tiles[tile - (down ? columns : 1)]) continue;
                for (int away = -2; away <= 2; ++away) {
                    const std::size_t pixel = first + static_cast<std::size_t>(away) * step;
                    if (std::abs(view.depth[pixel] / view.depth[pixel - step] - 1.0F) < 0.01F)
                        sums[away == 0 ? 0 : 1].push_back(square(pixel, pixel - step));
                }
            }
}

// In single frames and in sequences: root mean squares across borders are 1.10 and 1.11, 1.12 and 0.88 of
// those beside.
TEST_F(Tiles, HaveNoSeams) {
    for (const int frames : {1, 6}) {
        Squares sums;
        for (const char* scene : {"columns", "room", "workshop", "stairs", "pipes"}) {
            const std::vector<scene::GBuffer> views = sequence_of(scene, {320, 180}, frames);
            const Settings settings = tiles("radius=0.5");
            const Settings many = with(settings, "resolution=full history=off samples=256");
            const Frame shown = run(views, settings).back();
            add_seams(views.back(), shown, run(views.back(), many), sums);
        }
        const auto root_mean = [](const std::vector<glm::dvec2>& squares) {
            return glm::sqrt(std::accumulate(squares.begin(), squares.end(), glm::dvec2(0.0)) /
                             static_cast<double>(squares.size()));
        };
        const glm::dvec2 across = root_mean(sums[0]);
        const glm::dvec2 beside = root_mean(sums[1]);
        EXPECT_LE(across.x, 1.15 * beside.x) << frames;
        EXPECT_LE(across.y, 1.15 * beside.y) << frames;
    }
}

// A tile that changes sides while the camera moves slowly changes no more than one that stays.
TEST_F(Tiles, ChangeSidesWithoutAStep) {
    constexpr backend::Extent extent{320, 180};
    for (const char* scene : {"workshop", "stairs", "pipes", "canyon", "town", "room"}) {
        const std::vector<scene::GBuffer> views = sequence_of(scene, extent, 12);
        const std::vector<Frame> frames = run(views, tiles("radius=0.5"));
        double staying = 0.0;
        double changing = 0.0;
        for (std::size_t i = 6; i < frames.size(); ++i)
            for (std::size_t pixel = 0; pixel < views[i].depth.size(); ++pixel) {
                const std::size_t tile =
                    pixel / extent.width / 8 * tiles_of(extent).width + pixel % extent.width / 8;
                const bool changed = frames[i].tiles[tile] != frames[i - 1].tiles[tile];
                double& worst = changed ? changing : staying;
                worst = std::max(worst, std::abs(double{frames[i].filtered[pixel]} -
                                                 double{frames[i - 1].filtered[pixel]}));
            }
        EXPECT_LE(changing, 1.2 * staying) << scene;
    }
}

// The mean of the views on which nothing was tuned: Preset::tiles.
TEST_F(Tiles, AreTheShareThatCostsAreCountedFor) {
    if (!std::filesystem::is_directory(scene::installed_meshes())) GTEST_SKIP() << "no package glmark2-data";
    std::map<std::string, std::vector<double>> shares;
    for (const scene::ViewInfo& info : scene::all_views()) {
        if (info.half != "unseen" || info.kind == "motion") continue;
        const scene::Scene scene = scene::make_scene(info.name, scene::installed_meshes());
        if (scene.camera.projection == scene::Projection::orthographic) continue;
        const scene::GBuffer view = drawn(scene, {640, 360});
        for (const char* preset : {"quality", "reference"}) {
            const Settings settings =
                with_radius(preset_named(preset).settings, static_cast<float>(scene.ao_radius));
            shares[preset].push_back(shares_of(run(view, with(settings, "history=off")).tiles).full);
        }
    }
    for (const auto& [preset, all] : shares) {
        EXPECT_EQ(all.size(), 12U);
        EXPECT_NEAR(std::accumulate(all.begin(), all.end(), 0.0) / 12.0, preset_named(preset).tiles, 0.001)
            << preset;
    }
}

}  // namespace gloam::effect::tiles_test
