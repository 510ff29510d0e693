// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <algorithm>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "catalogue/catalogue.hpp"
#include "effect/methods.hpp"
#include "module/texts.hpp"
#include "report/page.hpp"
#include "site/page_data.hpp"

namespace gloam::site {

namespace {

bool has_name(const std::string& names, const std::string& name) {
    std::istringstream words(names);
    for (std::string word; words >> word;)
        if (word == name || word == name + ",") return true;
    return false;
}

// Where a method fails, in words, and by how much.
struct MethodFailure {
    std::string words;
    std::string number;
};

// Of the methods that the table names.
std::map<std::string, MethodFailure> method_failures(std::string_view markdown) {
    static const std::regex row(R"(^\| ([^|]*) \| ([^|]*) \| ([^|]*) \|$)");
    constexpr std::string_view head = "| method | fails | number |\n";
    const std::size_t table = markdown.find(head);
    if (table == std::string_view::npos)
        throw std::runtime_error("methods.md: expected a table with the columns method, fails and number");
    std::map<std::string, MethodFailure> failures;
    std::istringstream lines(std::string(markdown.substr(table + head.size())));
    std::smatch cells;
    for (std::string line; std::getline(lines, line) && std::regex_match(line, cells, row);)
        for (const effect::MethodInfo& method : effect::methods())
            if (has_name(cells[1], method.name)) failures[method.name] = {cells[2], cells[3]};
    return failures;
}

using Equations = std::map<std::string, catalogue::Description>;

// The equations of occlusion that a method's function uses, its own first.
std::vector<catalogue::Description> method_equations(const effect::MethodInfo& method,
                                                     const std::filesystem::path& library,
                                                     const Equations& equations) {
    const std::string own = "gloam_" + method.name;
    const std::string text =
        shader::pack(std::vector{library / file_of(method)}, {.functions = {own}}, {library});
    std::vector<catalogue::Description> used;
    for (const auto& [id, equation] : equations) {
        const bool of_occlusion =
            equation.file.starts_with("gloam/occlusion/") || equation.file.starts_with("gloam/methods/");
        if (of_occlusion && text.find(" " + equation.function + "(") != std::string::npos)
            used.push_back(equation);
    }
    std::ranges::stable_partition(used, [&own](const auto& equation) { return equation.function == own; });
    return used;
}

// The presets that run the method, the one with the least error first.
std::vector<effect::Preset> presets_of(const effect::MethodInfo& method) {
    std::vector<effect::Preset> own;
    for (const effect::Preset& preset : effect::presets())
        if (preset.settings.method == method.name) own.push_back(preset);
    std::ranges::sort(own, {}, &effect::Preset::error);
    return own;
}

std::string numbers_of(const effect::Preset& preset) {
    return fmt::format("{}: error {:.4f}, time {:.2f}", preset.name, preset.error, preset.time);
}

// A list of terms and what is said of each; texts are escaped, `code` stands behind the text.
class Terms {
  public:
    void add(const std::string& term, const std::string& text, const std::string& code = {}) {
        html_ +=
            fmt::format("<dt>{}</dt><dd>{}{}</dd>\n", report::escaped_html(term), report::escaped_html(text),
                        code.empty() ? "" : " <code>" + report::escaped_html(code) + "</code>");
    }
    [[nodiscard]] std::string html() const { return "<dl>\n" + html_ + "</dl>\n"; }

  private:
    std::string html_;
};

// A method with its picture, and its details folded below.
std::string card_of(const effect::MethodInfo& method, const std::vector<catalogue::Description>& equations,
                    const MethodFailure& failure, bool with_picture) {
    Terms terms;
    terms.add("copy it", "", fmt::format("gloam pack {} --function gloam_{}", file_of(method), method.name));
    terms.add("estimates", to_string(method.measure));
    terms.add("falloff", method.falloff);
    for (const catalogue::Description& equation : equations)
        terms.add(equation.id, equation.title + " [" + equation.source + "]", equation.formula);
    for (const effect::Preset& preset : presets_of(method)) terms.add(numbers_of(preset), preset.description);
    if (!failure.words.empty())
        terms.add("where it fails", failure.words + "; error, by gloam bench methods: " + failure.number);
    const std::string picture =
        with_picture ? fmt::format(
                           "<img src=\"method-{0}.png\" alt=\"occlusion of a room by {0}\" width=\"{1}\" "
                           "height=\"{2}\">\n",
                           method.name, method_picture_width, method_picture_height)
                     : "";
    return fmt::format(
        "<section class=\"method\" id=\"{0}\">\n{1}<h2>{0}</h2>\n<p>{2}</p>\n<details><summary>equations, "
        "presets, "
        "where it fails<span class=\"unseen\"> of {0}</span></summary>\n{3}</details>\n</section>\n",
        method.name, picture, report::escaped_html(method.description), terms.html());
}

// One row for each method, with its preset of the least error.
report::Table table_of(const std::vector<effect::MethodInfo>& methods) {
    report::Table table{.columns = {{.title = "method"},
                                    {.title = "estimates", .filter = true},
                                    {.title = "error", .numeric = true},
                                    {.title = "time", .numeric = true},
                                    {.title = "preset"},
                                    {.title = "what it is"}},
                        .rows = {}};
    for (const effect::MethodInfo& method : methods) {
        const std::vector<effect::Preset> own = presets_of(method);
        const auto number = [&](double effect::Preset::* value, int digits) {
            return own.empty()
                       ? report::Cell("")
                       : report::Cell(fmt::format("{:.{}f}", own.front().*value, digits), own.front().*value);
        };
        table.rows.push_back({method.name, to_string(method.measure), number(&effect::Preset::error, 4),
                              number(&effect::Preset::time, 2), own.empty() ? "" : own.front().name,
                              method.description});
    }
    return table;
}

}  // namespace

std::string methods_html(const std::vector<effect::MethodInfo>& methods, const std::filesystem::path& library,
                         std::string_view failures, const std::string& caption) {
    std::map<std::string, MethodFailure> known = method_failures(failures);
    const Equations equations = catalogue::descriptions(library);
    report::Page page("");
    if (!caption.empty()) page.markup("<p class=\"soft\">" + report::escaped_html(caption) + "</p>\n");
    page.markup("<div class=\"methods\">\n");
    for (const effect::MethodInfo& method : methods)
        page.markup(card_of(method, method_equations(method, library, equations), known[method.name],
                            !caption.empty()));
    page.markup("</div>\n");
    page.heading("Error and time");
    page.table(table_of(methods));
    return page.body();
}

}  // namespace gloam::site
