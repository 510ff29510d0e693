// SPDX-License-Identifier: MIT
#include "effect/errors.hpp"
#include "effect/pixel_classes.hpp"
#include "numeric/random.hpp"
#include "support/test.hpp"

namespace gloam::effect::metrics_test {

using Image = std::vector<float>;

Image noise(std::size_t pixels, std::uint64_t seed) {
    numeric::Random random(seed);
    Image image(pixels);
    for (float& value : image) value = static_cast<float>(random.unit());
    return image;
}

TEST(Errors, OfKnownNumbers) {
    const Errors errors =
        errors_of(std::vector<float>{0.5F, 0.25F, 1.0F, 0.9F}, std::vector<float>{0.25F, 0.75F, nan, 0.9F});
    EXPECT_EQ(errors.compared, 3U);
    EXPECT_DOUBLE_EQ(errors.rmse, std::sqrt((0.0625 + 0.25) / 3.0));
    EXPECT_DOUBLE_EQ(errors.mean, 0.25);
    EXPECT_DOUBLE_EQ(errors.bias, -0.25 / 3.0);
    EXPECT_DOUBLE_EQ(errors.max, 0.5);
    std::vector<float> rising(100);
    std::iota(rising.begin(), rising.end(), 1.0F);
    EXPECT_EQ(errors_of(rising, std::vector<float>(100, 0.0F)).percentile_99, 99.0);
    EXPECT_EQ(errors_of(std::vector<float>{1.0F}, std::vector<float>{nan}).compared, 0U);
}

// A ball of radius 1 at depth 4, under a right angle of view: its silhouette reaches atan(1 / sqrt(15)) from
// its centre.
TEST(Truth, IsNotKnownNearTheBorder) {
    scene::GBuffer view{.extent = {400, 400}};
    view.depth.assign(160'000, 4.0F);
    view.camera = scene::make_frame({.fovy_rad = std::acos(-1.0) / 2}, 1.0);
    const Truth truth = truth_of(view, 1.0, [](const glm::dvec3&, double) { return 0.5; });
    const double pixel = 4.0 * 2.0 / 400.0;
    int first = 0;
    while (!std::isfinite(truth[static_cast<std::size_t>(200 * 400 + first)])) ++first;
    const double x = -4.0 + (first + 0.5) * pixel;  // world units from the axis
    const double edge = std::tan(std::atan(-x / 4.0) + std::asin(1.0 / std::hypot(x, 4.0)));
    EXPECT_NEAR(edge, 1.0 - 2.0 / 400.0, 0.02);
    EXPECT_LT(edge, 1.0);
    EXPECT_EQ(truth[200 * 400 + 200], 0.5F);
}

// Two pixels, 0 and 1 against 1 and 0: seen from either, the weights of both are 1 and g = exp(-1 / 4.5).
TEST(Similarity, OfTwoPixelsByHand) {
    const double g = std::exp(-0.5 / (1.5 * 1.5));
    const double near = 1.0 / (1.0 + g);
    const double x = near;        // the mean of one image about the pixel where it is 1
    const double y = 1.0 - near;  // and of the other
    const double variance = x - x * x;
    const double covariance = -x * y;
    const double expected =
        (2 * x * y + 1e-4) * (2 * covariance + 9e-4) / ((x * x + y * y + 1e-4) * (2 * variance + 9e-4));
    EXPECT_NEAR(structural_similarity(Image{0, 1}, Image{1, 0}, {2, 1}), expected, 1e-9);
}

TEST(Similarity, OfEqualAndOfUnrelatedImages) {
    const Image a = noise(1600, 1);
    EXPECT_NEAR(structural_similarity(a, a, {40, 40}), 1.0, 1e-12);
    EXPECT_LT(std::abs(structural_similarity(a, noise(1600, 2), {40, 40})), 0.2);
    EXPECT_EQ(structural_similarity(a, Image(1600, nan), {40, 40}), 1.0);
    EXPECT_THROW((void)structural_similarity(a, a, {40, 39}), std::invalid_argument);
    Image truth = a;
    Image image = a;
    for (std::size_t i = 0; i < a.size(); i += 2) {
        truth[i] = nan;
        image[i] = 0.123F;  // anything, where nothing is known
    }
    EXPECT_NEAR(structural_similarity(image, truth, {40, 40}), 1.0, 1e-12);
}

TEST(Remap, ByHand) {
    EXPECT_EQ((Remap{0.5, 1, 2}(0.5)), 1.0);
    EXPECT_DOUBLE_EQ((Remap{0.5, 1, 2}(0.25)), 0.5625);
    EXPECT_EQ((Remap{}(0.3)), 0.3);
    EXPECT_EQ((Remap{-0.5, 1, 2}(0.3)), 0.0);
    EXPECT_EQ((Remap{-0.5, 1, 0}(0.3)), 1.0);
}

// Images made by a remap of the truth are brought back to it.
TEST(Remap, IsFound) {
    const Image occlusion = noise(5000, 4);
    for (const Remap& remap : {Remap{0.1, 0.8, 1.7}, Remap{-0.2, 1.2, 1.0}, Remap{0, 0.9, 0.5}, Remap{}}) {
        const Image truth = remapped(occlusion, remap);
        const double before = errors_of(occlusion, truth).rmse;
        const double after = errors_of(remapped(occlusion, best_remap(occlusion, truth)), truth).rmse;
        EXPECT_LT(after, 2e-3) << remap.a << " " << remap.b << " " << remap.c;
        EXPECT_LE(after, before);
    }
}

// Orthographic, 10 pixels a world unit.
scene::GBuffer places_view(const std::function<float(std::size_t, std::size_t)>& depth) {
    constexpr backend::Extent extent{60, 50};
    scene::GBuffer view{.extent = extent, .normal = std::vector(60 * 50, glm::vec3(0, 0, 1))};
    view.camera = scene::make_frame({.projection = scene::Projection::orthographic, .view_height = 5.0}, 1.2);
    for (std::size_t i = 0; i < 60 * 50; ++i) view.depth.push_back(depth(i % 60, i / 60));
    return view;
}

TEST(HardPlaces, TheRimIsNearerToTheEdgeThanTheRadius) {
    const HardPlaces places = hard_places(places_view([](auto, auto) { return 3.0F; }), 0.97);
    for (std::size_t i = 0; i < places.rim.size(); ++i) {
        const std::size_t x = i % 60;
        const std::size_t y = i / 60;
        EXPECT_EQ(places.rim[i], x < 10 || y < 10 || x >= 50 || y >= 40) << x << ' ' << y;
        EXPECT_EQ(places.contacts[i] + places.thin[i], 0);
    }
}

TEST(HardPlaces, ContactsLieBelowAStep) {
    // A step of less than a tenth of the radius, so that its upper side is within reach.
    const auto step = [](std::size_t x, auto) { return x < 30 ? 2.95F : 3.0F; };
    const HardPlaces near = hard_places(places_view(step), 1.5);
    for (std::size_t x = 0; x < 60; ++x) EXPECT_EQ(near.contacts[20 * 60 + x], x == 30) << x;
    const auto far_step = [](std::size_t x, auto) { return x < 30 ? 2.0F : 3.0F; };
    EXPECT_EQ(hard_places(places_view(far_step), 1.5).contacts, Mask(60 * 50, 0)) << "further than a tenth";
}

TEST(HardPlaces, ThinIsWhatFallsOffToBothSides) {
    for (const bool column : {true, false}) {
        const HardPlaces places =
            hard_places(places_view([=](std::size_t x, std::size_t y) {
                            const std::size_t at = column ? x : y;
                            return at >= 20 && at < 23 ? 2.0F : (at >= 30 && at < 40 ? 2.5F : 3.0F);
                        }),
                        1.0);
        for (std::size_t at = 0; at < 50; ++at) {
            // A post three pixels wide, and 2.5 pixels to its sides; the wider one is no thin thing.
            EXPECT_EQ(places.thin[column ? 25 * 60 + at : at * 60 + 25], at >= 18 && at < 25) << at;
        }
    }
    const float none = infinity;
    const HardPlaces places =
        hard_places(places_view([=](std::size_t x, auto) { return x == 20 ? 2.0F : none; }), 1.0);
    for (std::size_t x = 0; x < 60; ++x) EXPECT_EQ(places.thin[25 * 60 + x], x == 20) << "no background";
}

TEST(Metrics, OfAMask) {
    const Truth truth = masked(Image{0.1F, 0.2F, nan}, Mask{0, 1, 1});
    EXPECT_TRUE(std::isnan(truth[0]));
    EXPECT_EQ(truth[1], 0.2F);
    EXPECT_EQ(errors_of(Image{0, 0.7F, 0}, truth).compared, 1U);
}

}  // namespace gloam::effect::metrics_test
