// SPDX-License-Identifier: MIT
#include "record/answer_json.hpp"
#include "base/text.hpp"
#include "record/rows.hpp"

namespace gloam::record::answer_json_test {

using base::replaced;

TEST(AnswerJson, EveryFieldSurvivesTheJourney) {
    const judge::Answer row = from_line<judge::Answer>(line_of(failing_row()));
    const judge::Answer want = failing_row();
    EXPECT_EQ(line_of(row), line_of(want));
    EXPECT_EQ(row.fraction_of_allowed(), 1.25);
    EXPECT_EQ(row.worst.value().inputs, want.worst->inputs);
    EXPECT_EQ(row.first_unbounded.value().values, want.first_unbounded->values);
}

TEST(AnswerJson, SaysTheOutcomeAndHowManyInputsWereJudged) {
    judge::Answer row = passing_row("A");
    row.classes.back() = {.inputs = 40, .recorded = 30, .open = 4};
    EXPECT_THAT(line_of(row), AllOf(HasSubstr("\"outcome\":\"ok\",\"not_judged_because\":\"\""),
                                    HasSubstr("\"inputs\":90,\"judged\":56,")));
    EXPECT_EQ(from_line<judge::Answer>(line_of(row)).classes.back().open, 4U);
    EXPECT_THAT(line_of(unjudged_row("A")),
                AllOf(HasSubstr("\"outcome\":\"not judged\""), HasSubstr("the device promises nothing"),
                      HasSubstr("\"judged\":0,")));
    EXPECT_THAT(line_of(failing_row()), HasSubstr("\"outcome\":\"failed\""));
}

TEST(AnswerJson, SeveralOutcomesAreListedBesideTheirHull) {
    judge::Answer row = failing_row();
    EXPECT_THAT(line_of(row), Not(HasSubstr("\"outcomes\"")));
    row.worst->outcomes = {{numeric::Bounds::point(0.0)}, {{.low = 0.25, .high = 0.25, .nan = true}}};
    const std::string text = line_of(row);
    EXPECT_THAT(text, HasSubstr("\"allowed\":[{\"low\":0.0,\"high\":0.25,\"nan\":true}]"));
    EXPECT_EQ(from_line<judge::Answer>(text).worst->outcomes, row.worst->outcomes);
    row.worst->outcomes.back().push_back(numeric::Bounds::point(0.0));
    EXPECT_THAT([&] { (void)from_line<judge::Answer>(line_of(row)); },
                says("worst.outcomes[1]: expected a range for each of \"allowed\""));
}

// Files of earlier versions do not say the outcome.
TEST(AnswerJson, TheOutcomeFollowsFromTheCounts) {
    std::string text = line_of(unjudged_row("A"));
    EXPECT_THAT([&] { (void)from_line<judge::Answer>(replaced(text, "\"not judged\"", "\"ok\"")); },
                says("outcome: expected not judged, by its counts, found \"ok\""));
    text = replaced(text, "\"outcome\"", "\"earlier\"");
    EXPECT_EQ(from_line<judge::Answer>(replaced(text, ",\"open\":0", "")).outcome(),
              judge::Outcome::not_judged);
    EXPECT_THAT([&] { (void)from_line<judge::Answer>(replaced(text, "\"open\":0", "\"open\":60")); },
                says("classes.ordinary: expected counts within its inputs"));
}

TEST(AnswerJson, CountsTheAnswersOfAPredicate) {
    judge::Answer row = passing_row("A");
    row.predicate = {{{.inputs = 40, .judged = 30}, {.inputs = 10}}};
    const std::string text = line_of(row);
    EXPECT_THAT(text, HasSubstr("\"predicate\":{\"false\":{\"inputs\":40,\"judged\":30},\"true\":"
                                "{\"inputs\":10,\"judged\":0}}"));
    EXPECT_EQ(from_line<judge::Answer>(text).outcome(), judge::Outcome::not_judged);
    EXPECT_THAT([&] { (void)from_line<judge::Answer>(replaced(text, "\"judged\":30", "\"judged\":41")); },
                says("predicate.false: expected counts within its inputs"));
}

TEST(AnswerJson, IsOneLineWhateverItHolds) {
    EXPECT_EQ(line_of(failing_row()).find('\n'), std::string::npos);
    judge::Answer row = passing_row("A");
    row.error = "a driver's \xff byte\nand line";
    EXPECT_EQ(line_of(row).find('\n'), std::string::npos);
    EXPECT_THAT(from_line<judge::Answer>(line_of(row)).error, HasSubstr("byte\nand line"));
}

TEST(AnswerJson, WhatWasNotCalculatedIsNull) {
    const std::string text = line_of(passing_row("A"));
    EXPECT_THAT(text, AllOf(HasSubstr("\"width_fraction\":null"), HasSubstr("\"guarantee\":null"),
                            HasSubstr("\"coverage\":null"), HasSubstr("\"worst\":null")));
    EXPECT_EQ(line_of(from_line<judge::Answer>(text)), text);
}

TEST(AnswerJson, EveryReasonHasANameOfItsOwn) {
    for (std::size_t i = 0; i < base::reason_names.size(); ++i) {
        const auto reason = static_cast<judge::Reason>(i);
        judge::Answer row = passing_row("A");
        row.reason = reason;
        EXPECT_EQ(from_line<judge::Answer>(line_of(row)).reason, reason) << name_of(reason);
    }
}

TEST(AnswerJson, WhatIsWrongIsNamed) {
    struct Wrong {
        const char *from, *to, *named;
    };
    const Wrong rows[] = {
        {"\"inputs\":100", "\"inputs\":\"many\"", "inputs: expected a count, found \"many\""},
        {"\"inputs\":100", "\"inputs\":-1", "inputs: expected a count"},
        {"\"inputs\":100", "\"inputs\":99", "inputs: expected the sum over the classes, found 99"},
        {"\"ordinary\":", "\"strange\":", "classes: expected a class of inputs"},
        {"\"width_fraction\":1.25", "\"width_fraction\":null", "width_fraction: expected a number"},
        {"\"max_abs\":0.1", "\"max_abs\":\"big\"", "max_abs: expected a number"},
        {"\"reason\":\"fault\"", "\"reason\":\"mood\"", "reason: expected"},
        {"\"verdict\":\"rules\"", "\"verdict\":\"luck\"", "verdict: expected budget or rules"},
        {"\"variant\"", "\"varying\"", "variant: expected this field"},
        {"4294967295", "4294967296", "worst.input_words[1]: expected a 32-bit word"},
        {"\"got_words\":[", "\"got_words\":[true,", "worst.got_words[0]: expected a count"}};
    const std::string good = line_of(failing_row());
    for (const Wrong& row : rows)
        EXPECT_THAT([&] { (void)from_line<judge::Answer>(replaced(good, row.from, row.to)); },
                    says(row.named));
    EXPECT_THAT([&] { (void)from_line<judge::Answer>(good.substr(0, 40)); }, says("no JSON"));
    EXPECT_THAT([&] { (void)from_line<judge::Answer>("[1]"); }, says("expected an object"));
}

}  // namespace gloam::record::answer_json_test
