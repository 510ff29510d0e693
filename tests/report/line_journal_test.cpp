// SPDX-License-Identifier: MIT
#include "report/output.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/files.hpp"
#include "support/files.hpp"

namespace gloam::report {
namespace line_journal_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class LineJournalTest : public testing::Test {
  protected:
    [[nodiscard]] LineJournal open(bool resume, const std::string& heading = "head") const {
        return {file_, heading, resume};
    }
    [[nodiscard]] std::string text() const { return base::read_file(file_, 1'000'000); }

    test::TemporaryDirectory folder_;
    std::filesystem::path file_ = folder_.path() / "journal.jsonl";
};

TEST_F(LineJournalTest, TakesUpWhereItWasLeftWithoutALineThatWasBeingWritten) {
    open(false).add("one");
    open(true).add("two");
    const std::string whole = text();
    std::ofstream(file_, std::ios::app) << "thr";
    const LineJournal journal = open(true);
    EXPECT_THAT(journal.lines(), ElementsAre("one", "two"));
    EXPECT_EQ(text(), whole);
    journal.add("three");
    EXPECT_EQ(text(), "head\none\ntwo\nthree\n");
}

TEST_F(LineJournalTest, StartsEmptyWhereNothingIsToBeResumed) {
    open(false).add("one");
    EXPECT_THAT(open(false).lines(), IsEmpty());
    std::filesystem::remove(file_);
    EXPECT_THAT(open(true).lines(), IsEmpty());
    EXPECT_EQ(text(), "head\n");
    std::ofstream(file_).close();
    EXPECT_THAT(open(true).lines(), IsEmpty());
}

TEST_F(LineJournalTest, RefusesWhatWasMeasuredOtherwise) {
    open(false).add("one");
    const std::string whole = text();
    EXPECT_THAT([&] { (void)open(true, "another"); },
                testing::ThrowsMessage<std::runtime_error>(HasSubstr("cannot resume")));
    EXPECT_EQ(text(), whole);
    EXPECT_THROW(LineJournal("/no/such/folder/journal.jsonl", "head", false), std::runtime_error);
    EXPECT_NO_THROW(LineJournal({}, "head", true).add("nowhere"));
}

}  // namespace line_journal_test
}  // namespace gloam::report
