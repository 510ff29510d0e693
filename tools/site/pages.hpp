// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "report/output.hpp"
#include "site/site.hpp"

namespace gloam::site {

// Writes the files of a site and counts their bytes.
class Files {
  public:
    explicit Files(report::OutputFolder& folder) : folder_(folder) {}
    void write(const std::string& name, const std::string& text) {
        folder_.write(name, text);
        bytes_ += text.size();
    }
    [[nodiscard]] std::size_t bytes() const { return bytes_; }

  private:
    report::OutputFolder& folder_;
    std::size_t bytes_ = 0;
};

// A page of the template with the text of its file, which has a title, a description, further elements of the
// head, then the main element. Other sites that link to it show title, description and preview. Throws
// std::runtime_error with the page's name for a text without these.
[[nodiscard]] std::string page_text(const std::string& name, const std::string& text,
                                    const SiteOptions& options);

// A text with other words in the place of each marker.
[[nodiscard]] std::string replaced(std::string text, const std::string& marker, const std::string& words);

}  // namespace gloam::site
