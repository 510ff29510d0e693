// SPDX-License-Identifier: MIT
// What columns show of scores by class and frame, and of points in closed form.
#include "experiment/table.hpp"

#include <gmock/gmock.h>

#include "experiment/visits.hpp"

namespace gloam::experiment {
namespace table_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

// Frames 1 to 4 of 8 samples each, of which 24 count. The estimate errs by 0.4 / frame in each of two pixels,
// the displayed image by half of that. Settled pixels are there from frame 3 on.
ClassScores scores() {
    ClassScores all{.most_samples = 24.0, .flicker = {{"all", 0.25}}};
    for (int frame = 1; frame <= 4; ++frame) {
        const double error = 0.4 / frame;
        const ClassScore whole{.pixels = "all",
                               .against = "limit",
                               .count = 2,
                               .squares = error * error / 2.0,
                               .raw_squares = 2.0 * error * error,
                               .raw_errors = 2.0 * error};
        all.frames.push_back({frame, 8.0 * frame, {whole}});
        if (frame < 3) continue;
        all.frames.back().classes.push_back(
            {.pixels = "settled", .against = "geometry", .count = 1, .squares = 0.01 * frame});
        all.frames.back().classes.push_back(
            {.pixels = "all", .against = "geometry", .count = 4, .squares = 0.1});
    }
    return all;
}

Visit visit_of(const char* shown, const char* candidate) {
    return {.size = {320, 180}, .shown = {.name = shown}, .candidate = candidate};
}

// The written table of one kind of rows, without its heading.
std::string rows_of(const Record& record, Table table, bool* missed = nullptr) {
    Experiment what;
    const std::vector<SizeResult> results = results_of(what, choose_recorded(what, record), record);
    what.tables = {std::move(table)};
    const Text text = to_text(what, results);
    if (missed != nullptr) *missed = text.missed;
    return text.text.substr(text.text.find("|\n", text.text.find("--")) + 2);
}

Record scored() {
    Record record({.experiment = "mine"});
    Visit visit = visit_of("a", "m");
    visit.quality = FrameQuality{.by_class = scores()};
    record.add(visit);
    // Through its text, as a journal holds it.
    std::string text = record.heading() + "\n" + line_of(record.visits().front()) + "\n";
    return read_record("", text);
}

TEST(ExperimentTable, ClassesAreAddedAsSquares) {
    const Table table{.rows = "runs",
                      .columns = {{.value = "rmse", .against = "limit", .digits = 4},
                                  {.value = "rmse", .against = "limit", .frame = 3, .digits = 4},
                                  {.value = "rmse_raw", .against = "limit", .frame = 9, .digits = 4},
                                  {.value = "rmse_raw", .against = "limit", .frame = 4, .over_frame = 2},
                                  {.value = "rmse", .pixels = "settled", .digits = 4},
                                  {.value = "share", .pixels = "settled"},
                                  {.value = "share", .pixels = "settled", .frame = 4},
                                  {.value = "rmse", .pixels = "young"},
                                  {.value = "flicker", .pixels = "all"},
                                  {.value = "bias_raw", .against = "limit", .frame = 4, .with_sign = true}}};
    // sqrt(0.04 (1 + 1/4 + 1/9 + 1/16) / 4), 0.2 / 3, 0.4 / 4, sqrt(0.07 / 2), 0.07 / 0.2, and 0.04 / 0.1
    EXPECT_EQ(rows_of(scored(), table),
              "| 0.1193 | 0.0667 | 0.1000 | 0.50 | 0.1871 | 0.35 | 0.40 | - | 0.25 | +0.10 |\n");
}

// The square falls with the square of the samples, as long as all of them count: in frames 1 and 2.
TEST(ExperimentTable, TheSlopeIsThatOfTheMeanSquareError) {
    const Table table{.rows = "runs",
                      .columns = {{.value = "rmse_raw", .against = "limit", .statistic = "slope"}}};
    EXPECT_EQ(rows_of(scored(), table), "| -2.00 |\n");
}

TEST(ExperimentTable, FramesHaveRowsAndAPlot) {
    Table table{.rows = "frames",
                .keep = "doubling",
                .plot = "convergence",
                .columns = {{.title = "frame", .label = "frame"},
                            {.title = "samples", .value = "samples_so_far", .digits = 0},
                            {.title = "raw", .value = "rmse_raw", .against = "limit"},
                            {.title = "independent", .value = "rmse_independent", .against = "limit"},
                            {.title = "settled", .value = "rmse", .pixels = "settled"}}};
    EXPECT_EQ(rows_of(scored(), table),
              "| 1 | 8 | 0.40 | 0.40 | - |\n| 2 | 16 | 0.20 | 0.28 | - |\n| 4 | 32 | 0.10 | 0.20 | 0.20 |\n");
    Experiment what;
    const Record record = scored();
    const std::vector<SizeResult> results = results_of(what, choose_recorded(what, record), record);
    what.tables = {table};
    const std::vector<FramePlot> plots = frame_plots(what, results, 0);
    ASSERT_EQ(plots.size(), 1U);
    EXPECT_EQ(plots[0].name, "a-convergence");
    EXPECT_EQ(plots[0].x, "frame");
    EXPECT_EQ(plots[0].y, "rmse, settled");
    ASSERT_EQ(plots[0].curves.size(), 4U);
    EXPECT_EQ(plots[0].curves[0].first, "samples");
    EXPECT_THAT(plots[0].curves[1].second, ElementsAre(Pair(1.0, 0.4), Pair(2.0, 0.2), Pair(4.0, 0.1)));
    EXPECT_EQ(plots[0].curves[3].second.size(), 1U);
}

TEST(ExperimentTable, AColumnsOwnTargetIsMetOrMissed) {
    const auto table = [](double most) {
        return Table{.rows = "runs",
                     .columns = {{.value = "rmse_raw", .against = "limit", .frame = 4, .most = most}}};
    };
    bool missed = true;
    EXPECT_EQ(rows_of(scored(), table(0.2), &missed), "| 0.10, at most 0.2: met |\n");
    EXPECT_FALSE(missed);
    EXPECT_EQ(rows_of(scored(), table(0.05), &missed), "| 0.10, at most 0.05: missed |\n");
    EXPECT_TRUE(missed);
}

// Two methods at two points; the own value of the second is not known.
TEST(ExperimentTable, PointsHaveTheirOwnValuesBeside) {
    Record record({.experiment = "mine"});
    for (const char* shown : {"near", "far"}) {
        const bool near = shown[0] == 'n';
        Visit one = visit_of(shown, "one");
        one.point = PointQuality{.truth = 0.5, .occlusion = near ? 0.25 : 0.75, .own = 0.3, .shown = 0.4};
        Visit two = visit_of(shown, "two");
        two.point = PointQuality{.truth = 0.5, .occlusion = 0.5};
        record.add(one);
        record.add(two);
        record.add(visit_of(shown, "nothing"));
    }
    const Table table{.rows = "candidates",
                      .columns = {{.label = "candidate"},
                                  {.value = "occlusion", .repeated = "cases", .beside = "own"},
                                  {.value = "occlusion", .cases = {"near"}},
                                  {.value = "off_own", .statistic = "furthest", .with_sign = true},
                                  {.value = "off_truth"}}};
    EXPECT_EQ(rows_of(record, table),
              "| one | 0.25 (0.30) | 0.75 (0.30) | 0.25 | far: +0.45 | -0.10 |\n"
              "| two | 0.50 | 0.50 | 0.50 | - | - |\n");
}

}  // namespace table_test
}  // namespace gloam::experiment
