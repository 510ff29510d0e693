// SPDX-License-Identifier: MIT
#include "site/page_data.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace gloam::site {
namespace document_data_test {

using nlohmann::json;

json blocks(const std::string& markdown) {
    return json::parse(document_json(markdown));
}

TEST(DocumentDataTest, HeadingsAndParagraphs) {
    EXPECT_EQ(blocks("# Title\n\nOne line\nand another.\n\n## Part\nText"),
              json::parse(R"([{"kind": "heading", "level": 1, "text": "Title"},
                              {"kind": "paragraph", "text": "One line and another."},
                              {"kind": "heading", "level": 2, "text": "Part"},
                              {"kind": "paragraph", "text": "Text"}])"));
}

TEST(DocumentDataTest, LinksAndEmphasisBecomeTheirWords) {
    EXPECT_EQ(
        blocks("See [the page](page.md) for **bold** and *copies*, and `a * b * c`.").front().at("text"),
        "See the page for bold and copies, and `a * b * c`.");
}

TEST(DocumentDataTest, ListsJoinTheLinesOfAnItem) {
    EXPECT_EQ(blocks("- one\n  more\n- two\n\n1. first\n2. second\n"),
              json::parse(R"([{"kind": "list", "items": ["one more", "two"]},
                              {"kind": "list", "items": ["first", "second"]}])"));
}

TEST(DocumentDataTest, TablesKeepTheirCells) {
    EXPECT_EQ(
        blocks("| a | `b|c` |\n| --- | ---: |\n| 1 | <b>x</b> |\n| - | |\ntext"),
        json::parse(R"([{"kind": "table", "head": ["a", "`b|c`"], "rows": [["1", "<b>x</b>"], ["-", ""]]},
                              {"kind": "paragraph", "text": "text"}])"));
}

TEST(DocumentDataTest, CodeIsAsItStands) {
    EXPECT_EQ(blocks("```sh\n# no heading\n| no table |\n```\n\n    indented\n    twice\n"),
              json::parse(R"([{"kind": "code", "text": "# no heading\n| no table |\n"},
                              {"kind": "code", "text": "indented\ntwice\n"}])"));
}

TEST(DocumentDataTest, PicturesAndNothingAreLeftOut) {
    EXPECT_EQ(blocks("![a plot](plot.svg)\n"), json::array());
    EXPECT_EQ(blocks(""), json::array());
}

}  // namespace document_data_test
}  // namespace gloam::site
