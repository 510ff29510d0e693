// SPDX-License-Identifier: MIT
#include "site/live_page.hpp"

#include <nlohmann/json.hpp>
#include <string>

#include "base/files.hpp"
#include "scene/scene.hpp"
#include "site/page_data.hpp"

namespace gloam::site {
namespace {

namespace fs = std::filesystem;

constexpr int frames = 240;  // of the camera's path
constexpr const char* scenes[]{"room", "columns", "knot"};

// One script, because a page of file:// cannot import modules: the data, the classes of the npm package, and
// what the page does with them, all as members of the object `gloam`.
std::string live_script(const fs::path& library, const fs::path& files) {
    const ShaderFolders folders{library, files / "shaders"};
    std::string text =
        "\"use strict\";\nconst gloam = globalThis.gloam = {};\ngloam.effect = " + effect_json(folders) +
        ";\ngloam.shaders = " + picture_json(folders) +
        ";\ngloam.sceneNames = " + nlohmann::json(scenes).dump() + ";\nObject.assign(gloam, (() => {\n" +
        effect_classes(files / "effect") + "return {AmbientOcclusion, Passes};\n})());\n";
    for (const char* part : {"scene.js", "picture.js", "orbit.js", "live.js"})
        text += base::read_file(files / "page" / part);
    return text;
}

}  // namespace

void add_live_effect(record::Page& page, record::OutputFolder& folder, const fs::path& library,
                     const fs::path& files) {
    page.markup(base::read_file(files / "page/live.html"));
    page.script("live.js");
    folder.write("live.js", live_script(library, files));
    // The page loads a scene when it is chosen.
    for (const std::string name : scenes)
        folder.write("scene-" + name + ".js",
                     "gloam.addScene(" + scene_json(scene::make_scene(name), frames) + ");\n");
}

}  // namespace gloam::site
