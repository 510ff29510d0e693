// SPDX-License-Identifier: MIT
#include "record/failures.hpp"
#include "record/rows.hpp"

namespace gloam::record::failure_text_test {

std::string text_of(const judge::Answer& row, const FailureBundle& bundle = {}) {
    return failure_text(report_of("GPU", {}).device, row, bundle, "gloam check EQ-1", "gloam 1.2",
                        "cc repro.c && ./repro");
}

TEST(FailureText, TellsAllThatAReportNeeds) {
    const judge::Answer row = failing_row();
    judge::Sample smallest = *row.worst;
    smallest.values = "float 1 (0x3f800000)";
    const std::string text = text_of(row, {.reproduction = {.failure = smallest}, .amber = "#!amber"});
    for (const char* part :
         {"EQ-1: f of gloam/f.glsl, variant strict", "line one", "float 1 (0x3f800000)",
          "float 0.5 (0x3f000000)", "3 x 3", "got 0x7fc00000", "want 0.1",
          "permitted 0 (0x0p+0) to 0.25 (0x1p-2), or NaN", "GPU", "driver 1.2", "Vulkan 1.3.0",
          "precision rules", "4 ulp or 1e-07 absolute", "Run it again: gloam check EQ-1\n",
          "Versions: gloam 1.2\n", "amber -v 1.2 -t spv1.5 repro.amber"}) {
        EXPECT_THAT(text, HasSubstr(part));
    }
}

TEST(FailureText, ListsEachOutcomeAndWhichArePermittedTogether) {
    judge::Answer row = failing_row();
    row.worst->got = {0x3f000000U};
    row.worst->want = {0.0};
    row.worst->permitted = {{.low = 0.0, .high = 1.0, .nan = false}};
    row.worst->outcomes = {{numeric::Bounds::point(0.0)}, {{.low = 1.0, .high = 1.0, .nan = true}}};
    EXPECT_THAT(text_of(row), HasSubstr("permitted 0 (0x0p+0), or 1 (0x1p+0), or NaN\n  error"));
    row.worst->got = {0x3f800000U, 0U};
    row.worst->want = {0.0, 0.0};
    row.worst->permitted = {{.low = 0.0, .high = 1.0}, {.low = 0.0, .high = 1.0}};
    for (auto& outcome : row.worst->outcomes)
        outcome = {outcome.front(), numeric::Bounds::point(outcome.front().low)};
    row.worst->outcomes.back().front().nan = false;
    EXPECT_THAT(text_of(row), HasSubstr("permitted 0 (0x0p+0), or 1 (0x1p+0)\n"
                                        "  permitted together: 0 (0x0p+0); 0 (0x0p+0)\n"
                                        "  or together:        1 (0x1p+0); 1 (0x1p+0)\n  error"));
    row.worst->outcomes.resize(judge::Sample::most_outcomes, row.worst->outcomes.back());
    EXPECT_THAT(text_of(row), HasSubstr("beyond 16 outcomes, neighbours are merged\n"));
}

TEST(FailureText, OfACheckThatDidNotRunGivesTheReason) {
    judge::Answer row = passing_row("EQ-2");
    row.reason = judge::Reason::hang;
    row.error = "not finished after 5 s";
    const std::string text = text_of(row, {.error = "it hangs."});
    EXPECT_THAT(text, HasSubstr("hang: not finished after 5 s"));
    EXPECT_THAT(text, HasSubstr("could not be made: it hangs."));
    EXPECT_THAT(text, Not(AnyOf(HasSubstr("input  "), HasSubstr("Judged by"))));
}

TEST(FailureText, SaysNoNumberWhereThereIsNone) {
    judge::Answer row = failing_row();
    EXPECT_THAT(text_of(row), HasSubstr("documented accuracy: 4 ulp"));
    row.budget = {};
    row.worst->error = {.ulp = numeric::infinity, .absolute = numeric::infinity};
    EXPECT_THAT(text_of(row, {.reproduction = {.count = 64}, .c_program = "int main;"}),
                AllOf(HasSubstr("error   infinite: an integer"), HasSubstr("its group of 64"),
                      HasSubstr(" alone: cc repro.c && ./repro\n"), Not(HasSubstr("documented accuracy"))));
    row.worst->error = {};
    EXPECT_THAT(text_of(row), HasSubstr("error   not measured"));
}

TEST(FailureText, WholeNumbersAreWrittenAsOneWritesThem) {
    judge::Answer row = failing_row();
    row.worst->want.assign(row.worst->want.size(), 129'708'002.0);
    const std::string text = text_of(row);
    EXPECT_THAT(text, HasSubstr("want 129708002"));
    EXPECT_THAT(text, Not(HasSubstr("129708002 (0x1.eecbf88p+26)")));
}

TEST(ShellWord, IsOneWordForAShell) {
    EXPECT_EQ(shell_word("HALTON-base2"), "HALTON-base2");
    EXPECT_EQ(shell_word("llvmpipe (LLVM 15.0.6, 256 bits)"), "'llvmpipe (LLVM 15.0.6, 256 bits)'");
    EXPECT_EQ(shell_word("it's; $(id)"), "'it'\\''s; $(id)'");
    EXPECT_EQ(shell_word(""), "''");
    EXPECT_EQ(shell_word("a\n\x1b'b"), R"($'a\x0a\x1b\'b')");
}

TEST(Slug, IsFitForAFolder) {
    EXPECT_EQ(slug("llvmpipe (LLVM 15.0.6, 256 bits)"), "llvmpipe-llvm-15-0-6-256-bits");
    EXPECT_EQ(slug("../../etc/passwd"), "etc-passwd");
    EXPECT_EQ(slug("Zwölf"), "zw-lf");
    EXPECT_EQ(slug("//"), "unnamed");
    EXPECT_EQ(slug(""), "unnamed");
}

}  // namespace gloam::record::failure_text_test
