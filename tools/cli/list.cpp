// SPDX-License-Identifier: MIT
#include "cli/list.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "catalogue/catalogue.hpp"
#include "catalogue/document.hpp"
#include "cli/names.hpp"
#include "cli/setting_json.hpp"
#include "shader/variant.hpp"

namespace gloam::cli {
namespace {

struct ListOptions {
    std::string kind;
    bool json = false;
    bool markdown = false;
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
            {"scenes", scene_names},       {"settings", setting_names}, {"variants", variant_names}};
}

nlohmann::ordered_json named_json(const Named& named) {
    return {{"name", named.name}, {"description", named.description}};
}

void run_list(const ListOptions& options) {
    if (options.markdown) {
        if (options.kind != "equations")
            throw std::invalid_argument("--markdown goes with `gloam list equations`");
        fmt::print("{}", catalogue::to_markdown(catalogue::all_entries()));
        return;
    }
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    std::vector<std::string> known;
    for (const auto& [kind, names] : all_kinds()) {
        known.push_back(kind);
        if (!options.kind.empty() && options.kind != kind) continue;
        if (options.kind.empty() && !options.json) fmt::print("{}\n", kind);
        for (const Named& named : names()) {
            json[kind].push_back(kind == "settings" ? json_of(effect::setting_named(named.name))
                                                    : named_json(named));
            if (options.json) continue;
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
    command->add_option(
        "kind", options->kind,
        "equations, methods, presets, scenes, settings or variants (one name a line); all when not given");
    command->add_flag("--json", options->json, "names and descriptions as JSON");
    command->add_flag("--markdown", options->markdown, "equations only: the page docs/equations.md");
    command->callback([options] { run_list(*options); });
}

}  // namespace gloam::cli
