// SPDX-License-Identifier: MIT
// What two of the prepared methods make of their images: area samples, and discs that count by their
// visibility.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/methods.hpp"
#include "on_device.hpp"
#include "scene/rasterize.hpp"
#include "surface_views.hpp"

namespace gloam::effect {
namespace prepared_results_test {

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
        AmbientOcclusion& effect = effect_for(view.extent);
        effect.begin(view, settings);
        for (int i = 1; i < frames; ++i) (void)effect.next();
        return effect.next().occlusion;
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
        const int frames = samples < 100 ? 256 : 1;
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
    view.normal.assign(view.depth.size(), glm::vec3(0, 0, 1));
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
    view.normal.assign(view.depth.size(), glm::vec3(0, 0, 1));
    for (std::size_t i = 0; i < view.depth.size(); ++i)
        if (i % 65 % 2 == 1) view.depth[i] = std::numeric_limits<float>::infinity();
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
        view.normal.emplace_back(
            glm::normalize(glm::vec3(slope ? (x > 0.0 ? -3.0F : 3.0F) : 0.0F, 0.0F, 1.0F)));
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

}  // namespace prepared_results_test
}  // namespace gloam::effect
