// SPDX-License-Identifier: MIT
#include "tools/gloam.hpp"

namespace gloam::test::bench_test {

class Bench : public InFolder {
  protected:
    [[nodiscard]] json results(const std::string& name, const std::string& option = "") const {
        expect_success(
            gloam("bench --scene moving --method hemisphere --samples 4 16 --size 64x36 --frames 4 --rays 32 "
                  "--repeat 1 --out {} --json {}" +
                      option,
                  path("out"), path(name)));
        return json::parse(read_file(path(name))).at("results");
    }
};

// From the middle of a line on: what was judged again is the same to the bit.
TEST_F(Bench, GoesOnWhereItWasInterrupted) {
    const json first = results("a.json");
    const std::string journal = read_file(path("out/journal.jsonl"));
    ASSERT_EQ(line_count(journal), 1 + 2 * 4);  // two rounds visit all
    write("out/journal.jsonl", journal.substr(0, journal.size() / 2));
    const json again = results("b.json", " --resume");
    EXPECT_EQ(line_count(read_file(path("out/journal.jsonl"))), line_count(journal));
    ASSERT_EQ(again.size(), 4U);
    for (std::size_t i = 0; i < first.size(); ++i) {
        const json& row = again[i];
        const bool temporal = row.at("candidate").get<std::string>().ends_with("temporal");
        for (const char* error : {"rmse", "rmse_raw", "rmse_depth", "similarity", "flicker", "samples"})
            EXPECT_EQ(row.at(error), first[i].at(error)) << error;
        EXPECT_GT(row.at("ms"), 0.0);
        EXPECT_GT(row.at("rmse_depth"), 0.0);
        EXPECT_LE(row.at("samples"), row.at("samples_asked"));
        EXPECT_EQ(row.at("flicker").is_number(), temporal);
    }
}

// A description may be of somebody else (the tests of the room experiment have all that is refused).
TEST_F(Bench, AHostileSelectIsOneLine) {
    expect_could_not_run(
        gloam("bench {}", write("theirs.json", R"({"sizes": ["48x27"], "cases": [{"scene": "sky"}],
        "candidates": [{"name": "a"}], "tables": [{"select": "ATTACH 'stolen.db' AS other"}]})")),
        "not authorized");
}

}  // namespace gloam::test::bench_test
