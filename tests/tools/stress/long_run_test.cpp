// SPDX-License-Identifier: MIT
#include "stress/long_run.hpp"

#include <fstream>

#include "tools/installation.hpp"
#include "tools/stress/support.hpp"

namespace gloam::stress::test::long_run_test {

TEST(LongRun, StaysWithinItsBounds) {
    const Bench bench;
    const Rows rows = long_run(bench.context());
    expect_all_passed(rows);
    // Storing float16 is what costs: the mean stops moving where a frame's change is less than half its
    // spacing.
    const std::string quantity = "farthest from the exact mean";
    const double single = row_of(rows, quantity, "k 8, w_max 1500, float32").measured;
    const double half = row_of(rows, quantity, "k 8, w_max 1500, float16").measured;
    EXPECT_GT(single, 0.0);
    EXPECT_GT(half, 100.0 * single);
}

// The double beside the device: plain mean until w_max, then the exponential one.
TEST(LongRun, ItsReferenceIsTheMeanAndThenTheExponentialMean) {
    HistoryLane lane{.sequence = {.pattern = noise,
                                  .seed = 3,
                                  .first = 0,
                                  .frames = 0,
                                  .k = 4,
                                  .table_size = 64,
                                  .weight_max = 40.0F,
                                  .stored_half = false}};
    double sum = 0.0;
    for (std::uint64_t frame = 0; frame < 10; ++frame) sum += contribution(lane.sequence, frame);
    lane.advance(10);
    EXPECT_NEAR(lane.mean, sum / 10.0, 1e-15);
    EXPECT_EQ(lane.weight, 40.0);
    EXPECT_EQ(lane.samples, 40U);
    const double before = lane.mean;
    lane.advance(1);
    EXPECT_NEAR(lane.mean, before + (contribution(lane.sequence, 10) - before) * 4.0 / 44.0, 1e-15);
    EXPECT_EQ(lane.weight, 40.0);
}

TEST(LongRun, ContributionsOfDeviceAndHostAgree) {
    const Bench bench;
    const check::Kernel<float(Sequence, unsigned)> device(bench.lab(), accumulate_file,
                                                          "stress_contribution");
    for (unsigned pattern = 0; pattern < pattern_count; ++pattern) {
        double sum = 0.0;
        std::vector<decltype(device)::Inputs> inputs;
        const Sequence sequence{pattern, 7, 0, 0, 1, 1, 1.0F, false};
        for (unsigned frame = 0; frame < 3 * 8192; ++frame) inputs.emplace_back(sequence, frame);
        const std::vector<float> values = device(inputs);
        for (unsigned frame = 0; frame < values.size(); ++frame) {
            ASSERT_EQ(values[frame], contribution(sequence, frame)) << pattern << ", frame " << frame;
            sum += values[frame];
        }
        const std::array means{1.0 / 3.0, 0.5, 0.5, 0.5, 1.0 / 32.0};
        EXPECT_NEAR(sum / static_cast<double>(values.size()), means.at(pattern), 0.01) << pattern;
    }
}

// A blend that rounds down a little in each frame; a weight that forgets its cap; an index that skips.
TEST(LongRun, NoticesWhatIsBroken) {
    struct Fault {
        const char* file;
        const char* from;
        const char* to;
        const char* quantity;
    };
    for (const Fault& fault : {Fault{"gloam/temporal/blend.glsl", "return vec2(blended,",
                                     "return vec2(blended * 0.9999995,", "farthest from the exact mean"},
                               Fault{"gloam/temporal/blend.glsl", "total < cap ? total : cap",
                                     "total < cap ? total : cap - 1.0", "weight off, samples"},
                               Fault{"gloam/temporal/history.glsl", "(index % size + k % size) % size",
                                     "(index + k) % size", "next index off"}}) {
        const gloam::test::Installation broken;
        broken.replace(fault.file, fault.from, fault.to);
        const Bench bench(broken.glsl());
        bool noticed = false;
        for (const Row& row : rows_of(long_run(bench.context(4'000)), fault.quantity))
            noticed |= !row.passed();
        EXPECT_TRUE(noticed) << fault.to;
    }
}

}  // namespace gloam::stress::test::long_run_test
