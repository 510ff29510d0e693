// SPDX-License-Identifier: MIT
#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "effect/methods.hpp"
#include "shader/pack.hpp"
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

}  // namespace

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

std::vector<catalogue::Description> method_equations(
    const effect::MethodInfo& method, const std::filesystem::path& library,
    const std::map<std::string, catalogue::Description>& equations) {
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

std::string method_json(const effect::MethodInfo& method,
                        const std::vector<catalogue::Description>& equations, const MethodFailure& failure,
                        const std::string& caption) {
    ordered_json rows = ordered_json::array();
    for (const catalogue::Description& equation : equations)
        rows.push_back({{"name", equation.id},
                        {"title", equation.title},
                        {"formula", equation.formula},
                        {"source", equation.source},
                        {"function", equation.function}});
    const ordered_json json{{"name", method.name},           {"description", method.description},
                            {"file", file_of(method)},       {"measure", to_string(method.measure)},
                            {"falloff", method.falloff},     {"equations", rows},
                            {"presets", presets_of(method)}, {"fails", failure.words},
                            {"number", failure.number},      {"caption", caption}};
    return json.dump(-1, ' ', true);
}

}  // namespace gloam::site
