// SPDX-License-Identifier: MIT
#include "cli/list.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "catalogue/catalogue.hpp"
#include "cli/names.hpp"
#include "cli/setting_json.hpp"
#include "report/output_file.hpp"
#include "report/page.hpp"
#include "shader/variant.hpp"

namespace gloam::cli {
namespace {

struct ListOptions {
    std::string kind;
    bool json = false;
    std::filesystem::path html;
};

std::vector<Named> equation_names() {
    std::vector<Named> names;
    for (const catalogue::Entry& entry : catalogue::all_entries()) {
        const catalogue::Description& d = entry.description;
        names.push_back({d.id, d.function + ": " + d.title});
    }
    return names;
}

std::vector<Named> variant_names() {
    std::vector<Named> names;
    for (const shader::Variant& variant : shader::variants())
        names.push_back({variant.name, variant.description});
    return names;
}

using Kinds = std::vector<std::pair<std::string, std::function<std::vector<Named>()>>>;

Kinds all_kinds() {
    return {{"equations", equation_names}, {"methods", method_names},   {"presets", preset_names},
            {"scenes", scene_names},       {"settings", setting_names}, {"variants", variant_names},
            {"views", view_names}};
}

nlohmann::ordered_json named_json(const Named& named) {
    return {{"name", named.name}, {"description", named.description}};
}

nlohmann::ordered_json equation_json(const catalogue::Entry& entry) {
    const catalogue::Description& d = entry.description;
    return {{"name", d.id},
            {"description", d.title},
            {"function", check::to_glsl(entry.question.signature, d.function)},
            {"file", d.file},
            {"formula", d.formula},
            {"error", check::to_text(entry.question.budget)},
            {"source", d.source}};
}

// The names of a kind with all their properties.
nlohmann::ordered_json kind_json(const std::string& kind, const std::vector<Named>& names) {
    auto json = nlohmann::ordered_json::array();
    if (kind == "equations") {
        for (const catalogue::Entry& entry : catalogue::all_entries()) json.push_back(equation_json(entry));
        return json;
    }
    for (const Named& named : names)
        json.push_back(kind == "settings" ? json_of(effect::setting_named(named.name)) : named_json(named));
    return json;
}

// A page of all equations that can be searched and sorted.
std::string equations_page() {
    report::Page page("Equations of gloam");
    page.paragraph(
        "Occlusion is 1 where blocked, visibility 1 where open. View space is right-handed and looks down "
        "-z; depth d = -z is eye-linear. The error is what the function may differ from the exact "
        "mathematics.");
    report::PageTable table{.columns = {{.title = "ID"},
                                        {.title = "title"},
                                        {.title = "function"},
                                        {.title = "file", .filter = true},
                                        {.title = "error"},
                                        {.title = "source"},
                                        {.title = "formula"}},
                            .rows = {}};
    for (const catalogue::Entry& entry : catalogue::all_entries()) {
        const catalogue::Description& d = entry.description;
        table.rows.push_back({{d.id},
                              {d.title},
                              {d.function},
                              {d.file},
                              {check::to_text(entry.question.budget)},
                              {d.source},
                              {d.formula}});
    }
    page.table(table);
    return page.html();
}

void run_list(const ListOptions& options) {
    if (!options.html.empty()) {
        if (options.kind != "equations")
            throw std::invalid_argument("--html goes with `gloam list equations`");
        report::OutputFile(options.html).write(equations_page());
        return;
    }
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    std::vector<std::string> known;
    for (const auto& [kind, names] : all_kinds()) {
        known.push_back(kind);
        if (!options.kind.empty() && options.kind != kind) continue;
        if (options.kind.empty() && !options.json) fmt::print("{}\n", kind);
        const std::vector<Named> all = names();
        json[kind] = kind_json(kind, all);
        if (options.json) continue;
        for (const Named& named : all) {
            if (options.kind.empty()) fmt::print("  {:<26} {}\n", named.name, named.description);
            if (!options.kind.empty()) fmt::print("{}\n", named.name);
        }
    }
    if (json.empty()) {
        throw std::invalid_argument(
            fmt::format("unknown kind \"{}\": expected {}", options.kind, fmt::join(known, ", ")));
    }
    if (options.json) fmt::print("{}\n", options.kind.empty() ? json.dump(2) : json[options.kind].dump(2));
}

}  // namespace

void add_list(CLI::App& app) {
    auto options = std::make_shared<ListOptions>();
    CLI::App* command = app.add_subcommand("list", "the names that the other commands take");
    command->add_option("kind", options->kind,
                        "equations, methods, presets, scenes, settings, variants or views (one name a line); "
                        "all when not given");
    command->add_flag("--json", options->json, "names and descriptions as JSON");
    command->add_option("--html", options->html,
                        "equations only: write a page of them all that is searched and sorted");
    command->callback([options] { run_list(*options); });
}

}  // namespace gloam::cli
