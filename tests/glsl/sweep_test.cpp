// SPDX-License-Identifier: MIT
// The horizon sweep on a wall, whose occlusion is known in closed form for every falloff.
#include "reference/geometry_camera.hpp"
#include "reference/methods_slices.hpp"
#include "support/lab.hpp"

namespace gloam::sweep_test {

using reference::GloamCamera;
using reference::GloamEstimate;
using reference::GloamKernel;
using reference::GloamSweep;
enum Falloff : unsigned { step, linear, quadratic, cubic };

class SweepOfAWall : public testing::Test {
  protected:
    subject::Lab lab = test::make_lab();
    judge::Function<GloamEstimate(glm::vec3, glm::vec3, GloamCamera, GloamKernel, GloamSweep)> sweep{
        lab, "gloam/methods/sweep.glsl", "gloam_sweep"};

    // A floor that meets a wall at x = 0, both turned by 45 degrees towards the eye, and a point of the floor
    // `away` from the wall. Everything is in units of the radius.
    double measured(double away, Falloff falloff, unsigned steps) const {
        const auto image = image_of([&](int column) { return 5.0 - std::abs(pixel * (column - 512)); });
        const int column = 512 - static_cast<int>(std::lround(away * std::sqrt(0.5) / pixel));
        const double x = pixel * (column - 512);
        const glm::vec3 position(x, 0.0, -(5.0 + x));
        const glm::vec3 normal(std::sqrt(0.5), 0.0, std::sqrt(0.5));
        return occlusion(image, position, normal, GloamSweep{steps, 1.0, falloff});
    }

    // A post of a width that stands free, its front `rise` before a floor that faces the eye, and a point of
    // the floor `away` from it. Everything is in units of the radius.
    double beside_a_post(double away, double width, double rise, double thickness) const {
        const int column = 512 - static_cast<int>(std::lround(away / pixel));
        const auto image = image_of([&](int at) {
            const double x = pixel * (at - 512);
            return x >= 0.0 && x < width ? 5.0 - rise : 5.0;
        });
        const glm::vec3 position(pixel * (column - 512), 0.0, -5.0);
        return occlusion(image, position, glm::vec3(0, 0, 1), GloamSweep{48, thickness, linear});
    }

  private:
    const GloamCamera camera_{glm::dvec2(0.5, -0.5), glm::ivec2(1025, 33), true};
    const double pixel = 4.0 / 1025.0;

    // Depths that depend on the column alone.
    subject::ImageSet image_of(const std::function<double(int)>& depth) const {
        return {{"gloam_fetch_depth", subject::make_image<float>(camera_.size, [&](glm::ivec2 p) {
                     return static_cast<float>(depth(p.x));
                 })}};
    }

    double occlusion(const subject::ImageSet& image, glm::vec3 position, glm::vec3 normal,
                     const GloamSweep& settings) const {
        const GloamKernel kernel{1.0, 1e-5, 0.0, 0, 512 * 2 * settings.steps, infinity};
        return sweep.with_images(image, {position, normal, camera_, kernel, settings}).occlusion;
    }
};

// Cosine-weighted occlusion by an endless wall: c = a / R, s = sqrt(1 - c^2).
double closed_form(double c, Falloff falloff) {
    const double s = std::sqrt(1.0 - c * c);
    const double arc = std::acos(c);
    const double pi = std::acos(-1.0);
    if (falloff == step) return (arc - c * s) / pi;
    if (falloff == linear) return 2.0 / pi * (0.5 * (arc - c * s) - c * (std::acosh(1.0 / c) - s));
    return 2.0 / pi * ((0.5 + c * c) * arc - 1.5 * c * s);
}

TEST_F(SweepOfAWall, IsThatOfTheFalloffInTheLimit) {
    for (const double away : {0.25, 0.5})
        for (const Falloff falloff : {step, linear, quadratic})
            EXPECT_NEAR(measured(away, falloff, 48), closed_form(away, falloff), 0.006)
                << away << ", falloff " << falloff;
}

// A post that is narrower than it is high counts in proportion to its width; one that is wide, as solid.
TEST_F(SweepOfAWall, APostCountsByItsWidth) {
    constexpr double solid = 1e18;
    const double full = beside_a_post(0.2, 0.1, 0.4, solid);
    EXPECT_GT(full, 0.03);
    EXPECT_NEAR(beside_a_post(0.2, 0.1, 0.4, 1.0), 0.1 / 0.4 * full, 0.15 * full);
    EXPECT_NEAR(beside_a_post(0.2, 0.1, 0.4, 2.0), 0.2 / 0.4 * full, 0.15 * full);
    EXPECT_NEAR(beside_a_post(0.2, 0.1, 0.4, 0.0), 0.0, 0.15 * full);
    EXPECT_EQ(beside_a_post(0.2, 0.5, 0.4, 1.0), beside_a_post(0.2, 0.5, 0.4, solid));
    EXPECT_EQ(beside_a_post(0.2, 2.0, 0.4, 0.0), beside_a_post(0.2, 2.0, 0.4, solid));
}

// The further the falloff reaches, the darker.
TEST_F(SweepOfAWall, OrdersTheFalloffs) {
    EXPECT_GT(measured(0.5, step, 6), measured(0.5, cubic, 6) + 0.01);
    EXPECT_GT(measured(0.5, cubic, 6), measured(0.5, quadratic, 6) + 0.01);
    EXPECT_GT(measured(0.5, quadratic, 6), measured(0.5, linear, 6) + 0.01);
}

}  // namespace gloam::sweep_test
