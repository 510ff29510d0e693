// SPDX-License-Identifier: MIT
#include "report/check_page.hpp"
#include "report/image.hpp"
#include "report/internal/plot_layout.hpp"
#include "report/page.hpp"
#include "report/plot.hpp"
#include "report/rows.hpp"
#include "support/files.hpp"

namespace gloam::report::pictures_test {

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
    page.compare({hostile, hostile}, {hostile, hostile}, hostile);
    page.pictures({{hostile, hostile}});
    page.turntable({{hostile, hostile}, {"../../x:y", "b"}}, hostile);
    page.table({.columns = {{.title = hostile, .meaning = hostile, .filter = true}},
                .rows = {{{hostile}}, {{"other"}}}});
    const std::string html = page.html();
    EXPECT_EQ(count_of(html, "<script"), 1U);
    EXPECT_EQ(count_of(html, "</script>"), 1U);
    EXPECT_THAT(html, Not(HasSubstr("alert(1)<")));
    EXPECT_THAT(html, Not(HasSubstr("onload='")));
    EXPECT_THAT(html, Not(HasSubstr("\x01")));
    EXPECT_THAT(html, HasSubstr("src=\"../../x%3Ay\""));  // no scheme of a URL
}

TEST(Page, NeedsNoNetworkAndLetsItsOwnScriptRunAlone) {
    Page page("p");
    const std::string html = page.html();
    EXPECT_THAT(html, HasSubstr("default-src 'none'"));
    EXPECT_THAT(html, HasSubstr("script-src 'sha256-"));
    EXPECT_THAT(html, Not(HasSubstr("http://")));
    EXPECT_THAT(html, Not(HasSubstr("https://")));
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

TEST(Page, ARowWithoutItsCellsIsRefused) {
    Page page("p");
    EXPECT_THROW(page.table({.columns = {{.title = "a"}, {.title = "b"}}, .rows = {{{"1"}}}}),
                 std::invalid_argument);
}

TEST(CheckPage, FailuresComeFirstAndEveryRowIsThere) {
    check::Answer crashed = passing_row("EQ-9");
    crashed.error = hostile;
    crashed.reason = check::Reason::crash;
    const std::vector<CheckReport> reports{report_of("A", {passing_row("EQ-1"), failing_row()}),
                                           report_of(hostile, {crashed})};
    const PageTable table = check_table(reports);
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
    check::Answer row = failing_row();
    row.worst->values = std::string(100'000, 'x');
    const std::vector<CheckReport> reports{report_of("A", std::vector<check::Answer>(150, row))};
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

TEST(Sheet, CaptionsAreDrawnAndCutAtThePicturesWidth) {
    const auto png = [](const std::string& caption) {
        return to_sheet_png(std::vector{grey(caption)}, width, height, 1);
    };
    EXPECT_NE(png("gtao"), png(""));
    EXPECT_NE(png("gtao"), png("hbao"));
    EXPECT_EQ(png(std::string(500, 'x')), png(std::string(600, 'x')));
    EXPECT_NO_THROW((void)png("\xff\x01\x80"));
}

TEST(Sheet, RefusesWhatDoesNotFit) {
    EXPECT_THROW((void)to_sheet_png({}, width, height, 1), std::invalid_argument);
    EXPECT_THROW((void)to_sheet_png(std::vector{grey("")}, width, height, 0), std::invalid_argument);
    EXPECT_THROW((void)to_sheet_png(std::vector{grey("")}, width + 1, height, 1), std::invalid_argument);
}

TEST(Png, ShowsVisibility) {
    const std::string got = to_visibility_png(std::vector<float>{0.0F, 1.0F, 0.5F, -3.0F, 9.0F, nan}, 6, 1);
    EXPECT_EQ(got, base::to_png(std::vector<std::uint8_t>{255, 0, 128, 255, 0, 255}, 6, 1));
    EXPECT_NE(got, base::to_png(std::vector<std::uint8_t>{0, 255, 128, 255, 0, 255}, 6, 1));
}

using namespace internal;  // the layout of labels

TEST(Plot, IsAnSvgThatNamesItsCurves) {
    const double gap = std::numeric_limits<double>::quiet_NaN();
    const std::string svg = to_svg({.title = "it's a title",
                                    .x = "frame",
                                    .y = "error",
                                    .curves = {{"first", {{1, 2}, {2, gap}, {3, 1}}}, {"second", {{1, 1}}}}});
    for (const char* text : {"<svg", "it's a title", "frame", "error", "first", "second"})
        EXPECT_THAT(svg, HasSubstr(text));
}

TEST(Plot, DrawsFrontsWithTheirLabelsAndPng) {
    const Plot plot{.title = "front",
                    .x = "time",
                    .y = "error",
                    .logarithmic = true,
                    .curves = {{"all", {{1, 4}, {2, 3}, {3, 3}}, CurveStyle::background},
                               {"some", {{2, 3}}, CurveStyle::points},
                               {"best", {{1, 4}, {2, 3}}, CurveStyle::steps, {"first/4", "second/8"}}}};
    const std::string svg = to_svg(plot);
    for (const char* text : {"all", "some", "best", "first/4", "second/8"}) EXPECT_THAT(svg, HasSubstr(text));
    EXPECT_THAT(to_png(plot), StartsWith("\x89PNG"));
}

// Foreign texts, in every place that a text has, never reach gnuplot as its language. (They once did: a line
// break ended the title.)
TEST(Plot, TextsAreNeverObeyed) {
    const test::TemporaryDirectory scratch;
    const std::string proof = (scratch.path() / "proof").string();
    const std::vector<std::string> hostile = {"a\nsystem('touch " + proof + "')\n",
                                              "a'\nsystem('touch " + proof + "')\n#",
                                              "`touch " + proof + "`",
                                              "\"; system('touch " + proof + "'); #",
                                              "$(touch " + proof + ")",
                                              "END\nsystem('touch " + proof + "')\n",
                                              "@x\\\n! touch " + proof + "\n",
                                              std::string("a\0b", 3)};
    for (const std::string& text : hostile) {
        for (const bool logarithmic : {false, true}) {
            const Plot plot{.title = text,
                            .x = text,
                            .y = text,
                            .logarithmic = logarithmic,
                            .curves = {{text, {{1, 4}, {2, 3}}, CurveStyle::steps, {text, text}}}};
            EXPECT_THAT(to_svg(plot), HasSubstr("<svg")) << text;
            EXPECT_FALSE(std::filesystem::exists(proof)) << text;
        }
    }
}

// A text is shown literally, with any characters.
TEST(Plot, TextsAreShownAsTheyAre) {
    const std::string text = "7/4 \"x\" \\ 'y' `z` $w @v 100% {a}_b^c";
    const std::string svg = to_svg({.title = text, .curves = {{"c", {{1, 1}, {2, 3}}}}});
    EXPECT_THAT(svg, HasSubstr("7/4 \"x\" \\ 'y' `z` $w @v 100% {a}_b^c"));
}

// No shell is used: environment variables do not become part of a command.
TEST(Plot, TheFolderForTemporaryFilesIsNoCommand) {
    const test::TemporaryDirectory scratch;
    const std::string folder = (scratch.path() / "it's; a $(folder)").string();
    std::filesystem::create_directory(folder);
    ::setenv("TMPDIR", folder.c_str(), 1);
    EXPECT_THAT(to_svg({.title = "t", .curves = {{"c", {{1, 1}, {2, 2}}}}}), HasSubstr("<svg"));
    ::unsetenv("TMPDIR");
}

TEST(Plot, LabelsOfAnotherNumberAreAnError) {
    expect_error<std::invalid_argument>(
        [] { (void)to_svg({.title = "t", .curves = {{"c", {{1, 1}, {2, 2}}, CurveStyle::steps, {"one"}}}}); },
        {"1 labels, expected 2"});
}

TEST(Plot, WithoutAPointIsAnError) {
    expect_error<std::invalid_argument>([] { (void)to_svg({.title = "empty", .curves = {{"none", {}}}}); },
                                        {"\"empty\""});
}

TEST(PlotLayout, RangesHoldWhatIsShown) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const LogRange range = range_around({20.0, nan, 0.0, -1.0, 80.0});
    EXPECT_GT(range.low, 15.0);
    EXPECT_LT(range.low, 20.0);
    EXPECT_GT(range.high, 80.0);
    EXPECT_LT(range.high, 100.0);
    EXPECT_DOUBLE_EQ(range.at(range.low), 0.0);
    EXPECT_DOUBLE_EQ(range.at(range.high), 1.0);
    const LogRange one = range_around({3.0});
    EXPECT_LT(one.low, 3.0);
    EXPECT_GT(one.high, 3.0);
    EXPECT_LT(range_around({}).low, range_around({}).high);
}

TEST(PlotLayout, TicsAreRoundAndWithinTheRange) {
    EXPECT_THAT(tics_of({3.0, 300.0}),
                testing::Pointwise(testing::DoubleEq(), {5.0, 10.0, 20.0, 50.0, 100.0, 200.0}));
    EXPECT_THAT(tics_of({0.07, 0.16}),
                testing::Pointwise(testing::DoubleNear(1e-12), {0.08, 0.1, 0.12, 0.15}));
}

// Twenty points that nearly coincide: every label can still be read.
TEST(PlotLayout, LabelsDoNotCoverEachOther) {
    Plot plot{.title = "crowd", .logarithmic = true};
    plot.curves.push_back({.name = "points"});
    for (int i = 0; i < 20; ++i) {
        plot.curves[0].points.emplace_back(10.0 + 0.1 * i, 0.1 + 0.0001 * i);
        plot.curves[0].labels.push_back("method/" + std::to_string(i));
    }
    plot.curves[0].points.emplace_back(1000.0, 1.0);
    plot.curves[0].labels.emplace_back("corner");
    const auto labels = placed_labels(plot, {5.0, 1010.0}, {0.05, 1.01});
    ASSERT_EQ(labels.size(), 21U);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const bool same_line = std::abs(labels[i].at.second - labels[j].at.second) < 0.03;
            const bool beside = std::abs(labels[i].at.first - labels[j].at.first) > 0.06;
            EXPECT_TRUE(!same_line || beside) << labels[i].text << ' ' << labels[j].text;
        }
    }
    EXPECT_LT(labels.back().at.first, labels.back().point.first - 0.05) << "it would reach beyond the plot";
}

}  // namespace gloam::report::pictures_test
