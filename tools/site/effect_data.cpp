// SPDX-License-Identifier: MIT
#include "site/effect_data.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <variant>

#include "base/files.hpp"
#include "effect/methods.hpp"
#include "effect/settings.hpp"
#include "shader/pack.hpp"
#include "site/shader_text.hpp"

namespace gloam::site {
namespace {

using nlohmann::ordered_json;
using shader::Stage;

// Its depth is read by the loops of all methods; other methods read images that further passes prepare.
bool runs_in_one_pass(const effect::MethodInfo& method) {
    return method.prepare == nullptr;
}

// The general presets that need no filter once a pixel has some samples: the page has none.
bool runs_live(const effect::Preset& preset) {
    return preset.settings.history && preset.settings.precision == effect::HistoryPrecision::packed &&
           preset.name.find('-') == std::string::npos;
}

std::string packed(const std::string& name, const std::string& text, Stage stage,
                   const ShaderFolders& folders) {
    return condensed(shader::pack({shader::Source{.name = name, .text = text}},
                                  {.language = shader::Language::es300, .stage = stage}, {folders.library}));
}

std::string packed_file(const std::string& name, Stage stage, const ShaderFolders& folders) {
    return packed(name, base::read_file(folders.page / name), stage, folders);
}

std::string occlusion_text(const effect::MethodInfo& method, const ShaderFolders& folders) {
    const std::string text = "#include \"" + file_of(method) + "\"\n" +
                             "#define METHOD(position, normal, camera, kernel, values) " + call_of(method) +
                             "\n" + base::read_file(folders.page / "occlusion.frag");
    return packed("occlusion by " + method.name, text, Stage::fragment, folders);
}

ordered_json value_json(const effect::SettingValue& value) {
    if (const auto* number = std::get_if<double>(&value))
        return std::isfinite(*number) ? ordered_json(*number) : ordered_json(nullptr);  // null: infinite
    if (const auto* flag = std::get_if<bool>(&value)) return *flag;
    return std::get<std::string>(value);
}

// All settings by name, and what follows from the method.
ordered_json settings_json(const effect::Settings& settings, const effect::MethodInfo& method) {
    ordered_json json = ordered_json::object();
    for (const effect::Setting& setting : effect::setting_table())
        json[setting.name] = value_json(setting.get(settings));
    json["samples_unit"] = effect::unit_of(method, settings.own.steps);
    json["rounds_up"] = method.unit == effect::SampleUnit::pair;
    return json;
}

ordered_json method_json(const effect::MethodInfo& method, const ShaderFolders& folders) {
    ordered_json settings = ordered_json::object();
    for (const effect::Preset& preset : effect::presets()) {
        if (!runs_live(preset)) continue;
        const effect::Settings own = preset.settings.method == method.name
                                         ? preset.settings
                                         : effect::with_method(preset.settings, method.name);
        settings[preset.name] = settings_json(own, method);
    }
    return {{"name", method.name},
            {"description", method.description},
            {"text", occlusion_text(method, folders)},
            {"settings", std::move(settings)}};
}

}  // namespace

std::string effect_json(const ShaderFolders& folders) {
    ordered_json json{{"gbuffer_vertices", packed_file("gbuffer.vert", Stage::vertex, folders)},
                      {"gbuffer", packed_file("gbuffer.frag", Stage::fragment, folders)},
                      {"reproject", packed_file("reproject.frag", Stage::fragment, folders)},
                      {"show", packed_file("show.frag", Stage::fragment, folders)}};
    for (const effect::Preset& preset : effect::presets())
        if (runs_live(preset))
            json["presets"].push_back({{"name", preset.name},
                                       {"description", preset.description},
                                       {"method", preset.settings.method}});
    for (const effect::Setting& setting : effect::setting_table())
        if (setting.unit == "world units") json["lengths"].push_back(setting.name);
    for (const effect::MethodInfo& method : effect::methods())
        if (runs_in_one_pass(method)) json["methods"].push_back(method_json(method, folders));
    return json.dump(-1, ' ', true);
}

}  // namespace gloam::site
