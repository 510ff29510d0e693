// SPDX-License-Identifier: MIT
// The filters that the setting `filter` chooses from: the pass alone, on images made for it, and in the
// effect.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/errors.hpp"
#include "effect/internal/passes.hpp"
#include "effect/internal/steps.hpp"
#include "effect/methods.hpp"
#include "effect/settings.hpp"
#include "filter_passes.hpp"
#include "on_device.hpp"
#include "reference/filter.hpp"
#include "reference/geometry_camera.hpp"
#include "reference/temporal.hpp"
#include "scene/rasterize.hpp"
#include "scene/scene.hpp"
#include "support/matchers.hpp"

namespace gloam::effect::filters_test {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr int default_half_width = 3;

std::vector<std::string> names() {
    std::vector<std::string> all = setting_named("filter").choices;
    all.erase(all.begin());
    return all;
}

class Filters : public OnDevice<testing::TestWithParam<std::string>> {
  protected:
    [[nodiscard]] Settings settings(int half_width = Settings{}.filter_half_width) const {
        Settings chosen;
        set(chosen, "filter", GetParam());
        chosen.filter_half_width = half_width;
        return chosen;
    }

    // The field's occlusion after the pass along x and then along y; all pixels have converged alike.
    [[nodiscard]] std::vector<float> filtered(const Field& field, int half_width = default_half_width) const {
        if (!pair_ || half_width_ != half_width) pair_.emplace(pair_for(half_width));
        half_width_ = half_width;
        return run_filter(device_, *pair_, field, {}, gpu::Format::rgba32f);
    }

  private:
    [[nodiscard]] FilterPair pair_for(int half_width) const {
        const auto pass = [&](bool along_y) {
            Moment moment{.settings = settings(half_width)};
            moment.view.camera = scene::make_frame({}, 1.0);
            return pipeline_of(device_, passes_, filter_source(moment, along_y));
        };
        return {pass(false), pass(true), {tile_side * filter_tiles, tile_side}};
    }

    mutable std::optional<FilterPair> pair_;
    mutable int half_width_ = 0;
};

TEST_P(Filters, AConstantStaysWhatItIs) {
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(3, 3), glm::ivec2(17, 9), glm::ivec2(1, 23)}) {
        Field field = random_field(size, 0.3F);
        field.occlusion.assign(field.occlusion.size(), 0.3F);
        EXPECT_EQ(filtered(field), field.occlusion);
    }
}

TEST_P(Filters, SmoothsWithinWhatItSees) {
    const Field field = random_field({33, 21}, 0.01F);
    const std::vector<float> result = filtered(field);
    const auto variance = [](const std::vector<float>& image) {
        double sum = 0.0;
        double squares = 0.0;
        for (const float v : image) sum += double{v};
        const double mean = sum / static_cast<double>(image.size());
        for (const float v : image) squares += (double{v} - mean) * (double{v} - mean);
        return squares / static_cast<double>(image.size());
    };
    EXPECT_LT(variance(result), 0.5 * variance(field.occlusion));
    const auto [low, high] = std::ranges::minmax(field.occlusion);
    EXPECT_THAT(result, Each(AllOf(testing::Ge(low), testing::Le(high))));
}

// A step of depth between surfaces that face different ways, and background between others.
TEST_P(Filters, NothingLeaksOverAnEdge) {
    Field field = random_field({24, 16}, 0.0F);
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 24; ++x) {
            const std::size_t i = field.at({x, y});
            const bool near = x < 10;
            field.occlusion[i] = near ? 0.0F : 1.0F;
            field.depth[i] = near ? 1.0F : 100.0F;
            field.normal[i] = near ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
            if (y != 7) continue;
            field.depth[i] = inf;
            field.occlusion[i] = 0.5F;
        }
    }
    const std::vector<float> result = filtered(field);
    for (std::size_t i = 0; i < result.size(); ++i) ASSERT_NEAR(result[i], field.occlusion[i], 1e-4) << i;
}

// For every representation of background and any distance of neighbouring surfaces: nothing flows from
// background to surfaces or back.
TEST_P(Filters, BackgroundKeepsItsValueAndLendsItToNobody) {
    for (const float background : {0.0F, -1.0F, inf, std::numeric_limits<float>::quiet_NaN()}) {
        Field field = random_field({19, 11}, 0.0F);
        for (std::size_t i = 0; i < field.depth.size(); ++i) {
            const bool surface = i % 5 != 0;
            field.depth[i] = surface ? 0.01F : background;
            field.occlusion[i] = surface ? 0.25F : 0.75F;
        }
        EXPECT_EQ(filtered(field), field.occlusion) << background;
    }
}

TEST_P(Filters, WithoutNeighboursItIsNotThere) {
    const Field field = random_field({19, 11}, 0.1F);
    EXPECT_EQ(filtered(field, 0), field.occlusion);
}

INSTANTIATE_TEST_SUITE_P(Every, Filters, testing::ValuesIn(names()),
                         [](const auto& name) { return name.param; });

// One axis at a time, as the pass goes.
using OneAxis = std::function<double(const Field&, glm::ivec2 pixel, glm::ivec2 axis)>;

std::vector<float> by_reference(Field field, const OneAxis& along) {
    for (const glm::ivec2 axis : {glm::ivec2(1, 0), glm::ivec2(0, 1)}) {
        std::vector<float> next;
        for (int y = 0; y < field.size.y; ++y)
            for (int x = 0; x < field.size.x; ++x)
                next.push_back(static_cast<float>(along(field, {x, y}, axis)));
        field.occlusion = next;
    }
    return field.occlusion;
}

class GeometryFilter : public Filters {};

TEST_P(GeometryFilter, IsItsReference) {
    const Field field = random_field({21, 13}, 0.3F);
    const FilterConstants parameters;
    const std::vector<float> expected =
        by_reference(field, [&](const Field& f, glm::ivec2 pixel, glm::ivec2 axis) {
            const double scale = double{parameters.depth_scale};
            return reference::gloam_geometry_blur(
                pixel, axis, f.size, default_half_width, {10.0, 0.5},
                [&](glm::ivec2 p) { return double{f.occlusion[f.at(p)]}; },
                [&](glm::ivec2 p) { return double{f.depth[f.at(p)]} / scale; },
                [&](glm::ivec2 p) { return glm::dvec3(f.normal[f.at(p)]); });
        });
    EXPECT_THAT(filtered(field), testing::Pointwise(testing::FloatNear(2e-5F), expected));
}

INSTANTIATE_TEST_SUITE_P(The, GeometryFilter, testing::Values("geometry"));

class BilateralFilter : public Filters {};

TEST_P(BilateralFilter, IsItsReference) {
    const Field field = random_field({21, 13}, 0.3F);
    const FilterConstants parameters;
    const std::vector<float> expected =
        by_reference(field, [&](const Field& f, glm::ivec2 pixel, glm::ivec2 axis) {
            return reference::gloam_bilateral_filter(
                pixel, default_half_width * axis, f.size, double{parameters.sigma_pixels},
                double{parameters.depth_scale}, [&](glm::ivec2 p) { return double{f.occlusion[f.at(p)]}; },
                [&](glm::ivec2 p) { return double{f.depth[f.at(p)]}; });
        });
    EXPECT_THAT(filtered(field), testing::Pointwise(testing::FloatNear(1e-5F), expected));
}

INSTANTIATE_TEST_SUITE_P(The, BilateralFilter, testing::Values("bilateral"));

class ConvergenceFilter : public Filters {};

TEST_P(ConvergenceFilter, IsItsReference) {
    const Field field = random_field({21, 13}, 0.3F);
    const FilterConstants parameters;
    const double converged = reference::gloam_convergence(50.0, double{parameters.weight_max});
    const reference::GloamCamera camera{{1.0, -1.0}, field.size, false};
    const std::vector<float> expected =
        by_reference(field, [&](const Field& f, glm::ivec2 pixel, glm::ivec2 axis) {
            const double sigma =
                reference::gloam_filter_sigma(double{f.depth[f.at(pixel)]}, 1.0,
                                              static_cast<double>(f.size.y), double{parameters.sigma_pixels});
            return reference::gloam_convergence_filter(
                pixel, axis, f.size, default_half_width, double{parameters.c_adaptive}, sigma,
                [&](glm::ivec2 p) { return glm::dvec2(double{f.occlusion[f.at(p)]}, converged); },
                [&](glm::ivec2 p) {
                    return reference::gloam_camera_position(p, double{f.depth[f.at(p)]}, camera);
                });
        });
    EXPECT_THAT(filtered(field), testing::Pointwise(testing::FloatNear(1e-5F), expected));
}

INSTANTIATE_TEST_SUITE_P(The, ConvergenceFilter, testing::Values("convergence"));

class SaoFilter : public Filters {};

// Along a row at one depth: nine taps, every other pixel, with the paper's weights.
TEST_P(SaoFilter, ReadsEveryOtherPixelFourTimes) {
    Field field = random_field({25, 1}, 0.0F);
    field.occlusion.assign(field.occlusion.size(), 0.0F);
    field.occlusion[12] = 1.0F;
    const std::vector<float> result = filtered(field, 64);
    const std::vector<double> g{0.153170, 0.144893, 0.122649, 0.092902, 0.062970};
    const double sum = g[0] + 2.0 * (1.2 + g[1] + g[2] + g[3] + g[4]);
    for (int x = 0; x < 25; ++x) {
        const int apart = std::abs(x - 12);
        const bool tap = apart % 2 == 0 && apart <= 8;
        if (apart == 0) {
            EXPECT_NEAR(result[12], g[0] / sum, 1e-6);
        } else if (!tap) {
            EXPECT_EQ(result[static_cast<std::size_t>(x)], 0.0F) << x;
        } else if (x - 8 >= 0 && x + 8 < 25) {
            EXPECT_NEAR(result[static_cast<std::size_t>(x)],
                        (0.3 + g[static_cast<std::size_t>(apart / 2)]) / sum, 1e-6)
                << x;
        } else {
            EXPECT_GT(result[static_cast<std::size_t>(x)], 0.0F) << x;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(The, SaoFilter, testing::Values("sao"));

class FiltersInTheEffect : public Filters {};

// Of few samples: with many there is less to smooth than there is to blur.
TEST_P(FiltersInTheEffect, BringTheCornerNearerToItsClosedForm) {
    const scene::GBuffer view = scene::rasterize(device_, passes_, scene::make_scene("corner"), {160, 90});
    const Truth truth = truth_of(view, 1.0, scene::corner_occlusion_at);
    AmbientOcclusion effect(device_, passes_, view.extent);
    Settings few = settings();
    few.samples = 4;
    effect.begin(view, few);
    const Frame frame = effect.next();
    EXPECT_LT(errors_of(frame.filtered, truth).rmse, 0.8 * errors_of(frame.occlusion, truth).rmse);
}

// The history never sees a filter, whatever the camera does.
TEST_P(FiltersInTheEffect, AreForDisplayOnly) {
    const scene::Scene scene = scene::make_scene("moving");
    for (const auto precision :
         {HistoryPrecision::float32, HistoryPrecision::float16, HistoryPrecision::packed}) {
        std::vector<Frame> last;
        for (const char* filter : {GetParam().c_str(), "none"}) {
            Settings chosen = with_radius(Settings{}, static_cast<float>(scene.ao_radius));
            chosen.precision = precision;
            chosen.table_size = 2048;
            set(chosen, "filter", filter);
            for (int i = 0; i < 3; ++i) {
                const scene::GBuffer view =
                    scene::rasterize(device_, passes_, scene, {72, 41}, {.frame = i, .motion = true});
                AmbientOcclusion& effect = effect_for(view.extent);
                i == 0 ? effect.begin(view, chosen) : effect.advance(view);
                Frame frame = effect.next();
                if (i == 2) last.push_back(std::move(frame));
            }
        }
        EXPECT_EQ(last[0].occlusion, last[1].occlusion);
        EXPECT_EQ(last[0].convergence, last[1].convergence);
        EXPECT_EQ(last[1].filtered, last[1].occlusion);
        EXPECT_NE(last[0].filtered, last[0].occlusion);
    }
}

INSTANTIATE_TEST_SUITE_P(Every, FiltersInTheEffect, testing::ValuesIn(names()),
                         [](const auto& name) { return name.param; });

}  // namespace gloam::effect::filters_test
