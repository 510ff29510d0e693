// SPDX-License-Identifier: MIT
// The estimators of a pixel on synthetic depth images.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "gathers.hpp"
#include "support/lab.hpp"

namespace gloam::gather_test {

constexpr float infinity = std::numeric_limits<float>::infinity();

using test::Camera;
using test::Gather;
using test::Method;
using test::Samples;

// Of a method that reads one length.
Method of_length(float length) {
    return {.range = length, .epsilon = length};
}

check::ImageSet depth_image(glm::ivec2 size, const std::function<float(glm::ivec2)>& depth) {
    return {{"gloam_fetch_depth", check::make_image<float>(size, depth)}};
}

class Gathering : public testing::Test {
  protected:
    test::MethodFunctions functions;
    check::Lab lab = functions.lab();
    check::Kernel<Gather> hemisphere{lab, functions.file("hemisphere"), effect::method_function};
    check::Kernel<Gather> disc{lab, functions.file("disc"), effect::method_function};
};

// A plane through (0, 0, -5) with the given normal.
struct Plane {
    glm::dvec3 normal;
    Camera camera;

    glm::dvec3 point(glm::ivec2 pixel) const {
        const glm::dvec2 size(camera.size);
        const glm::dvec2 ndc = (2.0 * glm::dvec2(pixel) + 1.0 - size) / size;
        const glm::dvec2 side = ndc / glm::dvec2(camera.p00_p11);
        const double at_five = -5.0 * normal.z;
        if (camera.orthographic) {
            return {side, (at_five - normal.x * side.x - normal.y * side.y) / normal.z};
        }
        const glm::dvec3 ray(side, -1.0);
        return ray * (at_five / glm::dot(ray, normal));
    }
    check::ImageSet image() const {
        return depth_image(camera.size, [this](glm::ivec2 p) { return static_cast<float>(-point(p).z); });
    }
    // Every pixel with the given samples.
    std::vector<std::tuple<glm::vec3, glm::vec3, Camera, Samples, Method>> inputs(const Samples& samples,
                                                                                  float last) const {
        std::vector<std::tuple<glm::vec3, glm::vec3, Camera, Samples, Method>> all;
        for (int y = 0; y < camera.size.y; ++y) {
            for (int x = 0; x < camera.size.x; ++x) {
                all.emplace_back(glm::vec3(point({x, y})), glm::vec3(normal), camera, samples,
                                 of_length(last));
            }
        }
        return all;
    }
};

TEST_F(Gathering, NothingBlocksAPlane) {
    for (const bool orthographic : {false, true}) {
        for (const glm::dvec3 normal : {glm::dvec3(0, 0, 1), glm::normalize(glm::dvec3(0.4, -0.2, 1)),
                                        glm::normalize(glm::dvec3(0.8, -0.5, 1))}) {
            const glm::vec2 scale = orthographic ? glm::vec2(0.4F, -0.5F) : glm::vec2(1.5F, -2.0F);
            const Plane plane{normal, {scale, glm::ivec2(33, 24), orthographic}};
            const Samples samples{.radius = 0.7F, .bias = 1e-4F, .angle = 1.0F, .first = 0, .count = 32};
            for (const glm::vec2 sum : hemisphere(plane.inputs(samples, 0.7F), plane.image())) {
                EXPECT_EQ(sum, glm::vec2(0, 32)) << orthographic << normal.x;
            }
            const Samples taps{.radius = 0.7F, .bias = 1e-5F, .angle = 1.0F, .first = 0, .count = 32};
            for (const glm::vec2 sum : disc(plane.inputs(taps, 0.1F), plane.image())) {
                EXPECT_EQ(sum, glm::vec2(0, 32)) << orthographic << normal.x;
            }
        }
    }
}

// The eye looks along the normal at a ceiling: a sample is blocked where it lies behind what is seen.
TEST_F(Gathering, CeilingByAKernelOfUniformRadii) {
    const Camera camera{glm::vec2(1, -1), glm::ivec2(8, 8), false};
    const auto ceiling = depth_image(camera.size, [](glm::ivec2) { return 5.25F; });
    std::vector<std::tuple<glm::vec3, glm::vec3, Camera, Samples, Method>> inputs;
    constexpr unsigned batches = 256;
    constexpr unsigned batch = 256;
    for (unsigned b = 0; b < batches; ++b) {
        const Samples samples{.radius = 1.0F,
                              .bias = 0.0F,
                              .angle = 0.1F * static_cast<float>(b),
                              .first = b * batch,
                              .count = batch};
        inputs.emplace_back(glm::vec3(0, 0, -5), glm::vec3(0, 0, -1), camera, samples, of_length(infinity));
    }
    double sum = 0.0;
    for (const glm::vec2 part : hemisphere(inputs, ceiling)) {
        EXPECT_EQ(part.y, 256.0F);
        sum += static_cast<double>(part.x);
    }
    EXPECT_NEAR(sum / (batches * batch), 0.5625, 4 * 0.5 / 256);
}

TEST_F(Gathering, StepThatRisesBesideThePoint) {
    // The right half of the image is nearer by 0.3: only samples on that side can be blocked.
    const Camera camera{glm::vec2(2, -2), glm::ivec2(64, 64), false};
    const auto image = depth_image(camera.size, [](glm::ivec2 p) { return p.x < 32 ? 5.0F : 4.7F; });
    const Samples samples{.radius = 0.5F, .bias = 0.005F, .angle = 0.0F, .first = 0, .count = 64};
    const auto occlusion = [&](const auto& gather, float x, float last) {
        const glm::vec2 sum = gather.with_images(
            image, {glm::vec3(x, 0.04F, -5), glm::vec3(0, 0, 1), camera, samples, of_length(last)});
        EXPECT_EQ(sum.y, 64.0F);
        return sum.x / sum.y;
    };
    const float beside = occlusion(hemisphere, -0.04F, 0.5F);
    EXPECT_GT(beside, 0.1F);
    EXPECT_LT(beside, 0.5F);
    EXPECT_EQ(occlusion(hemisphere, -0.6F, 0.5F), 0.0F);     // out of reach
    EXPECT_EQ(occlusion(hemisphere, -0.04F, 0.004F), 0.0F);  // the range excludes every blocker
    EXPECT_GT(occlusion(disc, -0.04F, 0.1F), 0.02F);
    EXPECT_EQ(occlusion(disc, -0.6F, 0.1F), 0.0F);
}

TEST_F(Gathering, BackgroundNeverBlocks) {
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(3, 3), glm::ivec2(7, 5)}) {
        const Camera camera{glm::vec2(1, -1), size, false};
        const Samples samples{.radius = 0.5F, .bias = 0.0F, .angle = 0.0F, .first = 0, .count = 16};
        for (const float background : {infinity, 0.0F, -1.0F, NAN}) {
            const auto image = depth_image(size, [&](glm::ivec2) { return background; });
            for (const auto* gather : {&hemisphere, &disc}) {
                const auto at = [&](float depth) {
                    return gather->with_images(image, {glm::vec3(0, 0, -depth), glm::vec3(0, 0, 1), camera,
                                                       samples, of_length(1.0F)});
                };
                EXPECT_EQ(at(5.0F), glm::vec2(0, 16));
                EXPECT_EQ(at(background), glm::vec2(0));
            }
        }
    }
}

TEST_F(Gathering, WhatCannotBeSampledIsNotCounted) {
    const Camera camera{glm::vec2(1, -1), glm::ivec2(4, 4), false};
    const auto image = depth_image(camera.size, [](glm::ivec2) { return 0.5F; });
    const auto run = [&](glm::vec3 position, glm::vec3 normal, float radius, unsigned count) {
        const Samples samples{.radius = radius, .bias = 0.01F, .angle = 0.0F, .first = 0, .count = count};
        return hemisphere.with_images(image, {position, normal, camera, samples, of_length(infinity)});
    };
    const glm::vec3 near_eye(0, 0, -0.5F);
    const glm::vec2 partly =
        run(near_eye, glm::vec3(0, 0, 1), 2.0F, 64);  // part of the half ball is behind the eye
    EXPECT_EQ(partly.x, 0.0F);
    EXPECT_GT(partly.y, 8.0F);
    EXPECT_LT(partly.y, 56.0F);
    EXPECT_EQ(run(near_eye, glm::vec3(0, 0, 1), 0.25F, 64), glm::vec2(0, 64));
    EXPECT_EQ(run(near_eye, glm::vec3(0, 0, 1), 0.25F, 0), glm::vec2(0));
    EXPECT_EQ(run(near_eye, glm::vec3(0), 0.25F, 64), glm::vec2(0));
    EXPECT_EQ(run(near_eye, glm::vec3(NAN), 0.25F, 64), glm::vec2(0));
    EXPECT_EQ(run(near_eye, glm::vec3(0, 0, 1), 0.0F, 64), glm::vec2(0));
    EXPECT_EQ(run(near_eye, glm::vec3(0, 0, 1), NAN, 64), glm::vec2(0));
    EXPECT_EQ(run(glm::vec3(0, 0, 1), glm::vec3(0, 0, 1), 0.25F, 64), glm::vec2(0));
}

// Any radius, at any depth: taps outside read the edge, and a fetch outside the image would be a fault.
TEST_F(Gathering, LargeKernelsStayInTheImage) {
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(3, 1), glm::ivec2(5, 7)}) {
        const Camera camera{glm::vec2(1, -1), size, false};
        const auto image =
            depth_image(size, [](glm::ivec2 p) { return 2.0F + 0.1F * static_cast<float>(p.x); });
        for (const float radius : {0.01F, 1.0F, 100.0F, 1e30F}) {
            const Samples samples{.radius = radius, .bias = 0.001F, .angle = 2.0F, .first = 100, .count = 64};
            for (const auto* gather : {&hemisphere, &disc}) {
                glm::vec2 sum(0);
                EXPECT_NO_THROW(sum =
                                    gather->with_images(image, {glm::vec3(0.1F, 0.2F, -2), glm::vec3(0, 0, 1),
                                                                camera, samples, of_length(infinity)}));
                EXPECT_LE(sum.x, sum.y);
                EXPECT_LE(sum.y, 64.0F);
            }
        }
    }
}

}  // namespace gloam::gather_test
