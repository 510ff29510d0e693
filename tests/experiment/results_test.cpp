// SPDX-License-Identifier: MIT
// Records of visits: written ones are read again, and wrong values in a file are refused.
#include "experiment/results.hpp"
#include "experiment/table.hpp"
#include "experiment/visits.hpp"

namespace gloam::experiment {

namespace results_test {

Record everything() {
    Record record = make_record({{"a", "m/4", 10, 0.05}, {"a", "n/8", 30, 0.02}, {"a", "n/4", 40, 0.03}});
    Visit more = make_visit("b", "n/4", 0, 1, 0.5);
    more.shown.kind = "views";
    more.shown.what = "25 %";
    more.quality->flicker = 0.001;
    more.quality->converged = Converged{.similarity = 0.5, .own = effect::Errors{.rmse = 0.25}};
    more.point = PointQuality{.truth = 0.5, .occlusion = 0.4, .shown = 0.3};
    more.quality->bias = std::numeric_limits<double>::quiet_NaN();
    more.work = {.pixels = 64, .samples = std::uint64_t{1} << 40U, .tiles_unfiltered = 7};
    record.add(more);
    return record;
}

void expect_refused(const std::string& text, const std::string& named) {
    EXPECT_THAT([&] { (void)read_record("some file", text); },
                ThrowsMessage<std::runtime_error>(AllOf(HasSubstr("some file"), HasSubstr(named))))
        << text.substr(0, 200);
}

std::string with(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

TEST(ExperimentRecord, ReadsWhatItWrote) {
    const Record record = everything();
    const Record back = read_record("", lines_of(record));
    EXPECT_EQ(lines_of(back), lines_of(record));
    EXPECT_EQ(back.conditions(), record.conditions());
    const Visit& last = back.visits().back();
    EXPECT_EQ(last.shown.what, "25 %");
    EXPECT_EQ(last.quality->flicker, 0.001);
    EXPECT_EQ(last.quality->converged->own->rmse, 0.25);
    EXPECT_FALSE(last.quality->converged->depth);
    EXPECT_EQ(last.point->shown, 0.3);
    EXPECT_TRUE(std::isnan(last.quality->bias));
    EXPECT_EQ(last.quality->memory_bytes, 3'145'728U);
    EXPECT_EQ(last.work.samples, std::uint64_t{1} << 40U);
    EXPECT_EQ(back.find(last), &last);
    Visit other = last;
    other.round = 2;
    EXPECT_EQ(back.find(other), nullptr);
}

// The document of --json holds the same, in one line or in many.
TEST(ExperimentRecord, ReadsTheDocumentOfResults) {
    const Record record = everything();
    Experiment what{.name = "mine"};
    const std::vector<gpu::Extent> sizes = choose_recorded(what, record);
    ASSERT_EQ(sizes.size(), 1U);
    EXPECT_EQ(what.cases.size(), 2U);
    EXPECT_EQ(what.candidates.size(), 3U);
    EXPECT_EQ(what.candidates[1].group, "n");
    std::string text = to_json(what, results_of(what, sizes, record), record, "gloam 1");
    EXPECT_EQ(lines_of(read_record("", text)), lines_of(record));
    std::erase(text, '\n');
    EXPECT_EQ(lines_of(read_record("", text)), lines_of(record));
}

// A file of results is untrusted: each name in it becomes one line.
TEST(ExperimentRecord, NamesAreOneLine) {
    const std::string text = lines_of(everything());
    const std::string bad = R"("a\nsystem('id')\n")";
    expect_refused(with(text, R"(:"device")", ":" + bad), "line 1: device");
    expect_refused(with(text, R"("driver 1")", bad), "driver: expected a text of one line");
    expect_refused(with(text, R"("case":"a")", "\"case\":" + bad), "line 2: case");
    expect_refused(with(text, R"("candidate":"m/4")", "\"candidate\":" + bad), "line 2: candidate");
}

TEST(ExperimentRecord, SaysWhereSomethingElseStands) {
    const std::string text = lines_of(everything());
    expect_refused("", "no JSON");
    expect_refused("[]", "expected an object");
    expect_refused("{}", "expected an object with \"frames\"");
    expect_refused(std::string(1'000'000, '['), "nested more than 64 deep");
    expect_refused(text + "{}\n", "line 9: ");
    expect_refused(with(text, R"("round":0)", R"("round":-1)"), "line 2: round: expected a whole number");
    expect_refused(with(text, R"("width":320)", R"("width":18446744073709551615)"), "line 2: width");
    expect_refused(with(text, R"("rmse":0.05)", R"("rmse":"small")"), "line 2: quality.rmse: expected");
    expect_refused(with(text, R"("pass":"ambient_occlusion")", R"("pass":3)"), "readings[0].passes[0].pass");
    expect_refused(with(text, R"("own":{"rmse":0.25)", R"("own":{"rmse":[])"),
                   "line 8: quality.converged.own.rmse: expected a number");
    expect_refused(with(text, R"("standard_error":0.0,)", ""), "\"standard_error\"");
    const std::string endless = "{\"" + std::string(100'000, 'x');
    try {
        (void)read_record("", endless);
    } catch (const std::runtime_error& error) {
        EXPECT_LT(std::string(error.what()).size(), 400U);
    }
}

TEST(ExperimentRecord, PartsOfOneRunAreJoined) {
    const Record one = make_record({{"a", "m/4", 10, 0.05}});
    const Record other = make_record({{"b", "m/4", 10, 0.05}});
    EXPECT_EQ(joined(std::vector{one, other}).visits().size(), 4U);
    const auto refusal = [](const std::vector<Record>& parts, const char* text) {
        expect_error<std::invalid_argument>([&] { (void)joined(parts); }, {text});
    };
    refusal({one, one}, "a/m/4: in two results");
    refusal({one, Record({.experiment = "mine", .device = "another"})}, "expected the same");
    refusal({}, "expected one or more");
}

TEST(ExperimentResults, TimesAreMedians) {
    Visit visit = make_visit("a", "m", 1, 1, 0);
    visit.readings = {{{{"ambient_occlusion", 3.0}, {"filter_x", 1.0}}},
                      {{{"ambient_occlusion", 6.0}, {"filter_x", 2.0}}},
                      {{{"reproject", 1.0}, {"ambient_occlusion", 4.0}}}};
    Record record({.experiment = "mine"});
    record.add(visit);
    Experiment what;
    const std::vector<SizeResult> results = results_of(what, choose_recorded(what, record), record);
    const std::vector<const CaseResult*> cases{&results.at(0).cases.at(0)};
    const Part gather{.prefixes = {"ambient_occlusion"}};
    EXPECT_EQ(mean_value(cases, 0, "ms", "median", gather), 4.0);
    EXPECT_EQ(mean_value(cases, 0, "ms", "median", {}), 5.0);
    EXPECT_FALSE(mean_value(cases, 0, "rmse", "median", {})) << "nothing was judged";
}

// One remap for all cases, the best one for those of the tuning half.
TEST(ExperimentResults, TheRemapOfTheTuningHalfIsApplied) {
    const effect::Remap made{0.0, 0.9, 1.0};
    Record record({.experiment = "mine"});
    const auto add = [&](const char* shown, const char* half, const effect::Remap& truth) {
        Visit visit = make_visit(shown, "m", 0, 1, 0.1);
        visit.shown.half = half;
        std::vector<float> image;
        for (int i = 0; i < 1000; ++i) image.push_back(static_cast<float>(i) / 1000.0F);
        add_bins(*visit.quality, image, effect::remapped(image, truth));
        record.add(visit);
    };
    const auto fits = [&] {
        Experiment what{.name = "mine"};
        const Record read = read_record("", lines_of(record));
        const std::vector<SizeResult> results = results_of(what, choose_recorded(what, read), read);
        std::vector<double> all;
        for (const CaseResult& one : results.front().cases)
            all.push_back(one.cells.front()->rmse_fit.value_or(-1.0));
        return all;
    };
    add("unseen, alike", "unseen", made);
    EXPECT_THAT(fits(), ElementsAre(-1.0)) << "nothing to fit to";
    add("unseen, another", "unseen", {});
    add("tuning", "tuning", made);
    const std::vector<double> all = fits();
    ASSERT_EQ(all.size(), 3U);
    EXPECT_NEAR(all[0], 0.0, 4e-3);
    EXPECT_NEAR(all[1], 0.1 * std::sqrt(1.0 / 3.0), 4e-3);
    EXPECT_NEAR(all[2], 0.0, 4e-3);
}

TEST(ExperimentResults, CsvHasALineForEachCandidateOfEachCase) {
    Experiment what;
    const Record record = everything();
    const std::string text = to_csv(what, results_of(what, choose_recorded(what, record), record));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5);
    EXPECT_THAT(text, HasSubstr("width,height,case,what,candidate,ms,rmse,"));
    EXPECT_THAT(text, HasSubstr("\n320,180,\"a\",\"\",\"m/4\",10,0.05,"));
    EXPECT_THAT(text, HasSubstr("\n320,180,\"b\",\"25 %\",\"n/4\",,0.5,"));
    EXPECT_EQ(text.find("nan"), std::string::npos);
}

Table table_of(const std::string& rows, const std::string& keep) {
    Table table{.rows = rows, .keep = keep};
    table.columns = {{.label = "case"},
                     {.label = "candidate"},
                     {.value = "rmse", .statistic = rows == "runs" ? "median" : "of_best"}};
    return table;
}

// m is fast, n/8 errs least, n/4 is beaten by it.
TEST(ExperimentTable, KeepsTheFrontOrTheBestOfEachGroup) {
    const Record record = make_record({{"a", "m/4", 10, 0.08},
                                       {"a", "n/8", 40, 0.02},
                                       {"a", "n/4", 50, 0.09},
                                       {"b", "n/4", 50, 0.05},
                                       {"b", "m/4", 10, 0.04},
                                       {"b", "n/8", 90, 0.04}});
    Experiment what;
    const std::vector<SizeResult> results = results_of(what, choose_recorded(what, record), record);
    const auto rows_of = [&](const Table& table) {
        what.tables = {table};
        const std::string text = to_text(what, results).text;
        return text.substr(text.find("|\n", text.find("---")) + 2);
    };
    EXPECT_EQ(rows_of(table_of("runs", "front")),
              "| a | m/4 | 0.08 |\n| a | n/8 | 0.02 |\n| b | m/4 | 0.04 |\n");
    EXPECT_EQ(rows_of(table_of("runs", "best")),
              "| a | m/4 | 0.08 |\n| a | n/8 | 0.02 |\n| b | m/4 | 0.04 |\n| b | n/8 | 0.04 |\n");
    EXPECT_EQ(rows_of(table_of("candidates", "front")), "| a | m/4 | 2.00 |\n| a | n/8 | 1.00 |\n");
    Table group = table_of("candidates", "");
    group.group = "m";
    EXPECT_EQ(rows_of(group), "| a | m/4 | 2.00 |\n");
    group.in_report = true;
    what.tables = {group};
    EXPECT_EQ(to_text(what, results).text, "");
    EXPECT_THAT(to_text(what, results).report, HasSubstr("| a | m/4 | 2.00 |"));
}

}  // namespace results_test

// What columns show of scores by class and frame, and of points in closed form.

namespace table_test {

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

TEST(ExperimentTable, FramesHaveRows) {
    const Table table{.rows = "frames",
                      .keep = "doubling",
                      .columns = {{.title = "frame", .label = "frame"},
                                  {.title = "samples", .value = "samples_so_far", .digits = 0},
                                  {.title = "raw", .value = "rmse_raw", .against = "limit"},
                                  {.title = "independent", .value = "rmse_independent", .against = "limit"},
                                  {.title = "settled", .value = "rmse", .pixels = "settled"}}};
    EXPECT_EQ(rows_of(scored(), table),
              "| 1 | 8 | 0.40 | 0.40 | - |\n| 2 | 16 | 0.20 | 0.28 | - |\n| 4 | 32 | 0.10 | 0.20 | 0.20 |\n");
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

// Two methods at two points; the second has no remapped value.
TEST(ExperimentTable, OfPoints) {
    Record record({.experiment = "mine"});
    for (const char* shown : {"near", "far"}) {
        const bool near = shown[0] == 'n';
        Visit one = visit_of(shown, "one");
        one.point = PointQuality{.truth = 0.5, .occlusion = near ? 0.25 : 0.75, .shown = near ? 0.4 : 0.7};
        Visit two = visit_of(shown, "two");
        two.point = PointQuality{.truth = 0.5, .occlusion = 0.5};
        record.add(one);
        record.add(two);
        record.add(visit_of(shown, "nothing"));
    }
    const Table table{.rows = "candidates",
                      .columns = {{.label = "candidate"},
                                  {.value = "occlusion", .repeated = "cases"},
                                  {.value = "occlusion", .cases = {"near"}},
                                  {.value = "off_truth", .statistic = "furthest", .with_sign = true},
                                  {.value = "off_truth"}}};
    EXPECT_EQ(rows_of(record, table),
              "| one | 0.25 | 0.75 | 0.25 | far: +0.20 | 0.05 |\n"
              "| two | 0.50 | 0.50 | 0.50 | - | - |\n");
}

}  // namespace table_test

}  // namespace gloam::experiment
