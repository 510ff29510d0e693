// SPDX-License-Identifier: MIT
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <variant>

#include "base/files.hpp"
#include "effect/methods.hpp"
#include "effect/settings.hpp"
#include "shader/pack.hpp"
#include "site/page_data.hpp"

namespace gloam::site {

namespace {

using nlohmann::ordered_json;
using shader::Stage;

// gloam's own presets: other filters than theirs do not run in a browser.
bool runs_live(const effect::Preset& preset) {
    return !preset.published && preset.settings.history &&
           preset.settings.filter == effect::Filter::convergence;
}

// A pass as one text in GLSL ES 3.00: it has loose uniforms, as OpenGL ES has them, and the specialization
// constants of Vulkan.
std::string pass_text(const std::string& name, const std::string& text, const ShaderFolders& folders) {
    const Stage stage = name.ends_with(".vert") ? Stage::vertex : Stage::fragment;
    return condensed(shader::pack({shader::Source{.name = name, .text = text}},
                                  {.language = shader::Language::es300, .stage = stage}, {folders.library}));
}

std::string file_text(const std::string& file, const ShaderFolders& folders) {
    return pass_text(file, base::read_file(folders.page / file), folders);
}

std::string occlusion_text(const effect::MethodInfo& method, const ShaderFolders& folders) {
    return pass_text("occlusion by " + method.name,
                     "#include \"" + file_of(method) + "\"\n" +
                         "#define METHOD(position, normal, camera, kernel, values) " + call_of(method) +
                         "\n" + base::read_file(folders.page / "occlusion.frag"),
                     folders);
}

// Adds passes by their names.
void add_passes(const std::vector<std::string>& files, const ShaderFolders& folders, ordered_json& json) {
    for (const std::string& file : files) json[file.substr(0, file.find('.'))] = file_text(file, folders);
}

ordered_json value_json(const effect::SettingValue& value) {
    if (const auto* number = std::get_if<double>(&value))
        return std::isfinite(*number) ? ordered_json(*number) : ordered_json(nullptr);  // null: infinite
    if (const auto* flag = std::get_if<bool>(&value)) return *flag;
    return std::get<std::string>(value);
}

// All settings by name, for a radius of 1, and what follows from the method.
ordered_json settings_json(const effect::Settings& settings) {
    const effect::MethodInfo& method = effect::method_named(settings.method);
    ordered_json json = ordered_json::object();
    for (const effect::Setting& setting : effect::setting_table())
        json[setting.name] = value_json(setting.get(settings));
    json["samples_unit"] = effect::unit_of(method, settings.own.steps);
    json["rounds_up"] = method.unit == effect::SampleUnit::pair;
    return json;
}

// A function of the library with what it uses, as a text that another shader can contain: without its head.
std::string function_text(const std::string& file, const std::string& function,
                          const ShaderFolders& folders) {
    const shader::PackRequest request{
        .language = shader::Language::es300, .functions = {function}, .stage = Stage::fragment};
    std::istringstream lines(condensed(shader::pack({folders.library / file}, request, {folders.library})));
    std::string text;
    for (std::string line; std::getline(lines, line);)
        if (!line.starts_with("#version") && !line.starts_with("precision ")) text += line + "\n";
    return text;
}

std::string text_of(const ordered_json& json) {
    return json.dump(-1, ' ', true);
}

}  // namespace

std::string effect_json(const ShaderFolders& folders) {
    ordered_json json{{"preset", effect::default_preset}};
    std::set<std::string> methods;
    for (const effect::Preset& preset : effect::presets()) {
        if (!runs_live(preset)) continue;
        methods.insert(preset.settings.method);
        json["presets"].push_back({{"name", preset.name},
                                   {"description", preset.description},
                                   {"method", preset.settings.method},
                                   {"settings", settings_json(preset.settings)}});
    }
    for (const effect::Setting& setting : effect::setting_table())
        if (setting.unit == "world units") json["lengths"].push_back(setting.name);
    add_passes({"whole_image.vert", "take_inputs.frag", "normals_from_depth.frag", "halve_inputs.frag",
                "reproject.frag", "spatial_filter.frag", "upsample.frag"},
               folders, json);
    json["multi_bounce"] = function_text("gloam/shading/multi_bounce.glsl", "gloam_multi_bounce", folders);
    for (const std::string& name : methods) {
        const effect::MethodInfo& method = effect::method_named(name);
        json["methods"].push_back(
            {{"name", name}, {"description", method.description}, {"text", occlusion_text(method, folders)}});
    }
    return text_of(json);
}

std::string picture_json(const ShaderFolders& folders) {
    ordered_json json{{"gbuffer_vertices", file_text("gbuffer.vert", folders)}};
    add_passes({"gbuffer.frag", "show.frag"}, folders, json);
    return text_of(json);
}

std::string effect_classes(const std::filesystem::path& folder) {
    std::string text;
    for (const char* name : {"passes.js", "views.js", "ambient-occlusion.js"})
        text += base::read_file(folder / name);
    return text;
}

}  // namespace gloam::site
