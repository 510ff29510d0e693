// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "record/table.hpp"

namespace gloam::record {

// A picture file beside the page, and its description.
struct PagePicture {
    std::string file;
    std::string caption;
};

// An HTML page in one file, without network or library. It is light or dark like the reader's system, and
// every control is accessible by keyboard. Texts can be untrusted: they are escaped, and the content security
// policy permits the page's own script only, and those of script().
class Page {
  public:
    explicit Page(std::string_view title) : title_(title) {}

    void heading(std::string_view text);
    void paragraph(std::string_view text);
    void preformatted(std::string_view text);

    // Elements of HTML as they are: the caller has escaped what they contain.
    void markup(std::string_view html) { body_ += html; }

    // A script in a file beside the page. It runs when the page has been read.
    void script(std::string_view file);

    // Pictures of one size with a button each: the chosen one is shown, at first the first. At most four.
    void choose(const std::vector<PagePicture>& pictures, std::string_view caption);

    // A table that is sorted by a click on a title, and from eight rows on filtered by words and columns.
    void table(const Table& table);

    // The complete file.
    [[nodiscard]] std::string html() const;

  private:
    std::string title_;
    std::string body_;
    std::string scripts_;  // elements
    int choices_ = 0;
};

// Escapes a text for HTML, in element content and in quoted attributes: & < > " ' become entities, control
// characters except tab and line break become U+FFFD. Bytes that are not UTF-8 stay; browsers show U+FFFD.
[[nodiscard]] std::string escaped_html(std::string_view text);

}  // namespace gloam::record
