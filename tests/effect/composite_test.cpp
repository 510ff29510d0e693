// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include "backend/vulkan/commands.hpp"
#include "backend/vulkan/resources.hpp"
#include "effect/composite.hpp"
#include "effect/internal/passes.hpp"
#include "effect/internal/steps.hpp"
#include "on_device.hpp"
#include "reference/geometry_camera.hpp"
#include "reference/temporal.hpp"
#include "scene/rasterize.hpp"
#include "support/matchers.hpp"

namespace gloam::effect::composite_test {

class CompositePass : public OnDevice<testing::Test> {
  protected:
    Composite composite_{device_, passes_};
};

// ISSAO-2 and direct light, in an image whose sides are no multiples of a group's.
TEST_F(CompositePass, OcclusionDarkensTheAmbientLightAlone) {
    const gpu::Extent extent{37, 21};
    const scene::GBuffer view = rasterized("corner", extent, {.color = true});
    const scene::SplitLight light = scene::light_of(view, nullptr);
    const auto open = composite_.lit(extent, light, {});
    const auto quarter = composite_.lit(extent, light, std::vector<float>(open.size(), 0.25F));
    const auto closed = composite_.lit(extent, light, std::vector<float>(open.size(), 1.0F));
    ASSERT_EQ(open.size(), view.depth.size());
    float brightest = 0.0F;
    for (std::size_t i = 0; i < open.size(); ++i) {
        brightest = std::max(brightest, light.ambient[i].x);
        for (int c = 0; c < 3; ++c) {
            EXPECT_FLOAT_EQ(open[i][c], light.direct[i][c] + light.ambient[i][c]);
            EXPECT_FLOAT_EQ(quarter[i][c], light.direct[i][c] + 0.75F * light.ambient[i][c]);
            EXPECT_FLOAT_EQ(closed[i][c], light.direct[i][c]);
        }
    }
    EXPECT_GT(brightest, 0.1F);
}

// Each pixel has its own occlusion. Values outside [0, 1] are clamped, and NaN counts as 0.
TEST_F(CompositePass, EachPixelHasItsOwnOcclusion) {
    const scene::SplitLight light{.ambient = std::vector<glm::vec3>(5, glm::vec3(1, 2, 4)),
                                  .direct = std::vector<glm::vec3>(5, glm::vec3(0.5F, 0, 0))};
    const std::vector<float> occlusion{0.0F, 0.5F, 1.5F, -1.0F, std::nanf("")};
    const auto lit = composite_.lit({5, 1}, light, occlusion);
    EXPECT_EQ(lit[0], glm::vec3(1.5F, 2, 4));
    EXPECT_EQ(lit[1], glm::vec3(1.0F, 1, 2));
    EXPECT_EQ(lit[2], glm::vec3(0.5F, 0, 0));
    EXPECT_EQ(lit[3], glm::vec3(1.5F, 2, 4));
    EXPECT_EQ(lit[4], glm::vec3(1.5F, 2, 4));
}

TEST_F(CompositePass, RefusesImagesOfAnotherSize) {
    const scene::SplitLight light{.ambient = std::vector<glm::vec3>(6), .direct = std::vector<glm::vec3>(6)};
    const auto with = [&](gpu::Extent extent, std::size_t occlusions) {
        return
            [&, extent, occlusions] { (void)composite_.lit(extent, light, std::vector<float>(occlusions)); };
    };
    EXPECT_THAT(with({3, 2}, 4), ThrowsMessage<std::invalid_argument>(HasSubstr("4 occlusions")));
    EXPECT_THAT(with({3, 3}, 0),
                ThrowsMessage<std::invalid_argument>(HasSubstr("6 pixels with ambient light")));
}

// What the pass that moves the history keeps of the motion of objects.

constexpr glm::ivec2 size(16, 8);
constexpr std::size_t pixels = 16 * 8;
constexpr float unit = 1e-4F;
constexpr glm::vec2 p00_p11(1.5F, -2.0F);

float depth_at(std::size_t pixel) {
    return 2.0F + 0.25F * static_cast<float>(pixel % 5);
}

class DisplacementPass : public OnDevice<testing::Test> {
  protected:
    DisplacementPass()
        : moved_camera_(glm::rotate(glm::translate(glm::dmat4(1.0), {0.3, -0.2, 0.5}), 0.4,
                                    glm::normalize(glm::dvec3(1.0, 2.0, -0.5)))) {}

    // Where the point of a pixel was, if it has moved by `displacement` besides the camera.
    [[nodiscard]] glm::vec3 previous_of(std::size_t pixel, const glm::dvec3& displacement) const {
        const glm::ivec2 at(static_cast<int>(pixel) % size.x, static_cast<int>(pixel) / size.x);
        const reference::GloamCamera camera{p00_p11, size, false};
        const glm::dvec3 now = reference::gloam_camera_position(at, double{depth_at(pixel)}, camera);
        return moved_camera_ * glm::dvec4(now + displacement, 1.0);
    }

    // The codes that the pass keeps of points that were at `previous`.
    [[nodiscard]] std::vector<std::uint32_t> kept(const std::vector<glm::vec3>& previous) const {
        using enum gpu::Format;
        const gpu::Extent extent{16, 8};
        gpu::Image depth(device_, extent, r32f);
        gpu::Image positions(device_, extent, rgba32f);
        gpu::Image history(device_, extent, rgba32f);
        const gpu::Image after(device_, extent, rgba32f);
        const gpu::Image displacement(device_, extent, r32ui);
        const gpu::Buffer no_list(device_, 128);
        std::vector<float> depths;
        std::vector<float> texels;
        for (std::size_t i = 0; i < pixels; ++i) {
            depths.push_back(depth_at(i));
            texels.insert(texels.end(), {previous[i].x, previous[i].y, previous[i].z, 0.0F});
        }
        depth.upload(depths);
        positions.upload(texels);
        history.upload(std::vector<float>(4 * pixels, 0.0F));
        const ReprojectionParameters parameters{.previous_from_current = glm::mat4(moved_camera_),
                                                .p00_p11 = p00_p11,
                                                .previous_p00_p11 = p00_p11,
                                                .size = size,
                                                .tolerance = 0.1F,
                                                .displacement_unit = unit};
        Moment moment{.has_positions = true};
        moment.view.camera = moment.before.camera = scene::make_frame({}, 2.0);
        const gpu::ComputePipeline pass = pipeline_of(device_, passes_, reprojection_source(moment));
        gpu::Commands commands(device_);
        commands.dispatch(pass,
                          std::vector<gpu::Resource>{depth, positions, history, after, no_list, displacement},
                          {2, 1, 1}, std::as_bytes(std::span(&parameters, 1)));
        commands.submit();
        std::vector<std::uint32_t> codes;
        for (const float texel : displacement.download())
            codes.push_back(std::bit_cast<std::uint32_t>(texel));
        return codes;
    }

    glm::dmat4 moved_camera_;
};

TEST_F(DisplacementPass, WhatOnlyTheCameraMovesHasNone) {
    std::vector<glm::vec3> previous;
    for (std::size_t i = 0; i < pixels; ++i) previous.push_back(previous_of(i, glm::dvec3(0.0)));
    EXPECT_EQ(kept(previous), std::vector<std::uint32_t>(pixels, 0));
}

TEST_F(DisplacementPass, ItIsTheMotionOfThePointInThisView) {
    std::vector<glm::dvec3> displacements;
    std::vector<glm::vec3> previous;
    for (std::size_t i = 0; i < pixels; ++i) {
        const auto k = static_cast<double>(i);
        displacements.emplace_back(0.001 * k, 0.3 - 0.004 * k, (i % 3 == 0) ? -2.0 : 0.02);
        previous.push_back(previous_of(i, displacements[i]));
    }
    const std::vector<std::uint32_t> codes = kept(previous);
    for (std::size_t i = 0; i < pixels; ++i) {
        const glm::dvec3 found = reference::gloam_displacement_from_code(codes[i], double{unit});
        const glm::dvec3 wanted = displacements[i];
        const double largest = std::max({std::abs(wanted.x), std::abs(wanted.y), std::abs(wanted.z)});
        const double rounding = std::max(0.5 * double{unit}, largest / 256.0) + 3e-6;
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], wanted[c], rounding) << i << ", " << c;
    }
}

TEST_F(DisplacementPass, WhatIsNotFiniteHasMovedFar) {
    std::vector<glm::vec3> previous(pixels, glm::vec3(std::numeric_limits<float>::quiet_NaN()));
    previous[1] = glm::vec3(std::numeric_limits<float>::infinity(), 0.0F, -1.0F);
    EXPECT_EQ(kept(previous), std::vector<std::uint32_t>(pixels, 0xFBFDFEFFU));
}

}  // namespace gloam::effect::composite_test
