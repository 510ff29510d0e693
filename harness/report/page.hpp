// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gloam::report {

// How a table cell is marked.
enum class Tone { plain, good, bad };

// A cell of a table. With a value the column is sorted by it, otherwise by the text.
struct PageCell {
    std::string text;
    std::optional<double> value{};
    Tone tone = Tone::plain;
};

// A cell that is sorted by `value` and shows `text`.
[[nodiscard]] inline PageCell number_cell(double value, std::string text) {
    return {.text = std::move(text), .value = value};
}

struct PageColumn {
    std::string title;
    std::string meaning{};  // one sentence, listed above the table; empty: the title says it
    bool numeric = false;   // aligned to the right; the first click sorts the largest to the top
    bool filter = false;    // has few different texts, of which one can be chosen
};

// A table that a reader sorts by a click on a title, and filters by words and by the columns' own choices.
struct PageTable {
    std::vector<PageColumn> columns;
    std::vector<std::vector<PageCell>> rows;  // each as many cells as there are columns
};

// A picture file beside the page, and what it shows.
struct PagePicture {
    std::string file;
    std::string caption;
};

// An HTML page in one file: no network, no library; light or dark as the reader's system is; every control
// can be reached by keyboard. Texts may come from anywhere: they are escaped, and the page's content security
// policy lets the page's own script run and no other.
class Page {
  public:
    explicit Page(std::string_view title);

    void heading(std::string_view text);
    void paragraph(std::string_view text);
    void preformatted(std::string_view text);

    // Two pictures of one size, one above the other behind a slider: `before` to its left.
    void compare(const PagePicture& before, const PagePicture& after, std::string_view caption);

    // Pictures side by side, as many in a row as fit.
    void pictures(const std::vector<PagePicture>& pictures);

    // One of several pictures, chosen with a slider: views around an object, or frames.
    void turntable(const std::vector<PagePicture>& pictures, std::string_view caption);

    // Throws std::invalid_argument for a row with another number of cells than there are columns.
    void table(const PageTable& table);

    // The whole file.
    [[nodiscard]] std::string html() const;

  private:
    std::string title_;
    std::string body_;
};

// The text for HTML, in element content and in quoted attributes: & < > " ' as entities, control characters
// other than tab and line break as U+FFFD. Bytes that are not UTF-8 stay: a browser shows them as U+FFFD.
[[nodiscard]] std::string escaped_html(std::string_view text);

}  // namespace gloam::report
