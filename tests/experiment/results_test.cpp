// SPDX-License-Identifier: MIT
// Records of visits: written ones are read again, wrong values in a file are refused, and tables show them.
#include "experiment/results.hpp"
#include "experiment/table.hpp"
#include "experiment/visits.hpp"

namespace gloam::experiment::results_test {

Record everything() {
    Record record = make_record({{"a", "m/4", 10, 0.05}, {"a", "n/8", 30, 0.02}, {"a", "n/4", 40, 0.03}});
    Visit more = make_visit("b", "n/4", 0, 1, 0.5);
    more.shown.kind = "views";
    more.shown.what = "25 %";
    more.quality->flicker = 0.001;
    more.quality->converged = Converged{.similarity = 0.5, .own = effect::Errors{.rmse = 0.25}};
    more.point = PointQuality{.truth = 0.5, .occlusion = 0.4, .shown = 0.3};
    more.quality->bias = std::numeric_limits<double>::quiet_NaN();
    record.add(more);
    return record;
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
    EXPECT_EQ(back.find(last), &last);
    Visit other = last;
    other.round = 2;
    EXPECT_EQ(back.find(other), nullptr);
}

// The document of --json holds the same, in one line or in many.
TEST(ExperimentRecord, ReadsTheDocumentOfResults) {
    const Record record = everything();
    std::string text = to_json(Database(record), record, "gloam 1");
    EXPECT_EQ(lines_of(read_record("", text)), lines_of(record));
    std::erase(text, '\n');
    EXPECT_EQ(lines_of(read_record("", text)), lines_of(record));
}

// A file of results is untrusted: a message shows each name of it in one line, and says where what is wrong
// stands.
TEST(ExperimentRecord, SaysWhereSomethingElseStands) {
    const auto expect_refused = [](const std::string& text, const std::string& named) {
        expect_error<std::runtime_error>([&] { (void)read_record("some file", text); }, {"some file", named});
    };
    const std::string text = lines_of(everything());
    expect_refused("", "no JSON");
    expect_refused("[]", "expected an object");
    expect_refused("{}", "line 1: frames: expected this field, found none");
    expect_refused(text + "{}\n", "line 9: ");
    const std::string bad = R"("a\nsystem('id')\n")";
    const std::tuple<std::string, std::string, std::string> faults[] = {
        {R"(:"device")", ":" + bad, "line 1: device"},
        {R"("driver 1")", bad, "driver: expected a text of one line"},
        {R"("case":"a")", "\"case\":" + bad, "line 2: case"},
        {R"("candidate":"m/4")", "\"candidate\":" + bad, "line 2: candidate"},
        {R"("round":0)", R"("round":-1)", "line 2: round: expected a whole number"},
        {R"("width":320)", R"("width":18446744073709551615)", "line 2: width"},
        {R"("rmse":0.05)", R"("rmse":"small")", "line 2: quality.rmse: expected"},
        {R"("pass":"ambient_occlusion")", R"("pass":3)", "readings[0].passes[0].pass"},
        {R"("own":{"rmse":0.25)", R"("own":{"rmse":[])",
         "line 8: quality.converged.own.rmse: expected a number"},
        {R"("standard_error":0.0,)", "", "standard_error: expected this field"}};
    for (const auto& [part, other, named] : faults) expect_refused(with(text, part, other), named);
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
}

TEST(ExperimentResults, TimesAreMedians) {
    Visit visit = make_visit("a", "m", 1, 1, 0);
    visit.readings = {{{{"ambient_occlusion", 3.0}, {"filter_x", 1.0}}},
                      {{{"ambient_occlusion", 6.0}, {"filter_x", 2.0}}},
                      {{{"reproject", 1.0}, {"ambient_occlusion", 4.0}}}};
    Record record({.experiment = "mine"});
    record.add(visit);
    EXPECT_EQ(rows_of(record, "SELECT ms, gather_ms, least_ms, rmse FROM result"), "| 5 | 4 | 4 | - |\n");
    EXPECT_EQ(rows_of(record, "SELECT pass, ms, least_ms FROM passes"),
              "| ambient_occlusion | 4 | 3 |\n| filter_x | 1 | 0 |\n| reproject | 0 | 0 |\n");
}

// A candidate that lacks a case has no mean over all of them.
TEST(ExperimentResults, MeansAreOverAllCases) {
    const Record record = make_record({{"a", "m", 10, 0.25}, {"b", "m", 40, 0.75}, {"a", "once", 1, 0.5}});
    EXPECT_EQ(rows_of(record, "SELECT candidate, fixed(ms, 2), rmse, worst_ms, worst_rmse FROM overall"),
              "| m | 20.00 | 0.5 | 40 | 0.75 |\n");
    EXPECT_EQ(rows_of(record, "SELECT [case], candidate, measured FROM result WHERE NOT measured"),
              "| b | once | 0 |\n");
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
        effect::add_to_bins(visit.quality->bins.emplace(128), image, effect::remapped(image, truth));
        record.add(visit);
    };
    const auto fits = [&] {
        std::vector<double> all;
        const Record read = read_record("", lines_of(record));
        for (const auto& row : Database(read).select("SELECT coalesce(rmse_fit, -1.0) FROM result").all)
            all.push_back(std::get<double>(row.at(0)));
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

// m is fast, n/8 errs least, n/4 is beaten by it.
TEST(ExperimentResults, TheFrontIsWhatNoOtherBeats) {
    const Record record = make_record({{"a", "m/4", 10, 0.08},
                                       {"a", "n/8", 40, 0.02},
                                       {"a", "n/4", 50, 0.09},
                                       {"b", "n/4", 50, 0.05},
                                       {"b", "m/4", 10, 0.04},
                                       {"b", "n/8", 90, 0.04}});
    EXPECT_EQ(rows_of(record, "SELECT [case], candidate FROM result WHERE on_front"),
              "| a | m/4 |\n| a | n/8 |\n| b | m/4 |\n");
    EXPECT_EQ(rows_of(record, "SELECT candidate, fixed(of_best, 2) FROM overall WHERE on_front"),
              "| m/4 | 2.00 |\n| n/8 | 1.00 |\n");
    EXPECT_EQ(rows_of(record, "SELECT mark || candidate || mark FROM overall"),
              "| **m/4** |\n| **n/8** |\n| n/4 |\n");
}

// What tables show of scores by class and frame, and of points in closed form.

// Frames 1 to 4 of 8 samples each. The estimate errs by 0.4 / frame in each of two pixels,
// the displayed image by half of that. Settled pixels are there from frame 3 on.
Record scored() {
    ClassScores all{.flicker = {{"all", 0.25}}};
    for (int frame = 1; frame <= 4; ++frame) {
        const double error = 0.4 / frame;
        all.frames.push_back({frame,
                              8.0 * frame,
                              {{.pixels = "all",
                                .against = "depth",
                                .count = 2,
                                .squares = error * error / 2.0,
                                .raw_squares = 2.0 * error * error,
                                .raw_errors = 2.0 * error}}});
        if (frame < 3) continue;
        all.frames.back().classes.push_back(
            {.pixels = "settled", .against = "geometry", .count = 1, .squares = 0.01 * frame});
        all.frames.back().classes.push_back(
            {.pixels = "all", .against = "geometry", .count = 4, .squares = 0.1});
    }
    Record record({.experiment = "mine"});
    record.add({.size = {320, 180},
                .shown = {.name = "a"},
                .candidate = "m",
                .quality = FrameQuality{.by_class = all}});
    return read_record("", lines_of(record));  // as a journal holds it
}

// Of classes sqrt(0.04 (1 + 1/4 + 1/9 + 1/16) / 4), and the mean of 0.4, 0.2, 0.4 / 3 and 0.1; then
// sqrt(0.07 / 2), and 0.07 / 0.2.
TEST(ExperimentTable, ScoresAreAddedAsSquares) {
    const std::pair<const char*, const char*> rows[] = {
        {"SELECT pixels, against, fixed(rmse, 4), fixed(bias_raw, 4), fixed(share, 2), flicker FROM "
         "class_errors ORDER BY pixels, against",
         "| all | depth | 0.1193 | 0.2083 | 1.00 | 0.25 |\n"
         "| all | geometry | 0.1581 | 0.0000 | 1.00 | 0.25 |\n"
         "| settled | depth | - | - | 0.00 | - |\n"
         "| settled | geometry | 0.1871 | 0.0000 | 0.35 | - |\n"},
        {"SELECT frame, samples, fixed(rmse_raw, 2), signed(bias_raw, 2) FROM class_frames WHERE against = "
         "'depth' AND frame <> 3",
         "| 1 | 8 | 0.40 | +0.40 |\n| 2 | 16 | 0.20 | +0.20 |\n| 4 | 32 | 0.10 | +0.10 |\n"}};
    for (const auto& [select, expected] : rows) EXPECT_EQ(rows_of(scored(), select), expected);
    bool missed = true;
    EXPECT_EQ(rows_of(scored(), "SELECT at_most(0.1, 0.2, 2), at_most(NULL, 0.2, 2)", &missed),
              "| 0.10, at most 0.2: met | - |\n");
    EXPECT_FALSE(missed);
    EXPECT_EQ(rows_of(scored(), "SELECT at_most(0.1, 0.05, 2)", &missed), "| 0.10, at most 0.05: missed |\n");
    EXPECT_TRUE(missed);
}

// Lines with "{}" that stand together are repeated for each name, whatever is in it; numbers are at the
// right.
TEST(ExperimentTable, LinesAreRepeatedForEachName) {
    const Record record = make_record({{"a", "it's", 10, 0.25}, {"a", "n", 40, 0.75}});
    const Experiment what{.tables = {{.name = "block",
                                      .each = "SELECT candidate FROM candidates",
                                      .select = {"SELECT [case] AS 'case'",
                                                 ", max(rmse) FILTER (WHERE candidate = '{}') AS '{}'",
                                                 ", '**' || max(1) || '**' AS 'b'", "FROM result"}}}};
    EXPECT_EQ(to_text(what, Database(record)).text,
              "\n| case | it's | n | b |\n| --- | --: | --: | --: |\n| a | 0.25 | 0.75 | **1** |\n");
    EXPECT_EQ(to_text(what, Database(record)).named.at("block"),
              to_text(what, Database(record)).text.substr(1));
}

TEST(ExperimentTable, ATableOfOneSizeStandsOnceForEach) {
    Record record = make_record({{"a", "m", 10, 0.25}});
    Visit small = make_visit("a", "m", 0, 1, 0.5);
    small.size = {64, 36};
    record.add(small);
    Experiment what{
        .tables = {{.in_report = true, .select = {"SELECT rmse FROM result WHERE size = :size"}}}};
    EXPECT_EQ(to_text(what, Database(record)).report,
              "\n320 x 180:\n\n| rmse |\n| --: |\n| 0.25 |\n\n64 x 36:\n\n| rmse |\n| --: |\n| 0.5 |\n");
    EXPECT_EQ(to_text(what, Database(record)).text, "");
}

// A description may be of somebody else: its SELECTs only read, and do not run for ever.
TEST(ExperimentTable, ASelectOnlyReads) {
    const Database database(scored());
    const auto refused = [&](const std::string& select, const char* why) {
        EXPECT_THAT([&] { (void)database.select(select); }, ThrowsMessage<std::runtime_error>(HasSubstr(why)))
            << select;
    };
    refused("SELECT rmsee FROM result", "no such column: rmsee");
    refused("", "expected one SELECT");
    refused("SELECT 1; SELECT 2", "expected one SELECT");
    refused("DELETE FROM result", "not authorized");
    refused("CREATE TABLE mine(x)", "not authorized");
    refused("ATTACH 'gloam.db' AS other", "not authorized");
    refused("PRAGMA writable_schema = 1", "not authorized");
    refused("SELECT * FROM pragma_database_list", "not authorized");
    refused("SELECT load_extension('libm.so.6')", "not authorized");
    const std::string endless = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) ";
    for (const char* rows : {"SELECT max(i) FROM n", "SELECT i FROM n"}) refused(endless + rows, "seconds");
    EXPECT_EQ(rows_of(scored(), "SELECT 'a' || char(10) || char(27) || '[2J'"), "| a??[2J |\n");
}

}  // namespace gloam::experiment::results_test
