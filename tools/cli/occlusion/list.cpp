// SPDX-License-Identifier: MIT
#include "cli/commands.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
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

// The preset with a setting's default value: default_preset, or `tssao-paper` for what that does not read.
effect::Preset default_preset_of(const effect::Setting& setting) {
    effect::Preset preset = effect::preset_named(effect::default_preset);
    return reads(preset.settings, setting) ? preset : effect::preset_named("tssao-paper");
}

// What there is to say of a name: in a line, and all its properties.
struct Listed {
    std::string name;
    std::string line;
    nlohmann::ordered_json json;
};

Listed listed(const std::string& name, const std::string& description) {
    return {name, description, {{"name", name}, {"description", description}}};
}

// The line has value, unit and range. The properties are "name", "description", "unit", "expected", "least",
// "most" or "choices", "default": the default is that of default_preset_of(), lengths for a radius of 1;
// "most" is null where there is none.
Listed listed_setting(const effect::Setting& setting) {
    const effect::Preset preset = default_preset_of(setting);
    const effect::SettingValue value = setting.get(preset.settings);
    Listed one = listed(setting.name, setting.meaning);
    one.line = fmt::format("{} ({}: {}{}{}; {})", setting.meaning, preset.name, effect::text_of(value),
                           setting.unit.empty() ? "" : " ", setting.unit, expected_of(setting));
    one.json["unit"] = setting.unit;
    one.json["expected"] = expected_of(setting);
    if (!setting.choices.empty()) one.json["choices"] = setting.choices;
    if (std::holds_alternative<double>(value)) {
        one.json["least"] = setting.range.least;
        one.json["most"] = std::isfinite(setting.range.most) ? nlohmann::ordered_json(setting.range.most)
                                                             : nlohmann::ordered_json(nullptr);
    }
    one.json["default"] = json_of(value);
    one.json["default_of"] = preset.name;
    return one;
}

// The line has error and time. The properties are as `--preset FILE.json` reads them: "settings" has all that
// runs, "origins" where each is from.
Listed listed_preset(const effect::Preset& preset) {
    Listed one = listed(preset.name, preset.description);
    one.line = fmt::format("error {:.3f}, {:.2f} times the time of fast: {}", preset.error, preset.time,
                           preset.description);
    one.json.update({{"published", preset.published},
                     {"error", preset.error},
                     {"time", preset.time},
                     {"settings", json_of(preset.settings)}});
    for (const effect::Setting& setting : effect::setting_table())
        if (reads(preset.settings, setting))
            one.json["origins"][setting.name] = effect::origin_of(preset, setting.name);
    return one;
}

Listed listed_method(const effect::MethodInfo& method) {
    Listed one = listed(method.name, method.description);
    one.json.update({{"measure", to_string(method.measure)},
                     {"falloff", method.falloff},
                     {"samples", with_method(effect::Settings{}, method.name).samples},
                     {"file", file_of(method)}});
    return one;
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
    std::function<std::vector<Listed>()> all;
};

template <class Items, class One>
std::vector<Listed> each_of(Items&& items, const One& one) {
    std::vector<Listed> all;
    for (const auto& item : items) all.push_back(one(item));
    return all;
}

constexpr auto described = [](const auto& item) { return listed(item.name, item.description); };

Listed listed_equation(const catalogue::Entry& entry) {
    const catalogue::Description& d = entry.description;
    return listed(d.id, d.function + ": " + d.title);
}

Listed listed_view(const scene::ViewInfo& view) {
    return listed(view.name, fmt::format("{} ({} half; {})", view.description, view.half, view.kind));
}

constexpr auto is_scene = [](const scene::ViewInfo& view) { return view.kind == "scene"; };
constexpr auto has_half = [](const scene::ViewInfo& view) { return !view.half.empty(); };

std::vector<ListedKind> all_kinds() {
    using std::views::filter;
    return {{"equations", [] { return each_of(catalogue::all_entries(glsl_directory()), listed_equation); }},
            {"methods", [] { return each_of(effect::methods(), listed_method); }},
            {"numbers", [] { return each_of(names_of(catalogue::printed_rows()), described); }},
            {"presets", [] { return each_of(effect::presets(), listed_preset); }},
            {"scenes", [] { return each_of(scene::all_views() | filter(is_scene), described); }},
            {"settings", [] { return each_of(effect::setting_table(), listed_setting); }},
            {"variants", [] { return each_of(module::variants(), described); }},
            {"views", [] { return each_of(scene::all_views() | filter(has_half), listed_view); }}};
}

// The properties of these names of a kind, or of all. Throws std::invalid_argument for a name that is none.
nlohmann::ordered_json kind_json(const std::string& kind, const std::vector<Listed>& all,
                                 const std::vector<std::string>& names) {
    if (kind == "equations") return equations_json(names);
    auto json = nlohmann::ordered_json::array();
    for (const Listed& one : all)
        if (names.empty()) json.push_back(one.json);
    for (const std::string& name : names) {
        if (kind == "presets") (void)effect::preset_named(name);  // gives the new name of an old one
        const auto named = std::ranges::find(all, name, &Listed::name);
        if (named == all.end())
            throw std::invalid_argument(
                fmt::format("{} \"{}\": expected {}", kind, name,
                            fmt::join(all | std::views::transform(&Listed::name), ", ")));
        json.push_back(named->json);
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
void print_names(const std::vector<Listed>& all, const std::string& kind) {
    std::size_t width = 18;
    for (const Listed& one : all) width = std::max(width, one.name.size());
    for (const Listed& one : all)
        fmt::print("{}{:<{}} {}\n", kind.empty() ? "  " : "", one.name, width, one.line);
}

// One kind, or what the names say of it, as text or into the JSON, which has the properties of a single name.
void list_kind(const ListedKind& kind, const ListOptions& options, nlohmann::ordered_json& json) {
    const bool named = !options.names.empty();
    const std::vector<Listed> all = kind.all();
    if (!options.json && !named) return print_names(all, options.kind);
    nlohmann::ordered_json found = kind_json(kind.name, all, options.names);
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
