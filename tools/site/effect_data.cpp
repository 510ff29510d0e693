// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>
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

// Its depth is read by the loops of all methods; other methods read images that further passes prepare.
bool runs_in_one_pass(const effect::MethodInfo& method) {
    return method.prepare == nullptr;
}

// gloam's own presets: other filters than theirs do not run in a browser.
bool runs_live(const effect::Preset& preset) {
    return !preset.published && preset.settings.history &&
           preset.settings.filter == effect::Filter::convergence;
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

// What every user of the class needs, but for the methods.
ordered_json core_json(const ShaderFolders& folders) {
    ordered_json json = ordered_json::object();
    for (const std::string name :
         {"take_inputs", "normals_from_depth", "halve_inputs", "reproject", "spatial_filter", "upsample"})
        json[name] = packed_file(name + ".frag", Stage::fragment, folders);
    json["preset"] = effect::default_preset;
    for (const effect::Preset& preset : effect::presets())
        if (runs_live(preset))
            json["presets"].push_back({{"name", preset.name},
                                       {"description", preset.description},
                                       {"method", preset.settings.method}});
    for (const effect::Setting& setting : effect::setting_table())
        if (setting.unit == "world units") json["lengths"].push_back(setting.name);
    return json;
}

std::string text_of(const ordered_json& json) {
    return json.dump(-1, ' ', true);
}

}  // namespace

std::string effect_json(const ShaderFolders& folders) {
    ordered_json json = core_json(folders);
    json["gbuffer_vertices"] = packed_file("gbuffer.vert", Stage::vertex, folders);
    for (const std::string name : {"gbuffer", "show"})
        json[name] = packed_file(name + ".frag", Stage::fragment, folders);
    for (const effect::MethodInfo& method : effect::methods())
        if (runs_in_one_pass(method)) json["methods"].push_back(method_json(method, folders));
    return text_of(json);
}

EffectParts effect_parts(const ShaderFolders& folders) {
    ordered_json core = core_json(folders);
    EffectParts parts;
    for (const effect::MethodInfo& method : effect::methods()) {
        if (!runs_in_one_pass(method)) continue;
        ordered_json json = method_json(method, folders);
        const auto uses = [&method](const ordered_json& preset) { return preset["method"] == method.name; };
        parts.methods[method.name] = text_of(json);
        if (std::ranges::any_of(core["presets"], uses)) core["methods"].push_back(std::move(json));
    }
    parts.core = text_of(core);
    return parts;
}

std::string effect_classes(const std::filesystem::path& folder) {
    std::string text;
    for (const char* name : {"passes.js", "views.js", "ambient-occlusion.js"})
        text += base::read_file(folder / name);
    return text;
}

namespace {

// Vertices with a colour each, where a mesh has one for each triangle.
class Vertices {
  public:
    explicit Vertices(const scene::Mesh& mesh) : mesh_(mesh) {
        for (std::size_t i = 0; i < mesh.indices.size(); ++i) add(mesh.indices[i], color_of(i / 3));
    }
    [[nodiscard]] ordered_json json() const {
        return {{"vertices", known_.size()},      {"triangles", mesh_.triangle_count()},
                {"positions", positions_.text()}, {"normals", normals_.text()},
                {"colors", colors_.text()},       {"indices", indices_.text()}};
    }

  private:
    using Color = std::tuple<std::uint8_t, std::uint8_t, std::uint8_t>;

    [[nodiscard]] Color color_of(std::size_t triangle) const {
        const glm::vec3 color = mesh_.colors.empty() ? scene::default_color : mesh_.colors[triangle];
        const auto byte = [](float x) {
            return static_cast<std::uint8_t>(std::lround(std::clamp(x, 0.0F, 1.0F) * 255.0F));
        };
        return {byte(color.x), byte(color.y), byte(color.z)};
    }

    void add(std::uint32_t index, const Color& color) {
        const auto next = static_cast<std::uint32_t>(known_.size());
        const auto [at, is_new] = known_.try_emplace({index, color}, next);
        indices_.add(at->second);
        if (!is_new) return;
        for (int k = 0; k < 3; ++k) positions_.add(mesh_.positions[index][k]);
        for (int k = 0; k < 3; ++k) normals_.add(mesh_.normals[index][k]);
        for (const std::uint8_t byte :
             {std::get<0>(color), std::get<1>(color), std::get<2>(color), std::uint8_t{255}})
            colors_.add(byte);
    }

    const scene::Mesh& mesh_;
    std::map<std::pair<std::uint32_t, Color>, std::uint32_t> known_;
    Bytes positions_;
    Bytes normals_;
    Bytes colors_;
    Bytes indices_;
};

}  // namespace

std::string scene_json(const scene::Scene& scene, int frames) {
    Bytes cameras;  // of each frame: the rotation of world to view by rows, the eye; doubles
    for (int frame = 0; frame < frames; ++frame) {
        const scene::Camera camera = scene::camera_at(scene, frame);
        const glm::dmat3 rotation = scene::view_rotation(camera);
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column) cameras.add(rotation[column][row]);
        for (int k = 0; k < 3; ++k) cameras.add(camera.eye[k]);
    }
    ordered_json json = Vertices(scene.mesh).json();
    json["name"] = scene.name;
    json["radius"] = scene.ao_radius;
    json["fovy"] = scene.camera.fovy_rad;
    json["near"] = scene.camera.near;
    json["far"] = scene.camera.far;
    json["frames"] = frames;
    json["cameras"] = cameras.text();
    return json.dump();
}

}  // namespace gloam::site
