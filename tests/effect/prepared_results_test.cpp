// SPDX-License-Identifier: MIT
// What two of the prepared methods make of their images: area samples, and discs that count by their
// visibility.
#include "effect/methods.hpp"
#include "on_device.hpp"
#include "surface_views.hpp"

namespace gloam::effect::prepared_results_test {

class PreparedResults : public OnDevice<testing::Test> {
  protected:
    // The estimate itself, of `frames` frames that all count alike.
    [[nodiscard]] std::vector<float> estimate(const scene::GBuffer& view, Settings settings,
                                              int frames = 1) const {
        settings.remap_a = 0.0F;
        settings.least_radius = 0.0F;
        settings.filter = Filter::none;
        settings.weight_max = 1e6F;
        settings.samples_converged = settings.samples;
        return run(view, settings, frames).occlusion;
    }
};

Settings settings_for(const char* method, float radius, std::uint32_t samples) {
    Settings settings = with_radius(with_method({}, method), radius);
    settings.samples = samples;
    return settings;
}

// CS-I: a ball at the foot of a slope of angle b is solid to 1/2 + b / (2 pi). No pair is disbelieved, so
// that areas have it whole. Blocks as large as half of the disc hold the foot and the slope both, which no
// interval of heights is like.
TEST_F(PreparedResults, AreasHoldTheBallOfAGroove) {
    const scene::GBuffer view = groove({129, 129});
    const std::size_t middle = 129 * 64 + 64;
    for (const std::uint32_t samples : {2U, 8U, 32U, 2048U}) {
        const int frames = samples < 100 ? 64 : 1;
        const auto found = estimate(view, settings_for("volumetric_area", 0.4F, samples), frames);
        EXPECT_NEAR(double{found[middle]}, 0.625,
                    samples == 2    ? 0.07
                    : samples < 100 ? 0.03
                                    : 0.006)
            << samples;
    }
}

// Ridges one pixel wide: a line sees one of them or none, an area half of them. Pixels turn their samples, so
// lines say something else in each.
TEST_F(PreparedResults, OneAreaSeesWhatOneLineMisses) {
    const gpu::Extent extent{96, 96};
    scene::GBuffer view = view_of(extent, true, [&](glm::dvec2 at) {
        const auto column = static_cast<int>(std::floor((at.x + 1.0) * 48.0));
        return column % 2 == 0 ? 5.0 : 4.9;
    });
    const auto spread = [&](const char* method) {
        const auto found = estimate(view, settings_for(method, 0.5F, 2));
        double sum = 0.0;
        double squares = 0.0;
        int count = 0;
        for (std::size_t y = 30; y < 66; ++y) {
            for (std::size_t x = 30; x < 66; x += 2) {  // in the troughs
                sum += double{found[96 * y + x]};
                squares += std::pow(double{found[96 * y + x]}, 2.0);
                ++count;
            }
        }
        return std::sqrt(std::max(squares / count - std::pow(sum / count, 2.0), 0.0));
    };
    EXPECT_LT(spread("volumetric_area"), 0.3 * spread("volumetric"));
}

// Where nothing is seen a block is empty: every other column of a floor fills a quarter of a ball, not half.
TEST_F(PreparedResults, AreasAreEmptyWhereNothingIsSeen) {
    scene::GBuffer view = view_of({65, 65}, true, [](glm::dvec2) { return 5.0; });
    for (std::size_t i = 0; i < view.depth.size(); ++i)
        if (i % 65 % 2 == 1) view.depth[i] = infinity;
    const auto found = estimate(view, settings_for("volumetric_area", 0.5F, 2), 16);
    EXPECT_NEAR(double{found[65 * 32 + 32]}, 0.25, 0.01);
}

// The sum over all pixels, each as a disc by its own visibility (CS-S). Orthographic, so that all discs are
// alike but for their slope.
double sum_of_discs(const scene::GBuffer& view, const std::vector<float>& occlusion, glm::ivec2 pixel,
                    double radius) {
    const auto width = static_cast<int>(view.extent.width);
    const auto height = static_cast<int>(view.extent.height);
    const double side = view_height / height;
    const auto at = [&](glm::ivec2 p) { return static_cast<std::size_t>(width * p.y + p.x); };
    const auto position = [&](glm::ivec2 p) {
        return glm::dvec3(side * p.x, -side * p.y, -double{view.depth[at(p)]});
    };
    const glm::dvec3 normal(view.normal[at(pixel)]);
    double sum = 0.0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const glm::dvec3 v = position({x, y}) - position(pixel);
            const double squared = glm::dot(v, v);
            if (glm::ivec2(x, y) == pixel || squared > radius * radius || glm::dot(v, normal) <= 1e-3)
                continue;
            const glm::dvec3 emitter(view.normal[at({x, y})]);
            const double area = side * side / std::max(emitter.z, 0.05);
            const double cosines =
                std::max(-glm::dot(emitter, v), 0.0) * std::max(glm::dot(normal, v), 0.0) / squared;
            const double visibility = 1.0 - double{occlusion[at({x, y})]};
            sum += visibility * cosines * area / (area + std::numbers::pi * squared);
        }
    }
    return std::min(sum, 1.0);
}

// A trench: its walls face one another, its floor lies between them.
scene::GBuffer trench(gpu::Extent extent) {
    const auto wall = [](double x) { return std::clamp(3.0 * (std::abs(x) - 0.1), 0.0, 0.6); };
    scene::GBuffer view = view_of(extent, true, [&](glm::dvec2 at) { return 5.0 - wall(at.x); });
    const double side = view_height / extent.height;
    for (std::size_t i = 0; i < view.depth.size(); ++i) {
        const double x = side * (static_cast<double>(i % extent.width) + 0.5 - 0.5 * extent.width);
        const bool slope = std::abs(x) > 0.1 && std::abs(x) < 0.3;
        view.normal[i] = glm::normalize(glm::vec3(slope ? (x > 0.0 ? -3.0F : 3.0F) : 0.0F, 0.0F, 1.0F));
    }
    return view;
}

TEST_F(PreparedResults, DiscsCountByTheirVisibility) {
    const scene::GBuffer view = trench({64, 64});
    const auto first = estimate(view, settings_for("disc_proxy", 0.7F, 2048), 4);
    const auto second = estimate(view, settings_for("disc_proxy_two", 0.7F, 2048), 8);
    const std::vector<float> open(first.size(), 0.0F);
    double taken_back = 0.0;
    for (const glm::ivec2 pixel : {glm::ivec2(32, 32), {30, 31}, {36, 30}, {38, 33}, {26, 32}, {50, 32}}) {
        const auto index = static_cast<std::size_t>(64 * pixel.y + pixel.x);
        const double all = sum_of_discs(view, open, pixel, 0.7);
        const double weighted = sum_of_discs(view, first, pixel, 0.7);
        EXPECT_NEAR(double{first[index]}, all, 0.01 + 0.05 * all) << pixel.x;
        EXPECT_NEAR(double{second[index]}, weighted, 0.01 + 0.05 * weighted) << pixel.x;
        taken_back = std::max(taken_back, all - weighted);
    }
    EXPECT_GT(taken_back, 0.05);
}

// MSSAO on its real passes: what its coarser resolutions see, and how they are combined.

Settings settings_of(float radius) {
    return with_radius(with_method(preset_named("tssao-paper").settings, "mssao"), radius);
}

class MultiResolution : public OnDevice<testing::Test> {};

// A block stands 20 pixels from the middle, beyond the reach of the finest kernel alone.
TEST_F(MultiResolution, CoarserLevelsReachFurther) {
    scene::GBuffer view = view_of({129, 65}, true, [](glm::dvec2 at) { return at.x > 0.62 ? 4.6 : 5.0; });
    Settings settings = settings_of(0.9F);
    std::vector<float> at_the_middle;
    for (const std::uint32_t resolutions : {1U, 2U, 3U, 4U, 5U, 9U}) {
        settings.own.steps = resolutions;
        at_the_middle.push_back(run(view, settings, 8).occlusion[129 * 32 + 64]);
    }
    EXPECT_EQ(at_the_middle[0], 0.0F);
    EXPECT_EQ(at_the_middle[1], 0.0F);  // 12 pixels
    EXPECT_GT(at_the_middle[2], 0.004F);
    EXPECT_GT(at_the_middle[4], 0.004F);
}

// A valley in the middle of images of sizes that do and do not halve: its occlusion stays in the middle.
TEST_F(MultiResolution, NothingDriftsWithTheLevels) {
    for (const std::uint32_t width : {64U, 63U, 61U, 67U}) {
        const gpu::Extent extent{width, 31};
        scene::GBuffer view = view_of(extent, true, [](glm::dvec2 at) { return 5.0 - 0.6 * std::abs(at.x); });
        for (std::size_t i = 0; i < view.depth.size(); ++i) {
            const double side = 2.0 * static_cast<double>(i % width) + 1.0 - width;
            view.normal[i] = glm::normalize(glm::dvec3(-0.6 * glm::sign(side), 0, 1));
        }
        Settings settings = settings_of(0.8F);
        settings.own.range = 1.0F;
        const Frame frame = run(view, settings, 16);
        double sum = 0.0;
        double moment = 0.0;
        for (unsigned y = 10; y < 21; ++y) {
            for (unsigned x = 0; x < width; ++x) {
                const double value = double{frame.occlusion[width * y + x]};
                sum += value;
                moment += value * (x + 0.5 - 0.5 * width);
            }
        }
        EXPECT_GT(sum / (11.0 * width), 0.02);
        EXPECT_LT(std::abs(moment / sum), 0.25) << width;  // pixels
    }
}

// Blocks of 2 x 2 pixels with four depths, of which the middle two lie on a diagonal: their mean is the
// block's centre. Coarser levels see the plane through these centres, and the finest kernel, of 6 pixels,
// sees neither.
TEST_F(MultiResolution, ATexelIsTheMeanOfItsMiddleTwoDepths) {
    const gpu::Extent extent{132, 68};
    const auto found = [&](float spread) {
        scene::GBuffer view = view_of(extent, true, [](glm::dvec2) { return 5.0; });
        for (unsigned y = 0; y < extent.height; ++y) {
            for (unsigned x = 0; x < extent.width; ++x) {
                const int from_middle = std::max(std::abs(static_cast<int>(x - x % 2) - 66),
                                                 std::abs(static_cast<int>(y - y % 2) - 34));
                const int order = static_cast<int>(2 * (y % 2) + x % 2);
                if (from_middle > 10)
                    view.depth[extent.width * y + x] = 4.7F + spread * (static_cast<float>(order) - 1.5F);
            }
        }
        Settings settings = settings_of(0.9F);
        settings.own.range = 1.0F;
        settings.own.steps = 2;
        return double{run(view, settings, 8).occlusion[extent.width * 34 + 66]};
    };
    const double plane = found(0.0F);
    EXPECT_GT(plane, 0.004);
    EXPECT_NEAR(found(0.1F), plane, 1e-5);
}

// One pixel of each block of four is far away. The blocks' surfaces are the plane of the others, and have the
// radius that the cap leaves at its depth, not that of the far pixel.
TEST_F(MultiResolution, TheCapOfACoarserLevelIsThatOfItsSurface) {
    const gpu::Extent extent{132, 68};
    const float tan_half = 1.0F / view_of(extent, false, [](glm::dvec2) { return 1.0; }).camera.p00_p11().y;
    scene::GBuffer view = view_of(extent, false, [](glm::dvec2 at) { return at.x > 0.05 ? 0.9 : 1.0; });
    for (unsigned y = 1; y < extent.height; y += 2)
        for (unsigned x = 1; x < extent.width; x += 2) view.depth[extent.width * y + x] = 20.0F;
    Settings settings = settings_of(0.4F);
    settings.own.steps = 2;
    Settings capped = settings;
    capped.radius = 2.0F;
    capped.radius_cap = 0.4F * 34.0F / std::abs(tan_half);  // pixels of 0.4 at depth 1
    const Frame want = run(view, settings, 4);
    const Frame found = run(view, capped, 4);
    double largest = 0.0;
    for (unsigned y = 0; y < extent.height; y += 2) {
        for (unsigned x = 0; x < 66; x += 2) {
            const std::size_t pixel = extent.width * y + x;
            EXPECT_NEAR(found.occlusion[pixel], want.occlusion[pixel], 2e-3) << x << ' ' << y;
            largest = std::max(largest, double{want.occlusion[pixel]});
        }
    }
    EXPECT_GT(largest, 0.02);
}

}  // namespace gloam::effect::prepared_results_test
