// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <ranges>
#include <stdexcept>

#include "base/version.hpp"
#include "catalogue/catalogue.hpp"
#include "cli/environment.hpp"
#include "cli/occlusion/names.hpp"
#include "cli/occlusion/settings.hpp"
#include "effect/methods.hpp"
#include "effect/settings.hpp"
#include "module/compile.hpp"
#include "scene/scene.hpp"
#include "subject/lab.hpp"

namespace gloam::cli {
namespace {

struct ListOptions {
    std::string kind;
    std::vector<std::string> names;  // empty: all
    bool json = false;
    bool markdown = false;
};

// The preset whose value is a setting's default: effect::default_preset, or `tssao-paper` for what that does
// not read.
effect::Preset default_preset_of(const effect::Setting& setting) {
    effect::Preset preset = effect::preset_named(effect::default_preset);
    return reads(preset.settings, setting) ? preset : effect::preset_named("tssao-paper");
}

// {"name", "description", "unit", "expected", "least", "most" or "choices", "default"}: the default is that
// of default_preset_of(), lengths for a radius of 1; "most" is null where there is none.
nlohmann::ordered_json setting_json(const Named& named) {
    const effect::Setting& setting = effect::setting_named(named.name);
    const effect::Preset preset = default_preset_of(setting);
    const effect::SettingValue value = setting.get(preset.settings);
    nlohmann::ordered_json json{{"name", setting.name},
                                {"description", setting.meaning},
                                {"unit", setting.unit},
                                {"expected", effect::expected_of(setting)}};
    if (!setting.choices.empty()) json["choices"] = setting.choices;
    if (std::holds_alternative<double>(value)) {
        json["least"] = setting.range.least;
        json["most"] = std::isfinite(setting.range.most) ? nlohmann::ordered_json(setting.range.most)
                                                         : nlohmann::ordered_json(nullptr);
    }
    json["default"] = json_of(value);
    json["default_of"] = preset.name;
    return json;
}

// describe: a member, or a function, that has the description of an item.
template <class Items, class Describe>
std::vector<Named> named(Items&& items, const Describe& describe) {
    std::vector<Named> names;
    for (const auto& item : items) names.push_back({item.name, std::invoke(describe, item)});
    return names;
}

std::vector<Named> equation_names() {
    std::vector<Named> names;
    for (const catalogue::Entry& entry : catalogue::all_entries(glsl_directory())) {
        const catalogue::Description& d = entry.description;
        names.push_back({d.id, d.function + ": " + d.title});
    }
    return names;
}

// With error and time.
std::vector<Named> preset_names() {
    return named(effect::presets(), [](const effect::Preset& preset) {
        return fmt::format("error {:.3f}, {:.2f} times the time of fast: {}", preset.error, preset.time,
                           preset.description);
    });
}

// With value, unit and range.
std::vector<Named> setting_names() {
    return named(effect::setting_table(), [](const effect::Setting& setting) {
        const effect::Preset preset = default_preset_of(setting);
        return fmt::format("{} ({}: {}{}{}; {})", setting.meaning, preset.name,
                           effect::text_of(setting.get(preset.settings)), setting.unit.empty() ? "" : " ",
                           setting.unit, expected_of(setting));
    });
}

std::vector<Named> scene_names() {
    return named(scene::all_views() |
                     std::views::filter([](const scene::ViewInfo& view) { return view.kind == "scene"; }),
                 &scene::ViewInfo::description);
}

// Of `gloam bench views`, with their halves.
std::vector<Named> view_names() {
    return named(scene::all_views() |
                     std::views::filter([](const scene::ViewInfo& view) { return !view.half.empty(); }),
                 [](const scene::ViewInfo& view) {
                     return fmt::format("{} ({} half; {})", view.description, view.half, view.kind);
                 });
}

nlohmann::ordered_json named_json(const Named& named) {
    return {{"name", named.name}, {"description", named.description}};
}

// The functions of the library's files; each file is compiled once.
class Declarations {
  public:
    // "float gloam_saturate(float x)": the function as its file declares it, with the names of its
    // parameters; a kernel of several functions is in no file, and has types alone.
    std::string of(const catalogue::Entry& entry) {
        const catalogue::Description& d = entry.description;
        const subject::Signature& signature = entry.question.signature;
        const auto [known, is_new] = files_.try_emplace(d.file);
        if (is_new)
            known->second =
                cache_.functions(subject::probe_of(d.file), {.include_roots = {glsl_directory()}});
        for (const module::Function& function : known->second) {
            const bool is_it = function.name == d.function && function.result == signature.result &&
                               std::ranges::equal(function.parameters, signature.parameters, {},
                                                  &module::Parameter::type, &module::Parameter::type);
            if (is_it) return module::to_glsl(function);
        }
        return subject::to_glsl(signature, d.function);
    }

  private:
    module::SpirvCache cache_ = subject::shader_cache({.cache_directory = cache_directory()});
    std::map<std::string, std::vector<module::Function>> files_;
};

nlohmann::ordered_json equation_json(const catalogue::Entry& entry, Declarations& declarations) {
    const catalogue::Description& d = entry.description;
    return {{"name", d.id},      {"description", d.title}, {"function", declarations.of(entry)},
            {"file", d.file},    {"formula", d.formula},   {"error", judge::to_text(entry.question.budget)},
            {"source", d.source}};
}

// As `--preset FILE.json` reads it: "settings" has all that runs, "origins" where each is from.
nlohmann::ordered_json preset_json(const Named& named) {
    const effect::Preset preset = effect::preset_named(named.name);
    nlohmann::ordered_json json{{"name", preset.name},
                                {"description", preset.description},
                                {"published", preset.published},
                                {"error", preset.error},
                                {"time", preset.time}};
    json["settings"] = json_of(preset.settings);
    for (const effect::Setting& setting : effect::setting_table())
        if (reads(preset.settings, setting))
            json["origins"][setting.name] = effect::origin_of(preset, setting.name);
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

nlohmann::ordered_json equations_json(const std::vector<std::string>& names) {
    auto json = nlohmann::ordered_json::array();
    Declarations declarations;
    const catalogue::Found found = found_named(names);
    for (const auto& [name, says] : names_of(found.rows))
        json.push_back({{"name", name}, {"description", says}});
    for (const catalogue::Entry& entry : found.entries) json.push_back(equation_json(entry, declarations));
    return json;
}

// What `gloam list` prints one name a line: its word on the command line.
struct ListedKind {
    std::string name;
    std::function<std::vector<Named>()> names;
    nlohmann::ordered_json (*one)(const Named& named) = named_json;  // all that is known of one
};

std::vector<ListedKind> all_kinds() {
    return {
        {"equations", equation_names},
        {"methods", [] { return named(effect::methods(), &effect::MethodInfo::description); }, method_json},
        {"numbers", [] { return names_of(catalogue::printed_rows()); }},
        {"presets", preset_names, preset_json},
        {"scenes", scene_names},
        {"settings", setting_names, setting_json},
        {"variants", [] { return named(module::variants(), &module::Variant::description); }},
        {"views", view_names}};
}

// These names of a kind, or all, with all their properties. Throws std::invalid_argument for a name that the
// kind does not have.
nlohmann::ordered_json kind_json(const ListedKind& kind, const std::vector<Named>& all,
                                 const std::vector<std::string>& names) {
    if (kind.name == "equations") return equations_json(names);
    auto json = nlohmann::ordered_json::array();
    for (const Named& named : all)
        if (names.empty()) json.push_back(kind.one(named));
    for (const std::string& name : names) {
        if (kind.name == "presets") (void)effect::preset_named(name);  // gives the new name of an old one
        const auto named = std::ranges::find(all, name, &Named::name);
        if (named == all.end())
            throw std::invalid_argument(
                fmt::format("{} \"{}\": expected {}", kind.name, name,
                            fmt::join(all | std::views::transform(&Named::name), ", ")));
        json.push_back(kind.one(*named));
    }
    return json;
}

// A property a line; of a preset each setting as `--set` takes it, and the method as `--method` does, with
// the symbol that its source has for it.
void print_one(const nlohmann::ordered_json& one) {
    for (const auto& [key, value] : one.items()) {
        if (!value.is_object()) fmt::print("{}: {}\n", key, text_of(value));
        if (key != "settings") continue;
        for (const auto& [setting, set] : value.items()) {
            const std::string origin = text_of(one.at("origins").at(setting));
            const std::string assignment = setting + "=" + text_of(set);
            if (origin.empty()) fmt::print("  {}\n", assignment);
            if (!origin.empty()) fmt::print("  {:<30} {}\n", assignment, origin);
        }
    }
}

// One name a line, and its meaning.
void print_names(const std::vector<Named>& names, const std::string& kind) {
    std::size_t width = 18;
    for (const Named& named : names) width = std::max(width, named.name.size());
    for (const Named& named : names)
        fmt::print("{}{:<{}} {}\n", kind.empty() ? "  " : "", named.name, width, named.description);
}

// One kind, or all of it that the names say; as text, or into the JSON. Of one name its properties are those
// of the whole document.
void list_kind(const ListedKind& kind, const ListOptions& options, nlohmann::ordered_json& json) {
    const bool named = !options.names.empty();
    const std::vector<Named> all = kind.names();
    if (!options.json && !named) return print_names(all, options.kind);
    nlohmann::ordered_json found = kind_json(kind, all, options.names);
    for (std::size_t i = 0; i < found.size() && !options.json; ++i) {
        if (i > 0) fmt::print("\n");
        print_one(found[i]);
    }
    if (named && found.size() == 1)
        json.update(found.front());
    else
        json[kind.name] = std::move(found);
}

// What is no kind may be a name of equations: `gloam list CS-3.1`.
ListOptions with_kind(ListOptions options) {
    const std::vector<ListedKind> kinds = all_kinds();
    if (options.kind == "numbers" && !options.names.empty()) options.kind = "equations";
    if (options.kind.empty() || std::ranges::count(kinds, options.kind, &ListedKind::name) > 0)
        return options;
    options.names.insert(options.names.begin(), options.kind);
    options.kind = "equations";
    try {
        (void)catalogue::find(catalogue::all_entries(glsl_directory()), {options.names.front()});
    } catch (const std::invalid_argument&) {
        throw std::invalid_argument(
            fmt::format("unknown kind \"{}\": expected {}, or a name of an equation", options.names.front(),
                        fmt::join(kinds | std::views::transform(&ListedKind::name), ", ")));
    }
    return options;
}

int run_list(const ListOptions& given) {
    const ListOptions options = with_kind(given);
    if (options.markdown) {
        if (options.kind != "numbers")
            throw std::invalid_argument("--markdown goes with `gloam list numbers`");
        fmt::print("{}", numbers_page());
        return 0;
    }
    nlohmann::ordered_json json{{"gloam", base::version()}};
    for (const ListedKind& kind : all_kinds()) {
        if (!options.kind.empty() && options.kind != kind.name) continue;
        if (options.kind.empty() && !options.json) fmt::print("{}\n", kind.name);
        list_kind(kind, options, json);
    }
    if (options.json) fmt::print("{}\n", json.dump(2));
    return 0;
}

}  // namespace

Command list_command() {
    static ListOptions options;
    return {
        .name = "list",
        .about = "the names that the other commands take",
        .options =
            {{"kind", &options.kind,
              "equations, methods, numbers (of equations in the papers), presets, scenes, settings, variants "
              "or views: a name a line and its meaning, of settings with default and range, of presets with "
              "error and time, gloam's own first; all when not given"},
             {"name", &options.names,
              "all that is known of these: of a preset every setting that runs and its source's symbol, of a "
              "method what it measures; an equation by ID, what papers call it, function, file or glob"},
             {"--json", &options.json, "names, descriptions and all other properties as JSON"},
             {"--markdown", &options.markdown, "numbers only: a page of them, a table for each paper"}},
        .run = [] { return run_list(options); },
        .examples =
            "  gloam list methods\n"
            "  gloam list settings --json\n"
            "  gloam list presets balanced          the settings that it changes\n"};
}

}  // namespace gloam::cli
