// SPDX-License-Identifier: MIT
// What gloam/temporal/packed_history.glsl states of its 64 bits.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "reference/temporal.hpp"

namespace gloam::reference {
namespace packed_history_test {

using History = GloamHistory;

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(PackedHistory, HoldsItsLimitsExactly) {
    for (const double occlusion : {0.0, 0.25, 1.0}) {
        for (const double weight : {0.0625, 1.0, 500.0, 4095.0}) {
            for (const unsigned index : {0U, 2049U, 65535U}) {
                const History h =
                    gloam_history_decode(gloam_history_encode(History{occlusion, weight, index, 8.0}));
                EXPECT_EQ(h.occlusion, occlusion);
                EXPECT_EQ(h.weight, weight);
                EXPECT_EQ(h.index, index);
                EXPECT_EQ(h.depth, 8.0);
            }
        }
    }
    EXPECT_EQ(gloam_history_encode(History{0.5, 5000.0, 65536U, 8.0}),
              (GloamPackedHistory{16384, 65520, 0, gloam_depth_to_code(8.0)}));
}

TEST(PackedHistory, FitsSixteenBitsWhateverItIs) {
    for (const double depth : {0x1p-126, 1e-12, 1.0, 1e12, 0x1.fffffep127, infinity, -1.0}) {
        const GloamPackedHistory packed = gloam_history_encode(History{1.0, 1e30, 4294967295U, depth});
        EXPECT_LE(packed.occlusion, 65535U);
        EXPECT_LE(packed.weight, 65535U);
        EXPECT_LE(packed.index, 65535U);
        EXPECT_LE(packed.depth, 65535U);
    }
}

TEST(PackedHistory, DepthsAreWithinTheirBound) {
    double worst = 0.0;
    for (float depth = 0x1p-31F; depth < 0x1p32F; depth *= 1.0003F) {
        const double exact{depth};
        worst = std::max(worst, std::abs(gloam_depth_from_code(gloam_depth_to_code(exact)) / exact - 1.0));
    }
    EXPECT_LE(worst, 0x1p-11);
    EXPECT_GT(worst, 0x1p-12);
    EXPECT_EQ(gloam_depth_to_code(infinity), 65535U);
    EXPECT_EQ(gloam_depth_from_code(65535U), infinity);
    for (unsigned code = 1; code <= gloam_depth_to_code(1e30); ++code)
        ASSERT_EQ(gloam_depth_to_code(gloam_depth_from_code(code)), code);
}

// Where a mean stops, of as many frames as it takes to fill it many times over.
double stops_short(double k, double weight_max) {
    History h{0.0, 0.0, 0U, 8.0};
    for (int frame = 0; frame < 60000; ++frame) {
        const dvec2 blended = gloam_blend(h.occlusion, h.weight, frame < 100 ? 0.1 : 0.9, k, weight_max);
        h = gloam_history_decode(gloam_history_encode(History{blended.x, blended.y, 0U, 8.0}));
    }
    return 0.9 - h.occlusion;
}

TEST(PackedHistory, TheMeanStopsShortByNoMoreThanIsStated) {
    for (const double k : {1.0, 8.0, 32.0}) {
        for (const double weight_max : {64.0, 500.0, 1500.0}) {
            const double stated = 1.6e-5 * (weight_max + k) / k;
            EXPECT_LE(stops_short(k, weight_max), stated) << k << " of " << weight_max;
            EXPECT_GT(stops_short(k, weight_max), 0.3 * stated) << k << " of " << weight_max;
        }
    }
}

}  // namespace packed_history_test
}  // namespace gloam::reference
