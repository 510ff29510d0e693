// SPDX-License-Identifier: MIT
#include "support/method_names.hpp"
#include "tools/gloam.hpp"
#include "tools/stress/support.hpp"

namespace gloam::stress::test::robust_test {

using PoisonOf = OfEach<std::string>;

TEST_P(PoisonOf, StaysWithinTheFootprint) {
    const Rows rows = rows_of(poisoned_passes, bench->context(GetParam()));
    expect_all_passed(rows);
    if (GetParam() != "hemisphere" && GetParam() != "disc") return;
    // Something did change: the footprint is not empty by mistake.
    for (const Row& row : rows_with(rows, "pixels changed", "depth"))
        EXPECT_GT(row.measured, 0.0) << row.varied;
}

TEST_P(PoisonOf, FetchesNothingOutside) {
    expect_all_passed(rows_of(poisoned_gathers, bench->context(GetParam())));
}

INSTANTIATE_TEST_SUITE_P(All, PoisonOf, testing::ValuesIn(gloam::test::method_names()),
                         gloam::test::parameter_name);

TEST(Poison, HistoriesHealAsStated) {
    const Bench bench;
    expect_all_passed(rows_of(poisoned_history, bench.context()));
}

struct Fault {
    const char* file;
    const char* from;
    const char* to;
    const char* quantity;
    void (*part)(const Context&);
};

// Of the long run: a blend that rounds down a little in each frame; a weight that forgets its cap; an index
// that skips. Far away: what is rounded to the spacing of floats at 1e5.
TEST(Stress, NoticesWhatIsBroken) {
    for (const Fault& fault :
         {Fault{"gloam/temporal/blend.glsl", "return vec2(blended,", "return vec2(blended * 0.9999995,",
                "farthest from the exact mean", long_run},
          Fault{"gloam/temporal/blend.glsl", "total < cap ? total : cap", "total < cap ? total : cap - 1.0",
                "weight off, samples", long_run},
          Fault{"gloam/temporal/history.glsl", "(index % size + k % size) % size", "(index + k + 1) % size",
                "index off, samples", long_run},
          Fault{"gloam/geometry/reprojection.glsl", "position + eye_delta",
                "position + 8192.0 + eye_delta - 8192.0", "position off, part of the distance", far_away},
          Fault{"gloam/geometry/reprojection.glsl", "(inverse_projection * clip)));\n    return",
                "(inverse_projection * (clip + 1e-4))));\n    return",
                "reprojection off, pixels of 1920 x 1080", far_away},
          Fault{"gloam/temporal/history.glsl", "abs(stored_depth - expected_depth) <",
                "abs(stored_depth - expected_depth) + 0.2 <", "points that TSSAO-8 (0.01) rejects, %",
                far_away},
          Fault{"gloam/gather/footprint.glsl", "footprint.size - 1.0", "footprint.size + 9.0",
                "fetches outside the image", poisoned_gathers},
          Fault{"gloam/temporal/blend.glsl", "return vec2(old, w);", "return vec2(contribution, w);",
                "damage other than stated", poisoned_history},
          Fault{"gloam/temporal/history.glsl", "return gloam_history_empty(h.depth);\n    return",
                "return h;\n    return", "not healed (a fresh start) after one frame", poisoned_history},
          Fault{"passes/study/ambient_occlusion.comp", "float gloam_fetch_depth(ivec2 pixel) {\n",
                "float gloam_fetch_depth(ivec2 pixel) {\n    pixel += ivec2(5, 0);\n",
                "pixels changed beyond the footprint", poisoned_passes}}) {
        const Installation broken;
        broken.replace(fault.file, fault.from, fault.to);
        const Bench bench(broken.glsl());
        Context context = bench.context();
        context.scope.frames = 4'000;
        bool noticed = false;
        for (const Row& row : rows_with(rows_of(fault.part, context), fault.quantity))
            noticed |= !row.passed();
        EXPECT_TRUE(noticed) << fault.to;
    }
}

}  // namespace gloam::stress::test::robust_test
