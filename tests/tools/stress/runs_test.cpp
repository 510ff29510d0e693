// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "stress/long_run.hpp"
#include "support/entries.hpp"
#include "support/test.hpp"
#include "tools/stress/support.hpp"

namespace gloam::stress::test::runs_test {

TEST(LongRun, StaysWithinItsBounds) {
    const Bench bench;
    const Rows rows = long_run(bench.context());
    expect_all_passed(rows);
    EXPECT_GT(row_of(rows, "farthest from the exact mean", "k 8, w_max 1500").measured, 0.0);
}

// The double beside the device: plain mean until w_max, then the exponential one.
TEST(LongRun, ItsReferenceIsTheMeanAndThenTheExponentialMean) {
    HistoryLane lane{.sequence = {.pattern = noise,
                                  .seed = 3,
                                  .first = 0,
                                  .frames = 0,
                                  .k = 4,
                                  .table_size = 64,
                                  .weight_max = 40.0F}};
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
    const check::Function<float(Sequence, unsigned)> device(bench.lab(), accumulate_file,
                                                            "stress_contribution");
    for (unsigned pattern = 0; pattern < pattern_count; ++pattern) {
        double sum = 0.0;
        std::vector<decltype(device)::Inputs> inputs;
        const Sequence sequence{pattern, 7, 0, 0, 1, 1, 1.0F};
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

// Of one equation; a suite shares a run.
class WorstInputs : public testing::TestWithParam<std::size_t> {
  protected:
    static void SetUpTestSuite() { bench_.emplace(); }
    static void TearDownTestSuite() { bench_.reset(); }

    inline static std::optional<Bench> bench_;
};

TEST_P(WorstInputs, StayWithinWhatIsDocumentedAndAreAtLeastAsBadAsRandomOnes) {
    const Rows rows = worst_inputs(bench_->context(), gloam::test::entries()[GetParam()]);
    ASSERT_EQ(rows.size(), 2U);
    expect_all_passed(rows);
    EXPECT_GE(rows[0].measured, rows[1].measured);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, WorstInputs, gloam::test::entry_numbers(), gloam::test::entry_name);

TEST(Climb, FindsWorseInputsThanDrawingForManyEquations) {
    const Bench bench;
    Context context = bench.context();
    context.equations = {"TSSAO-*"};
    const Rows rows = worst_inputs(context);
    std::size_t worse = 0;
    for (std::size_t i = 0; i + 1 < rows.size(); i += 2) worse += rows[i].measured > rows[i + 1].measured;
    EXPECT_GT(worse, rows.size() / 8);
}

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Report, ABoundIsBrokenByMoreAndByNaN) {
    EXPECT_TRUE((Row{.measured = 2.0, .bound = 2.0}.passed()));
    EXPECT_FALSE((Row{.measured = 2.1, .bound = 2.0}.passed()));
    EXPECT_FALSE((Row{.measured = nan, .bound = 2.0}.passed()));
    EXPECT_FALSE((Row{.measured = nan, .bound = inf}.passed()));
    EXPECT_TRUE((Row{.measured = inf}.passed()));
}

TEST(Report, JsonHoldsEveryRow) {
    const auto json = nlohmann::json::parse(to_json(
        {.name = "device", .driver = "driver"},
        {{"run", "a", "b", 0.5, 1.0}, {"run", "c", "d", inf, std::nullopt}, {"run", "e", "f", nan, 0.0}}));
    EXPECT_EQ(json.at("device").at("name"), "device");
    EXPECT_EQ(json.at("device").at("driver"), "driver");
    ASSERT_EQ(json.at("rows").size(), 3U);
    EXPECT_EQ(json.at("rows")[0], (nlohmann::json{{"run", "run"},
                                                  {"varied", "a"},
                                                  {"quantity", "b"},
                                                  {"measured", 0.5},
                                                  {"bound", 1.0},
                                                  {"passed", true}}));
    EXPECT_TRUE(json.at("rows")[1].at("bound").is_null());
    EXPECT_EQ(json.at("rows")[1].at("measured"), "inf");
    EXPECT_EQ(json.at("rows")[2].at("measured"), "nan");
    EXPECT_EQ(json.at("rows")[2].at("passed"), false);
}

TEST(Report, LinesSayTheVerdict) {
    EXPECT_THAT(table_line({"run", "a", "b", 0.5, 1.0}), EndsWith(" ok"));
    EXPECT_THAT(table_line({"run", "a", "b", 1.5, 1.0}), EndsWith(" BROKEN"));
    EXPECT_THAT(table_line({"run", "a", "b", 1.5, std::nullopt}), EndsWith(" measured"));
    EXPECT_EQ(table_line({"run", "a", "b", 0.5, 1.0}).find("0.5"), table_header().find("value") + 2);
}

}  // namespace gloam::stress::test::runs_test
