// SPDX-License-Identifier: MIT
#include "record/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "base/text.hpp"
#include "base/version.hpp"
#include "record/assets.hpp"

namespace gloam::record {
namespace {

// The script's hash for the content security policy: base64 of bytes that are given in hexadecimal.
std::string base64_of_hex(std::string_view hex) {
    std::vector<unsigned char> bytes;
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
        unsigned byte = 0;
        (void)std::from_chars(&hex[i], &hex[i] + 2, byte, 16);
        bytes.push_back(static_cast<unsigned char>(byte));
    }
    return base::base64(bytes);
}

// The path of a URL: characters with a special meaning become %XX.
std::string url_of(std::string_view file) {
    constexpr std::string_view plain = "-_.~/";
    std::string url;
    for (const char c : file) {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (letter || plain.find(c) != std::string_view::npos)
            url += c;
        else
            url += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return url;
}

std::string cell_html(const Column& column, const Cell& cell) {
    std::string style = column.numeric ? "number" : "";
    if (cell.tone != Tone::plain)
        style += std::string(style.empty() ? "" : " ") + (cell.tone == Tone::good ? "good" : "bad");
    std::string html = "<td";
    if (!style.empty()) html += fmt::format(" class=\"{}\"", style);
    if (cell.value && std::isinf(*cell.value))
        html += *cell.value > 0 ? " data-value=\"Infinity\"" : " data-value=\"-Infinity\"";
    else if (cell.value && !std::isnan(*cell.value))
        html += fmt::format(" data-value=\"{}\"", *cell.value);
    return html + ">" + escaped_html(cell.text) + "</td>";
}

// A selection list of the distinct texts of a column.
std::string choice_html(const Table& table, std::size_t column) {
    std::set<std::string> texts;
    for (const auto& row : table.rows) texts.insert(row[column].text);
    if (texts.size() < 2) return {};
    std::string html = fmt::format("<label>{} <select data-column=\"{}\"><option value=\"\">all</option>",
                                   escaped_html(table.columns[column].title), column);
    for (const std::string& text : texts) html += fmt::format("<option>{}</option>", escaped_html(text));
    return html + "</select></label>\n";
}

std::string meanings_html(const Table& table) {
    std::string html;
    for (const Column& column : table.columns) {
        if (column.meaning.empty()) continue;
        html +=
            fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped_html(column.title), escaped_html(column.meaning));
    }
    return html.empty() ? html : "<dl>\n" + html + "</dl>\n";
}

}  // namespace

std::string escaped_html(std::string_view text) {
    constexpr std::pair<char, const char*> entities[]{
        {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}};
    std::string html;
    html.reserve(text.size());
    for (const char c : text) {
        const auto* const entity = std::ranges::find(entities, c, &std::pair<char, const char*>::first);
        const auto byte = static_cast<unsigned char>(c);
        if (entity != std::end(entities))
            html += entity->second;
        else if ((byte < 0x20 && c != '\n' && c != '\t') || byte == 0x7F)
            html += "\xEF\xBF\xBD";
        else
            html += c;
    }
    return html;
}

void Page::heading(std::string_view text) {
    body_ += fmt::format("<h2>{}</h2>\n", escaped_html(text));
}

void Page::paragraph(std::string_view text) {
    body_ += fmt::format("<p>{}</p>\n", escaped_html(text));
}

void Page::preformatted(std::string_view text) {
    body_ += fmt::format("<pre>{}</pre>\n", escaped_html(text));
}

void Page::script(std::string_view file) {
    scripts_ += fmt::format("<script src=\"{}\" defer></script>\n", url_of(file));
}

void Page::choose(const std::vector<PagePicture>& pictures, std::string_view caption) {
    const std::string group = fmt::format("choice{}", ++choices_);
    body_ += "<figure class=\"choose\">\n";
    for (std::size_t i = 0; i < pictures.size(); ++i)
        body_ += fmt::format(
            "<input type=\"radio\" name=\"{0}\" id=\"{0}-{1}\"{2}><label for=\"{0}-{1}\">{3}</label>\n",
            group, i, i == 0 ? " checked" : "", escaped_html(pictures[i].caption));
    for (const PagePicture& picture : pictures)
        body_ +=
            fmt::format("<img src=\"{}\" alt=\"{}\">\n", url_of(picture.file), escaped_html(picture.caption));
    body_ += fmt::format("<figcaption>{}</figcaption>\n</figure>\n", escaped_html(caption));
}

void Page::table(const Table& table) {
    constexpr std::size_t few = 8;  // rows that a reader takes in at once
    body_ += fmt::format(
        "<section class=\"table\">\n{}<div class=\"filter\"{}><label>Find <input type=\"search\"></label>\n",
        meanings_html(table), table.rows.size() < few ? " hidden" : "");
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        if (table.columns[i].filter) body_ += choice_html(table, i);
    body_ +=
        "<output></output></div>\n<div class=\"wide\" tabindex=\"0\" role=\"region\" "
        "aria-label=\"Table\"><table>\n<thead><tr>";
    for (const Column& column : table.columns)
        body_ += fmt::format("<th scope=\"col\"{}><button type=\"button\">{}</button></th>",
                             column.numeric ? " class=\"number\"" : "", escaped_html(column.title));
    body_ += "</tr></thead>\n<tbody>\n";
    for (const auto& row : table.rows) {
        body_ += "<tr>";
        for (std::size_t i = 0; i < row.size(); ++i) body_ += cell_html(table.columns[i], row[i]);
        body_ += "</tr>\n";
    }
    body_ += "</tbody>\n</table></div>\n</section>\n";
}

std::string Page::html() const {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src 'self' file:; "
        "style-src 'unsafe-inline'; script-src 'sha256-{}'{}\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta name=\"generator\" content=\"gloam {}\">\n<title>{}</title>\n"
        "<style>\n{}</style>\n{}</head>\n<body>\n<main>\n<h1>{}</h1>\n{}</main>\n<script>{}</script>\n"
        "</body>\n</html>\n",
        base64_of_hex(internal::page_script_sha256), scripts_.empty() ? "" : " 'self' file:", base::version(),
        escaped_html(title_), internal::page_style, scripts_, escaped_html(title_), body_,
        internal::page_script);
}

}  // namespace gloam::record
