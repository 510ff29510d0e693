// SPDX-License-Identifier: MIT
#include "pictures/sheet.hpp"
#include "record/page.hpp"
#include "record/rows.hpp"

namespace gloam::record::pictures_test {

using namespace pictures;

constexpr const char* hostile = "</script><script>alert(1)</script>\" onload='x' &amp; \x01";

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(Page, EscapesEveryCharacterThatMeansSomething) {
    EXPECT_EQ(escaped_html("a<b>&\"'\n\x7f"), "a&lt;b&gt;&amp;&quot;&#39;\n\xEF\xBF\xBD");
    EXPECT_EQ(escaped_html("\xC3\xA9"), "\xC3\xA9");
}

// Whatever a foreign text holds, the page has its own script and no other, and no attribute beside its own.
TEST(Page, ForeignTextsStayText) {
    Page page(hostile);
    page.heading(hostile);
    page.paragraph(hostile);
    page.preformatted(hostile);
    page.choose({{hostile, hostile}, {"../../x:y", "b"}}, hostile);
    page.table({.columns = {{.title = hostile, .meaning = hostile, .filter = true}},
                .rows = {{{hostile}}, {{"other"}}}});
    const std::string html = page.html();
    EXPECT_EQ(count_of(html, "<script"), 1U);
    EXPECT_EQ(count_of(html, "</script>"), 1U);
    EXPECT_THAT(html, Not(AnyOf(HasSubstr("alert(1)<"), HasSubstr("onload='"), HasSubstr("\x01"))));
    EXPECT_THAT(html, HasSubstr("src=\"../../x%3Ay\""));  // no scheme of a URL
}

TEST(Page, NeedsNoNetworkAndLetsItsOwnScriptRunAlone) {
    Page page("p");
    const std::string html = page.html();
    EXPECT_THAT(html, AllOf(HasSubstr("default-src 'none'"), HasSubstr("script-src 'sha256-"),
                            Not(HasSubstr("http://")), Not(HasSubstr("https://"))));
    const std::size_t at = html.find("'sha256-") + 8;
    EXPECT_EQ(html.find('\'', at) - at, 44U);  // 32 bytes in base64
    EXPECT_EQ(html[at + 43], '=');
}

TEST(Page, NumbersAreSortedByTheirValue) {
    Page page("p");
    page.table({.columns = {{.title = "n", .numeric = true}},
                .rows = {{{"10", 10.0}},
                         {{"inf", std::numeric_limits<double>::infinity(), Tone::bad}},
                         {{"nan", std::numeric_limits<double>::quiet_NaN()}},
                         {{"-"}}}});
    const std::string html = page.html();
    EXPECT_THAT(html, HasSubstr("<td class=\"number\" data-value=\"10\">10</td>"));
    EXPECT_THAT(html, HasSubstr("<td class=\"number bad\" data-value=\"Infinity\">inf</td>"));
    EXPECT_THAT(html, HasSubstr("<td class=\"number\">nan</td>"));
    EXPECT_THAT(html, HasSubstr("<td class=\"number\">-</td>"));
}

TEST(CheckPage, FailuresComeFirstAndEveryRowIsThere) {
    judge::Answer crashed = passing_row("EQ-9");
    crashed.error = hostile;
    crashed.reason = judge::Reason::crash;
    const std::vector<CheckReport> reports{report_of("A", {passing_row("EQ-1"), failing_row()}),
                                           report_of(hostile, {crashed})};
    const Table table = check_table(reports);
    ASSERT_EQ(table.rows.size(), 3U);
    EXPECT_EQ(table.rows[0][0].text, verdict_of(failing_row()));
    EXPECT_EQ(table.rows[0][0].tone, Tone::bad);
    EXPECT_EQ(table.rows[1][0].text, "crash");
    EXPECT_EQ(table.rows[2][0].text, "ok");
    EXPECT_EQ(table.rows[0].back().text, failing_row().worst->values);
    const std::string html = to_check_page(reports, {"a note <of> ours"});
    EXPECT_EQ(count_of(html, "<script"), 1U);
    EXPECT_THAT(html, HasSubstr("<title>gloam check: 3 checks, 2 failed</title>"));
    EXPECT_THAT(html, HasSubstr("a note &lt;of&gt; ours"));
    EXPECT_THAT(html, HasSubstr("line &lt;two&gt;"));  // the story
    EXPECT_THAT(to_check_page({report_of("A", {passing_row("EQ-1")})}), HasSubstr("1 checks, 0 failed"));
}

TEST(CheckPage, ALongValueIsCutAndManyStoriesAreCounted) {
    judge::Answer row = failing_row();
    row.worst->values = std::string(100'000, 'x');
    const std::vector<CheckReport> reports{report_of("A", std::vector<judge::Answer>(150, row))};
    const std::string html = to_check_page(reports);
    EXPECT_LT(html.size(), 400'000U);
    EXPECT_EQ(count_of(html, "<pre>"), 100U);
    EXPECT_THAT(html, HasSubstr("50 more are in the table."));
}

constexpr std::uint32_t width = 260;
constexpr std::uint32_t height = 40;

SheetPicture grey(const std::string& caption) {
    return {.rgb = std::vector<std::uint8_t>(3 * width * height, 128), .caption = caption};
}

// Big-endian, as PNG has it.
std::uint32_t word_at(const std::string& png, std::size_t at) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i) word = word << 8U | static_cast<unsigned char>(png[at + i]);
    return word;
}

TEST(Sheet, HoldsItsPicturesInRows) {
    const std::vector<SheetPicture> three{grey("a"), grey("b"), grey("c")};
    const std::string png = to_sheet_png(three, width, height, 2);
    EXPECT_EQ(png.substr(1, 3), "PNG");
    EXPECT_EQ(word_at(png, 16), 2 * width + 3 * 6);  // a gap of half a line of 13 pixels
    EXPECT_EQ(word_at(png, 20), 2 * (height + 13 + 2 * 6) + 6);
    EXPECT_EQ(word_at(to_sheet_png(three, width, height, 9), 16), 3 * width + 4 * 6);  // no empty columns
}

TEST(Sheet, CaptionsTakeUpToThreeLines) {
    const auto png = [](const std::string& caption) {
        return to_sheet_png(std::vector{grey(caption)}, width, height, 1);
    };
    EXPECT_NE(png("gtao"), png(""));
    EXPECT_NE(png("gtao"), png("hbao"));
    EXPECT_EQ(png(std::string(500, 'x')), png(std::string(600, 'x')));
    EXPECT_EQ(word_at(png(std::string(500, 'x')), 20), height + 3 * 13 + 3 * 6);
    EXPECT_NO_THROW((void)png("\xff\x01\x80"));
}

TEST(Png, ShowsVisibility) {
    const std::string got = to_visibility_png(std::vector<float>{0.0F, 1.0F, 0.5F, -3.0F, 9.0F, nan}, 6, 1);
    EXPECT_EQ(got, base::to_png(std::vector<std::uint8_t>{255, 0, 128, 255, 0, 255}, 6, 1, 1));
    EXPECT_NE(got, base::to_png(std::vector<std::uint8_t>{0, 255, 128, 255, 0, 255}, 6, 1, 1));
}

}  // namespace gloam::record::pictures_test
