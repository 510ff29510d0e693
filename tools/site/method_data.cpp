// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "catalogue/catalogue.hpp"
#include "effect/methods.hpp"
#include "module/texts.hpp"
#include "site/page_data.hpp"

namespace gloam::site {

namespace {

using nlohmann::ordered_json;

bool has_name(const std::string& names, const std::string& name) {
    std::istringstream words(names);
    for (std::string word; words >> word;)
        if (word == name || word == name + ",") return true;
    return false;
}

// The presets that run the method, with what was measured of them.
ordered_json presets_of(const effect::MethodInfo& method) {
    ordered_json rows = ordered_json::array();
    for (const effect::Preset& preset : effect::presets())
        if (preset.settings.method == method.name)
            rows.push_back({{"name", preset.name},
                            {"description", preset.description},
                            {"error", preset.error},
                            {"time", preset.time}});
    return rows;
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

ordered_json equations_json(const std::vector<catalogue::Description>& equations) {
    ordered_json rows = ordered_json::array();
    for (const catalogue::Description& equation : equations)
        rows.push_back({{"name", equation.id},
                        {"title", equation.title},
                        {"formula", equation.formula},
                        {"source", equation.source}});
    return rows;
}

}  // namespace

std::string methods_json(const std::vector<effect::MethodInfo>& methods, const std::filesystem::path& library,
                         std::string_view failures, const std::string& caption) {
    std::map<std::string, MethodFailure> known = method_failures(failures);
    const Equations equations = catalogue::descriptions(library);
    ordered_json json = ordered_json::array();
    for (const effect::MethodInfo& method : methods)
        json.push_back({{"name", method.name},
                        {"description", method.description},
                        {"file", file_of(method)},
                        {"measure", to_string(method.measure)},
                        {"falloff", method.falloff},
                        {"equations", equations_json(method_equations(method, library, equations))},
                        {"presets", presets_of(method)},
                        {"fails", known[method.name].words},
                        {"number", known[method.name].number},
                        {"caption", caption}});
    return json.dump(-1, ' ', true);
}

}  // namespace gloam::site
