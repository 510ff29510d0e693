// SPDX-License-Identifier: MIT
#include <vector>

#include "reference/filter/convergence_filter.hpp"
#include "reference/printed.hpp"
#include "reference/temporal/blend.hpp"
#include "reference/temporal/convergence.hpp"
#include "reference/temporal/disocclusion.hpp"
#include "reference/temporal/history.hpp"
#include "reference/temporal/neighborhood.hpp"
#include "reference/temporal/smooth_invalidation.hpp"
#include "reference/temporal/validated_bilinear.hpp"

namespace gloam::reference::test {
namespace printed_temporal_test {

TEST(Printed, BlendIsTheWeightedMean) {
    for_random([](numeric::Random& random) {
        const double history = random.unit();
        const double w = random.uniform(0, 500);
        const double fresh = random.unit();
        const double k = random.uniform(1, 600);
        const dvec2 blended = gloam_blend(history, w, fresh, k, 500.0);
        expect_same(blended, dvec2((w * history + k * fresh) / (w + k), std::min(w + k, 500.0)));
        EXPECT_NEAR(blended.x, (w * history + k * fresh) / (w + k), 1e-12);
        expect_same(gloam_convergence(w, 500.0), w / 500.0);
    });
}

TEST(Printed, ValidityTests) {
    for_random([](numeric::Random& random) {
        const double stored = random.uniform(1, 10);
        const double expected = stored * random.uniform(0.9, 1.1);
        EXPECT_EQ(gloam_depth_consistent(stored, expected, 0.05), std::abs(1.0 - expected / stored) < 0.05);
        const dvec3 s = point3(random);
        const dvec3 p = point3(random);
        const dvec3 previous_s = point3(random);
        const dvec3 previous_p = point3(random);
        expect_same(gloam_neighborhood_change(s, p, previous_s, previous_p),
                    std::abs(length(s - p) - length(previous_s - previous_p)), 1.0);
        const double d = random.uniform(0, 2);
        expect_same(gloam_confidence(d, 15.0), 1.0 / (1.0 + 15.0 * d));
        const auto index = static_cast<unsigned>(random.bits());
        const auto k = static_cast<unsigned>(random.below(1U << 24U));
        const auto size = 1U + static_cast<unsigned>(random.below(1U << 24U));
        EXPECT_EQ(gloam_next_index(index, k, size), (0ULL + index + k) % size);
    });
}

TEST(Printed, BilinearWeights) {
    for_random([](numeric::Random& random) {
        const double x = random.unit();
        const double y = random.unit();
        const dvec4 w = gloam_bilinear_weights(dvec2(x, y));
        expect_same(w, dvec4((1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y));
        const dvec4 valid = gloam_validated_weights(w, glm::bvec4(true, false, true, true));
        expect_same(valid, dvec4(w.x, 0, w.z, w.w) / (w.x + w.z + w.w));
    });
}

// The sum of eq. 10 over every pixel of the row, its mean taken at once.
TEST(Printed, FilterIsOneWeightedMeanOverTheRow) {
    constexpr int width = 16;
    for_random([](numeric::Random& random) {
        std::vector<dvec2> values;
        std::vector<dvec3> positions;
        for (int x = 0; x < width; ++x) {
            values.emplace_back(random.unit(), random.unit());
            positions.emplace_back(0.1 * x, 0, -2 - random.uniform(0, 0.1));
        }
        const int pixel = static_cast<int>(random.below(width));
        const double reach = 4.0 * std::max(0.5 - values[static_cast<std::size_t>(pixel)].y, 0.0) / 0.5;
        const dvec3 center = positions[static_cast<std::size_t>(pixel)];
        double sum = 0.0;
        double weights = 0.0;
        for (int x = 0; x < width; ++x) {
            const auto i = static_cast<std::size_t>(x);
            const double coverage = std::clamp(reach - (std::abs(x - pixel) - 1.0), 0.0, 1.0);
            const double d = length(positions[i] - center);
            const double weight = coverage * std::exp(-d * d / (2 * 0.3 * 0.3)) * values[i].y;
            sum += weight * values[i].x;
            weights += weight;
        }
        const auto column = [](glm::ivec2 at) { return static_cast<std::size_t>(at.x); };
        const double filtered = gloam_convergence_filter(
            glm::ivec2(pixel, 0), glm::ivec2(1, 0), glm::ivec2(width, 1), 4, 0.5, 0.3,
            [&](glm::ivec2 at) { return values[column(at)]; },
            [&](glm::ivec2 at) { return positions[column(at)]; });
        const bool smoothed = reach > 0.0 && weights >= 1e-8;
        expect_same(filtered, smoothed ? sum / weights : values[static_cast<std::size_t>(pixel)].x);
    });
}

}  // namespace printed_temporal_test
}  // namespace gloam::reference::test
