// SPDX-License-Identifier: MIT
#include "site/pages.hpp"

#include <stdexcept>

#include "base/files.hpp"
#include "report/page.hpp"

namespace gloam::site {

namespace {

// The text between two others; throws with the name of the page that lacks it.
std::string between(const std::string& text, const std::string& begin, const std::string& end,
                    const std::string& page) {
    const std::size_t at = text.find(begin);
    const std::size_t to = at == std::string::npos ? at : text.find(end, at + begin.size());
    if (to == std::string::npos) throw std::runtime_error(page + ": expected " + begin + " ... " + end);
    return text.substr(at + begin.size(), to - at - begin.size());
}

// How other sites show a link to a page.
std::string preview_of(const std::string& title, const std::string& description, const std::string& page,
                       const SiteOptions& options) {
    const auto meta = [](const std::string& property, const std::string& content) {
        return "<meta property=\"" + property + "\" content=\"" + content + "\">\n";
    };
    std::string text =
        meta("og:type", "website") + meta("og:title", title) + meta("og:description", description);
    const std::string address = report::escaped_html(options.address);
    if (!address.empty()) text += meta("og:url", address + page);
    if (!options.pictures.preview.empty()) text += meta("og:image", address + options.pictures.preview);
    return text;
}

}  // namespace

std::string page_text(const std::string& name, const std::string& text, const SiteOptions& options) {
    const std::string title = between(text, "<title>", "</title>", name);
    const std::string description = between(text, "<meta name=\"description\" content=\"", "\">", name);
    const std::size_t head = text.find("<title>");
    std::string page = base::read_file(options.files / "template.html");
    const auto put = [&page, &name](const std::string& marker, const std::string& part) {
        const std::size_t at = page.find(marker);
        if (at == std::string::npos) throw std::runtime_error(name + ": no " + marker + " in the template");
        page.replace(at, marker.size(), part);
    };
    put("<!-- head -->\n",
        preview_of(title, description, name, options) + text.substr(head, text.find("<main>\n") - head));
    put("<!-- main -->\n", between(text, "<main>\n", "</main>", name));
    return page;
}

std::string replaced(std::string text, const std::string& marker, const std::string& words) {
    for (std::size_t at = 0; (at = text.find(marker, at)) != std::string::npos; at += words.size())
        text.replace(at, marker.size(), words);
    return text;
}

}  // namespace gloam::site
