// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/version.hpp"
#include "catalogue/catalogue.hpp"
#include "cli/environment.hpp"
#include "cli/names.hpp"
#include "cli/settings.hpp"
#include "effect/methods.hpp"
#include "effect/settings.hpp"
#include "report/output.hpp"
#include "report/page.hpp"
#include "shader/compile.hpp"

namespace gloam::cli {
namespace {

struct ListOptions {
    std::string kind;
    std::string name;  // empty: all
    bool json = false;
    std::filesystem::path html;
};

std::vector<Named> equation_names() {
    std::vector<Named> names;
    for (const catalogue::Entry& entry : catalogue::all_entries(glsl_directory())) {
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

// As `--preset FILE.json` reads it: "settings" has those that differ from `tssao-paper`.
nlohmann::ordered_json preset_json(const Named& named) {
    const effect::Preset preset = effect::preset_named(named.name);
    nlohmann::ordered_json json{{"name", preset.name},
                                {"description", preset.description},
                                {"published", preset.published},
                                {"error", preset.error},
                                {"time", preset.time}};
    json["settings"] = nlohmann::ordered_json::object();
    for (const effect::Setting& setting : effect::setting_table()) {
        const effect::SettingValue value = setting.get(preset.settings);
        if (value != setting.get(effect::Settings{})) json["settings"][setting.name] = json_of(value);
    }
    return json;
}

nlohmann::ordered_json method_json(const Named& named) {
    const effect::MethodInfo& method = effect::method_named(named.name);
    nlohmann::ordered_json json = named_json(named);
    json["measure"] = to_string(method.measure);
    json["falloff"] = method.falloff;
    json["samples"] = with_method(effect::Settings{}, method.name).samples;
    json["file"] = file_of(method);
    return json;
}

// The names of a kind with all their properties.
nlohmann::ordered_json kind_json(const std::string& kind, const std::vector<Named>& names) {
    auto json = nlohmann::ordered_json::array();
    if (kind == "equations") {
        for (const catalogue::Entry& entry : catalogue::all_entries(glsl_directory()))
            json.push_back(equation_json(entry));
        return json;
    }
    for (const Named& named : names)
        json.push_back(kind == "settings"  ? json_of(effect::setting_named(named.name))
                       : kind == "presets" ? preset_json(named)
                       : kind == "methods" ? method_json(named)
                                           : named_json(named));
    return json;
}

// All that is known of one name. Throws std::invalid_argument for a name that the kind does not have.
nlohmann::ordered_json one_of(const std::string& kind, const nlohmann::ordered_json& all,
                              const std::string& name) {
    for (const auto& each : all)
        if (each.at("name") == name) return each;
    if (kind == "presets") (void)effect::preset_named(name);  // gives the new name of an old one
    throw std::invalid_argument(
        fmt::format("{} \"{}\": expected a name of `gloam list {}`", kind, name, kind));
}

// A property a line; what a preset sets as `--set` takes it, and the method as `--method` does.
void print_one(const nlohmann::ordered_json& one) {
    for (const auto& [key, value] : one.items()) {
        if (!value.is_object()) fmt::print("{}: {}\n", key, text_of(value));
        if (value.is_object())
            for (const auto& [setting, set] : value.items()) fmt::print("  {}={}\n", setting, text_of(set));
    }
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
    for (const catalogue::Entry& entry : catalogue::all_entries(glsl_directory())) {
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

// One name a line; with its meaning where all kinds are listed, and for settings and presets, between which
// one chooses by value, error and time.
void print_names(const std::vector<Named>& names, const std::string& kind) {
    const bool alone = !kind.empty() && kind != "settings" && kind != "presets";
    std::size_t width = 18;
    for (const Named& named : names) width = std::max(width, named.name.size());
    for (const Named& named : names) {
        if (alone) fmt::print("{}\n", named.name);
        if (!alone)
            fmt::print("{}{:<{}} {}\n", kind.empty() ? "  " : "", named.name, width, named.description);
    }
}

void run_list(const ListOptions& options) {
    if (!options.html.empty()) {
        if (options.kind != "equations")
            throw std::invalid_argument("--html goes with `gloam list equations`");
        report::OutputFile(options.html).write(equations_page());
        return;
    }
    nlohmann::ordered_json json{{"gloam", base::version()}};
    std::vector<std::string> known;
    for (const auto& [kind, names] : all_kinds()) {
        known.push_back(kind);
        if (!options.kind.empty() && options.kind != kind) continue;
        if (options.kind.empty() && !options.json) fmt::print("{}\n", kind);
        const std::vector<Named> all = names();
        json[kind] = kind_json(kind, all);
        if (!options.name.empty()) json[kind] = one_of(kind, json[kind], options.name);
        if (options.json) continue;
        if (!options.name.empty()) print_one(json[kind]);
        if (options.name.empty()) print_names(all, options.kind);
    }
    if (json.size() == 1) {
        throw std::invalid_argument(
            fmt::format("unknown kind \"{}\": expected {}", options.kind, fmt::join(known, ", ")));
    }
    if (!options.name.empty()) {
        json.update(nlohmann::ordered_json(json[options.kind]));
        json.erase(options.kind);
    }
    if (options.json) fmt::print("{}\n", json.dump(2));
}

}  // namespace

void add_list(CLI::App& app) {
    auto options = std::make_shared<ListOptions>();
    CLI::App* command = app.add_subcommand("list", "the names that the other commands take");
    command->add_option(
        "kind", options->kind,
        "equations, methods, presets, scenes, settings, variants or views: one name a line, of "
        "settings with meaning, default and range, of presets with error and time, gloam's own first; all "
        "when not given");
    command->add_option("name", options->name,
                        "all that is known of this one: of a preset the settings that it changes, of a "
                        "method what it measures");
    command->add_flag("--json", options->json, "names, descriptions and all other properties as JSON");
    command->add_option("--html", options->html,
                        "equations only: write a page of them all that is searched and sorted");
    command->callback([options] { run_list(*options); });
}

}  // namespace gloam::cli
