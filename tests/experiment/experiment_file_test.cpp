// SPDX-License-Identifier: MIT
#include "effect/methods.hpp"
#include "experiment/comparison.hpp"
#include "experiment/experiment.hpp"
#include "experiment/visits.hpp"

namespace gloam::experiment {

namespace experiment_file_test {

constexpr const char* whole = R"({
  "about": "a description", "sizes": ["64x36"], "frames": 4, "scored": 2, "rounds": 3, "rays": 64,
  "preset": "fast", "set": {"samples": 8, "freeze": true, "filter": "none"},
  "cases": [{"scene": "sky", "shown": [3, 1], "scored": 1, "target": 0.5, "candidates": ["run"]}],
  "candidates": [{"name": "run", "sequence": true}, {"name": "loop", "plain": "9x3+1"},
    {"name": "short", "frame": "frame-fast"}],
  "tables": [{"rows": "cases", "columns": [{"title": "ratio", "value": "ms", "of": "run", "over": "loop"}]}]})";

// The description with a part replaced.
std::string with(const std::string& part, const std::string& other) {
    std::string text = whole;
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return text.replace(at, part.size(), other);
}

void expect_refused(const std::string& text, const std::string& why) {
    expect_error<std::runtime_error>([&] { (void)read_experiment("mine.json", text); }, {"mine.json", why});
}

TEST(ExperimentFile, ReadsAllParts) {
    const Experiment read = read_experiment("mine.json", whole);
    EXPECT_EQ(read.layer.preset, "fast");
    EXPECT_EQ(read.layer.set.at(1), (std::pair<std::string, std::string>("freeze", "on")));
    EXPECT_EQ(read.cases.at(0).name, "sky");
    EXPECT_EQ(read.cases.at(0).shown, (std::vector<int>{3, 1}));
    EXPECT_EQ(read.candidates.at(1).layer.kind, Kind::plain);
    EXPECT_EQ(read.candidates.at(1).layer.plain.taps.slices, 9U);
    EXPECT_EQ(read.candidates.at(1).layer.plain.blurs, 1);
    EXPECT_EQ(read.candidates.at(2).layer.kind, Kind::frame);
    EXPECT_EQ(read.candidates.at(2).layer.frame, "frame-fast");
    EXPECT_EQ(read.tables.at(0).columns.at(0).over, "loop");
    EXPECT_NO_THROW(require_consistent(read));
}

// Each method with each count, then each preset; single frames before sequences.
TEST(ExperimentFile, AQueryStandsForCandidates) {
    const auto names_of = [](CandidateQuery query) {
        Experiment what;
        what.candidate_query = std::move(query);
        choose_candidates(what);
        std::vector<std::string> names;
        for (const Candidate& candidate : what.candidates) names.push_back(candidate.name);
        return names;
    };
    EXPECT_THAT(
        names_of({.methods = {"gtao", "sao"}, .presets = {"fast"}, .samples = {4, 8}, .sequence = false}),
        ElementsAre("gtao/4/single", "gtao/8/single", "sao/4/single", "sao/8/single", "fast/12/single"));
    EXPECT_THAT(names_of({.presets = {"fast"}, .single = false}), ElementsAre("fast/12/temporal"));
    EXPECT_EQ(names_of({.samples = {4}}).size(), 2 * effect::methods().size());
    EXPECT_THROW((void)names_of({.presets = {"magic"}}), std::invalid_argument);
    EXPECT_THROW((void)names_of({.methods = {"magic"}}), std::invalid_argument);
    EXPECT_THROW((void)names_of({.single = false, .sequence = false}), std::invalid_argument);
}

// Without counts each method is as it is, with its preset.
TEST(ExperimentFile, AQueryWithoutCountsTakesMethodsAsTheyAre) {
    const char* const both = R"({"name": "loop", "plain": "9x3+1"},
    {"name": "short", "frame": "frame-fast"})";
    Experiment what =
        read_experiment("mine.json", with(both, R"({"methods": ["gtao", "crytek", "unreal"]})"));
    choose_candidates(what);
    ASSERT_EQ(what.candidates.size(), 6U);
    EXPECT_EQ(what.candidates[0].name, "run");
    EXPECT_EQ(what.candidates[1].name, "gtao");
    EXPECT_EQ(what.candidates[1].group, "methods");
    EXPECT_EQ(what.candidates[1].layer.method, "gtao");
    EXPECT_EQ(what.candidates[3].name, "study-crytek-quality");
    EXPECT_EQ(what.candidates[3].layer.preset, "study-crytek-quality");
    EXPECT_EQ(what.candidates[5].name, "unreal-quality");
    EXPECT_EQ(what.candidates[5].group, "methods");
}

// A mean over at least two frames.
TEST(ExperimentFile, AMethodTakesTheSamplesAskedFor) {
    Experiment what;
    what.candidate_query = {.methods = {"hemisphere"}, .samples = {512}};
    choose_candidates(what);
    const Candidate& single = what.candidates.at(0);
    EXPECT_EQ(single.layer.preset, "tssao-paper");
    EXPECT_EQ(single.layer.sequence, false);
    using testing::Pair;
    EXPECT_THAT(single.layer.set, ElementsAre(Pair("samples", "512"), Pair("samples_converged", "512")));
    const Candidate& sequence = what.candidates.at(1);
    EXPECT_EQ(sequence.group, "hemisphere, temporal");
    EXPECT_EQ(sequence.layer.preset, "balanced");
    EXPECT_EQ(sequence.layer.set.back(), (std::pair<std::string, std::string>("weight_max", "1024")));
}

TEST(ExperimentFile, EveryFaultIsNamedWithItsPlace) {
    expect_refused("", "no JSON");
    expect_refused("[]", "an object");
    expect_refused(std::string(100'000, '['), "nested");
    expect_refused(with("\"rays\"", "\"rayz\""), "rayz: expected one of");
    expect_refused(with("\"sizes\": [\"64x36\"]", "\"sizes\": []"), "sizes");
    expect_refused(with("\"frames\": 4", "\"frames\": 1e9"),
                   "frames: expected a whole number from 1 to 1000");
    expect_refused(with("\"rounds\": 3", "\"rounds\": -1"), "rounds");
    expect_refused(with("\"rounds\": 3", "\"rounds\": 2.5"), "rounds");
    expect_refused(with("\"scene\": \"sky\"", "\"scene\": 3"), "cases[0].scene: expected a text");
    expect_refused(with("[3, 1]", "[3, 0]"), "cases[0].shown[1]");
    expect_refused(with("\"target\": 0.5", "\"target\": \"big\""), "cases[0].target: expected a number");
    expect_refused(with("9x3+1", "9x"), "candidates[1].plain: expected SLICESxSTEPS+BLURS");
    expect_refused(with("\"value\": \"ms\"", "\"value\": \"luck\""), "tables[0].columns[0].value");
    expect_refused(with("{\"samples\": 8", "{\"samples\": [8]"), "set.samples");
    expect_refused(with("\"name\": \"run\", ", ""), "candidates[0]: expected an object with \"name\"");
    expect_refused(with("\"sequence\": true", "\"held\": 1"), "candidates[0].held: expected true or false");
    expect_refused(with("\"sequence\": true", "\"pictures\": [\"all\"]"),
                   "candidates[0].pictures[0]: expected one of visibility, error");
    expect_refused(with("\"sequence\": true}", "\"sequence\": true}, {\"methods\": []}, {\"methods\": []}"),
                   "candidates[2]: expected one query alone");
    expect_refused(with("\"scored\": 1", "\"every\": 0"), "cases[0].every: expected a whole number from 1");
    expect_refused(with("\"scored\": 1", "\"pixels\": 64"), "cases[0].pixels: expected an odd number");
}

TEST(ExperimentFile, AColumnAsksForWhatThereIs) {
    const std::string place = "tables[0].columns[0]";
    const auto refused = [&](const std::string& column, const std::string& why) {
        expect_refused(with("\"value\": \"ms\"", column), place + why);
    };
    refused(R"("value": "rmse", "pixels": "odd")", ".pixels: expected one of all, disoccluded");
    refused(R"("value": "rmse", "against": "me")", ".against: expected one of limit, depth, geometry");
    refused(R"("value": "ms", "against": "limit")", ": expected a \"value\" of rmse, rmse_raw");
    refused(R"("value": "ms", "statistic": "slope")", ": expected a \"value\" of rmse, rmse_raw");
    refused(R"("value": "rmse", "frame": 0)", ".frame: expected a whole number from 1");
    refused(R"("value": "rmse", "most": "little")", ".most: expected a number");
    refused(R"("value": "rmse", "repeated": "cakes")", ".repeated: expected one of candidates, cases");
    expect_refused(with("\"over\": \"loop\"", "\"cases\": [\"ski\"]"), "cases: \"ski\"");
    expect_refused(with("\"rows\": \"cases\"", "\"rows\": \"cases\", \"keep\": \"some\""),
                   "tables[0].keep: expected one of front, best, doubling");
}

TEST(ExperimentFile, NamesThatPartsReferToExistOnce) {
    const auto expect = [](const std::string& text, const std::string& why) {
        const Experiment read = read_experiment("mine.json", text);
        expect_error<std::invalid_argument>([&] { require_consistent(read); }, {why});
    };
    expect(with("\"over\": \"loop\"", "\"over\": \"lop\""), "\"lop\"");
    expect(with("[\"run\"]", "[\"ran\"]"), "\"ran\"");
    expect(with("\"name\": \"loop\"", "\"name\": \"run\""), "twice");
}

// Bytes of a description that are changed at random give a description or one line.
TEST(ExperimentFile, DamagedFilesAreRefusedOrRead) {
    std::mt19937 random(1);
    for (int i = 0; i < 20'000; ++i) {
        std::string text = whole;
        for (int change = 0; change < 3; ++change) text[random() % text.size()] = static_cast<char>(random());
        try {
            (void)read_experiment("mine.json", text);
        } catch (const std::runtime_error&) {
        }
    }
}

TEST(PlainLoop, IsReadFromSlicesStepsAndBlurs) {
    EXPECT_EQ(plain_loop("64x3").blurs, 0);
    EXPECT_EQ(plain_loop("1x2+9").blurs, 9);
    for (const char* text : {"", "x", "9", "9x", "x3", "0x3", "9x65", "9x3+", "9x3+10", "9x3+a", "9+1",
                             "-1x3", "9x3x1", "99999999999x1"})
        EXPECT_THROW((void)plain_loop(text), std::invalid_argument) << text;
}

TEST(Cases, AQueryIsReplacedByItsCases) {
    Experiment views{.query = CaseQuery{.half = "unseen"}};
    choose_cases(views, {"room", "moving"}, "", "");
    ASSERT_EQ(views.cases.size(), 1U);  // moving is of the other half
    EXPECT_EQ(views.cases[0].half, "unseen");
    Experiment all{.query = CaseQuery{}};
    choose_cases(all, {}, "", "");
    EXPECT_GT(all.cases.size(), 3U);
    EXPECT_THROW(choose_cases(all, {"magic"}, "", ""), std::invalid_argument);
    EXPECT_THROW(choose_cases(all, {}, "unseen", ""), std::invalid_argument) << "chosen before";
}

}  // namespace experiment_file_test

namespace comparison_test {

using Points = std::vector<std::pair<double, double>>;

TEST(ExperimentFront, HoldsWhatNothingBeatsInBoth) {
    EXPECT_THAT(pareto_front(Points{}), IsEmpty());
    EXPECT_THAT(pareto_front(Points{{3, 1}, {1, 3}, {2, 2}, {2, 3}, {4, 1}}), ElementsAre(1, 2, 0));
    EXPECT_THAT(pareto_front(Points{{1, 1}, {1, 1}}), ElementsAre(0));
    EXPECT_THAT(pareto_front(Points{{1, 2}, {1, 1}}), ElementsAre(1));
    EXPECT_THAT(pareto_front(Points{{2, 2}, {1, 2}}), ElementsAre(1));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(pareto_front(Points{{nan, 0}, {0, nan}, {5, 5}, {HUGE_VAL, 0}}), ElementsAre(2));
}

// Every point of a grid either is in the front or is beaten by one that is.
TEST(ExperimentFront, HoldsOnManyPoints) {
    Points points;
    for (unsigned i = 0; i < 500; ++i) points.emplace_back((i * 7919U) % 101U, (i * 104'729U) % 97U);
    const std::vector<std::size_t> front = pareto_front(points);
    for (const auto& point : points) {
        bool held = false;
        for (const std::size_t f : front)
            held |= points[f].first <= point.first && points[f].second <= point.second;
        EXPECT_TRUE(held);
    }
    for (std::size_t i = 1; i < front.size(); ++i) {
        EXPECT_LT(points[front[i - 1]].first, points[front[i]].first);
        EXPECT_GT(points[front[i - 1]].second, points[front[i]].second);
    }
}

const std::vector<Row> two_scenes{{"a", "fast", 10, 0.08}, {"a", "good", 40, 0.02}, {"a", "bad", 50, 0.09},
                                  {"b", "fast", 10, 0.04}, {"b", "good", 90, 0.04}, {"b", "bad", 50, 0.05}};

std::vector<Choice> choices_in(const std::vector<Row>& rows) {
    const Record record = make_record(rows);
    Experiment what;
    return choices_of(what, results_of(what, choose_recorded(what, record), record).at(0));
}

TEST(ExperimentChoices, AreMeansOfWhatIsInAllCases) {
    std::vector<Row> rows = two_scenes;
    rows.push_back({"a", "once", 1, 0.001});
    const std::vector<Choice> all = choices_in(rows);
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[1].name, "good");
    EXPECT_DOUBLE_EQ(all[1].ms, 60.0);  // the geometric mean
    EXPECT_DOUBLE_EQ(all[1].mean_error, 0.03);
    EXPECT_DOUBLE_EQ(all[1].worst_ms, 90.0);
    EXPECT_EQ(all[1].worst_error, 0.04);
}

TEST(ExperimentChoices, BudgetsAreTimes) {
    EXPECT_EQ(time_budget("0.25ms"), 0.25);
    for (const char* text : {"", "1", "ms", "1s", "-1ms", "0ms", "1 ms", "nanms", "infms", "1msx"}) {
        EXPECT_THAT([&] { (void)time_budget(text); },
                    ThrowsMessage<std::invalid_argument>(HasSubstr("--budget " + std::string(text))))
            << text;
    }
}

TEST(ExperimentChoices, NameTheBestWithinAndTheFastestWith) {
    const std::vector<Choice> all = choices_in(two_scenes);
    EXPECT_EQ(best_within(all, 95)->name, "good");
    EXPECT_EQ(best_within(all, 89)->name, "fast");  // 90 in one case
    EXPECT_FALSE(best_within(all, 9));
    EXPECT_EQ(fastest_with(all, 0.08)->name, "fast");
    EXPECT_EQ(fastest_with(all, 0.07)->name, "good");
    EXPECT_FALSE(fastest_with(all, 0.03));  // 0.04 in one case
    EXPECT_FALSE(best_within({}, 1));
}

TEST(ExperimentComparison, TheSameIsNoChange) {
    const Record record = make_record({{"a", "m/4", 10, 0.05}});
    const Comparison same = compared(record, record);
    EXPECT_FALSE(same.got_worse());
    EXPECT_THAT(same.warnings, IsEmpty());
    EXPECT_DOUBLE_EQ(same.time, 1.0);
    EXPECT_DOUBLE_EQ(same.error, 1.0);
    EXPECT_THAT(to_text(same), HasSubstr("nothing got worse"));
}

TEST(ExperimentComparison, ATimeChangesBeyondItsSpread) {
    const Record before = make_record({{"a", "m", 10, 0.05}, {"a", "n", 10, 0.05}, {"a", "o", 10, 0.05}});
    const Record after = make_record({{"a", "m", 12, 0.05}, {"a", "n", 13, 0.05}, {"a", "o", 8, 0.05}});
    const Comparison found = compared(before, after);
    EXPECT_FALSE(found.changes[0].slower);  // 10.8 to 13.2 after 9 to 11
    EXPECT_TRUE(found.changes[1].slower);   // 11.7 to 14.3
    EXPECT_FALSE(found.changes[1].faster);
    EXPECT_TRUE(found.changes[2].faster);  // 7.2 to 8.8
    EXPECT_DOUBLE_EQ(found.changes[1].time.median, 1.3);
    EXPECT_DOUBLE_EQ(found.changes[1].time.low, 11.7 / 11.0);
    EXPECT_DOUBLE_EQ(found.changes[1].time.high, 14.3 / 9.0);
    EXPECT_NEAR(found.time, std::cbrt(1.2 * 1.3 * 0.8), 1e-12);
    EXPECT_TRUE(found.got_worse());
    EXPECT_THAT(to_text(found), HasSubstr("slower, beyond the spread: 1\n  a/n"));
    EXPECT_THAT(to_text(found), Not(HasSubstr("nothing got worse")));
}

TEST(ExperimentComparison, AnErrorThatRisesIsNamed) {
    const Record before = make_record({{"a", "m", 10, 0.0500}, {"a", "n", 10, 0.05}});
    const Record after = make_record({{"a", "m", 10, 0.0502}, {"a", "n", 10, 0.04}});
    const Comparison found = compared(before, after);
    EXPECT_TRUE(found.changes[0].worse);
    EXPECT_TRUE(found.changes[1].better);
    EXPECT_TRUE(found.got_worse());
    EXPECT_FALSE(
        compared(make_record({{"a", "m", 10, 0.05}}), make_record({{"a", "m", 10, 0.05001}})).got_worse());
}

TEST(ExperimentComparison, WarnsOfOtherCircumstancesAndStillCompares) {
    const Record before = make_record({{"a", "m/4", 10, 0.05}, {"a", "old/4", 1, 1}});
    Record after({.experiment = "mine",
                  .device = "another",
                  .driver = "x",
                  .frames = 16,
                  .scored = 8,
                  .repeat = 1,
                  .rays = 64});
    for (const int round : {0, 1}) {
        for (const char* name : {"m/4", "new/4"}) {
            Visit visit = make_visit("a", name, round, 20, 0.05);
            visit.size = {640, 180};
            after.add(visit);
        }
    }
    const Comparison found = compared(before, after);
    EXPECT_THAT(found.warnings, ElementsAre(HasSubstr("other devices: device"),
                                            HasSubstr("other sizes: 320 x 180"), HasSubstr("256 rays")));
    ASSERT_EQ(found.changes.size(), 1U);
    EXPECT_DOUBLE_EQ(found.changes.front().time.median, 2.0);
    EXPECT_THAT(found.only_old, ElementsAre("a/old/4"));
    EXPECT_THAT(found.only_new, ElementsAre("a/new/4"));
    EXPECT_THAT(to_text(found), StartsWith("warning: other devices"));
}

}  // namespace comparison_test

}  // namespace gloam::experiment
