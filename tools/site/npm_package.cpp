// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/files.hpp"
#include "base/version.hpp"
#include "effect/methods.hpp"
#include "module/texts.hpp"
#include "scene/pass_library.hpp"
#include "site/site.hpp"

namespace gloam::site {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

// A pass as one text in GLSL ES 3.00, with its loose uniforms and the specialization constants of Vulkan.
std::string file_text(const fs::path& file, const fs::path& library) {
    const source::PackRequest request{.language = source::Language::es300,
                                      .stage = source::stage_of_file(file)};
    return source::code_of(module::pack({file}, request, {library}));
}

// A function of the library with what it uses, as a text that another shader can contain: without its head.
std::string function_text(const std::string& file, const std::string& function, const fs::path& library) {
    const source::PackRequest request{.language = source::Language::es300, .functions = {function}};
    std::istringstream lines(source::code_of(module::pack({library / file}, request, {library})));
    std::string text;
    for (std::string line; std::getline(lines, line);)
        if (!line.starts_with("#version") && !line.starts_with("precision ")) text += line + "\n";
    return text;
}

std::string text_of(const ordered_json& json) {
    return json.dump(-1, ' ', true);
}

}  // namespace

std::string effect_json(const fs::path& library, const fs::path& files) {
    ordered_json json{{"preset", effect::default_preset}};
    for (const effect::Preset& preset : effect::presets()) {
        const effect::Settings& settings = preset.settings;
        if (preset.published) continue;
        json["presets"].push_back(
            {{"name", preset.name},
             {"description", preset.description},
             {"slices", slices_of(settings)},
             {"steps", settings.own.steps},
             {"resolution", effect::text_of(effect::setting_named("resolution").get(settings))},
             {"mark", settings.mark},
             {"range", settings.history_range},
             {"sharpness", settings.history_sharpness}});
    }
    json["steps_before_tiles"] = effect::steps_before_tiles;
    json["whole_image"] = file_text(files / "shaders/whole_image.vert", library);
    struct Pass {
        const char* name;
        const char* file;
        std::vector<std::string> defines;
    };
    const scene::PassLibrary passes(library);
    for (const auto& [name, file, defines] :
         {Pass{"tiles", "frame/tiles.vert"},
          {"prepare", "frame/prepare.frag"},
          {"sweep", "frame/sweep.frag"},
          {"mark", "frame/mark.frag"},
          {"halve", "frame/halve.frag"},
          {"filter", "frame/filter.frag"},
          {"join", "frame/join.frag"},
          {"sweep_from_depth", "frame/sweep.frag", {"GLOAM_NORMALS_FROM_DEPTH"}},
          {"refine", "frame/sweep.frag", {"GLOAM_MARKS"}},
          {"refine_from_depth", "frame/sweep.frag", {"GLOAM_MARKS", "GLOAM_NORMALS_FROM_DEPTH"}},
          {"filter_of_tiles", "frame/filter.frag", {"GLOAM_MARKS"}},
          {"join_of_tiles", "frame/join.frag", {"GLOAM_MARKS"}}})
        json[name] = source::code_of(passes.text(file, defines, {}, {}, source::Language::es300));
    json["multi_bounce"] = function_text("gloam/shading/ambient.glsl", "gloam_multi_bounce", library);
    return text_of(json);
}

std::string picture_json(const fs::path& library, const fs::path& files) {
    const auto text = [&](const char* name) { return file_text(files / "shaders" / name, library); };
    return text_of({{"gbuffer_vertices", text("gbuffer.vert")},
                    {"gbuffer", text("gbuffer.frag")},
                    {"show", text("show.frag")}});
}

std::string effect_classes(const fs::path& files) {
    std::string text;
    for (const char* name : {"passes.js", "camera.js", "ambient-occlusion.js"})
        text += base::read_file(files / "effect" / name);
    return text;
}

std::map<std::string, std::string> npm_package(const fs::path& library, const fs::path& files,
                                               const fs::path& licence) {
    // The class, and the data that it needs, as a module.
    const std::string index =
        "// SPDX-License-Identifier: MIT\nexport const effect = " + effect_json(library, files) + ";\n" +
        effect_classes(files) + "export {AmbientOcclusion};\n";
    std::map<std::string, std::string> all{{"index.js", index}, {"LICENSE", base::read_file(licence)}};
    for (const auto& file : fs::directory_iterator(files / "npm"))
        all[file.path().filename().string()] = base::read_file(file.path());
    auto package = nlohmann::ordered_json::parse(all.at("package.json"));
    package["version"] = base::version();
    all["package.json"] = package.dump(2) + "\n";
    return all;
}

}  // namespace gloam::site
