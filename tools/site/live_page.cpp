// SPDX-License-Identifier: MIT
#include <array>
#include <bit>
#include <cstdint>
#include <glm/packing.hpp>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/files.hpp"
#include "base/image_files.hpp"
#include "scene/scene.hpp"
#include "site/site.hpp"

namespace gloam::site {
namespace {

namespace fs = std::filesystem;

constexpr int frames = 240;  // of the camera's path
constexpr const char* scenes[]{"room", "columns", "knot"};

// Values one after another, compressed, as base64: gloam.values() reads it.
template <class T>
std::string packed(const std::vector<T>& values) {
    static_assert(std::endian::native == std::endian::little);
    return base::deflated_base64(
        {reinterpret_cast<const unsigned char*>(values.data()), values.size() * sizeof(T)});
}

// Position, normal and colour as bits: zeros of both signs stay what they are.
using Vertex = std::array<std::uint32_t, 7>;

Vertex vertex_of(const glm::vec3& position, const glm::vec3& normal, const glm::vec3& color) {
    const auto [x, y, z] = std::bit_cast<std::array<std::uint32_t, 3>>(position);
    const auto [u, v, w] = std::bit_cast<std::array<std::uint32_t, 3>>(normal);
    return {x, y, z, u, v, w, glm::packUnorm4x8(glm::vec4(color, 1.0F))};
}

// The triangles of a scene and its camera in each frame, as JSON (page/scene.js), with each vertex once.
std::string scene_json(const scene::Scene& scene) {
    const scene::Mesh& mesh = scene.mesh;
    std::map<Vertex, std::uint32_t> numbers;
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::uint32_t at = mesh.indices[i];
        const glm::vec3 color = mesh.colors.empty() ? scene::default_color : mesh.colors[i / 3];
        const Vertex vertex = vertex_of(mesh.positions[at], mesh.normals[at], color);
        const auto [known, is_new] = numbers.try_emplace(vertex, static_cast<std::uint32_t>(numbers.size()));
        if (is_new) vertices.push_back(vertex);
        indices.push_back(known->second);
    }
    std::vector<glm::dvec3> path;  // of each frame: the eye and what it looks at
    for (int frame = 0; frame < frames; ++frame) {
        const scene::Camera camera = scene::camera_at(scene, frame);
        path.insert(path.end(), {camera.eye, camera.target});
    }
    return nlohmann::ordered_json{{"vertices", packed(vertices)},
                                  {"indices", packed(indices)},
                                  {"name", scene.name},
                                  {"radius", scene.ao_radius},
                                  {"fovy", scene.camera.fovy_rad},
                                  {"near", scene.camera.near},
                                  {"far", scene.camera.far},
                                  {"frames", frames},
                                  {"path", packed(path)}}
        .dump();
}

// One script, because a page of file:// cannot import modules: the data, the classes of the npm package, and
// what the page does with them, all as members of the object `gloam`.
std::string live_script(const fs::path& library, const fs::path& files) {
    std::string text = "\"use strict\";\nconst gloam = globalThis.gloam = {};\ngloam.effect = " +
                       effect_json(library, files) + ";\ngloam.shaders = " + picture_json(library, files) +
                       ";\ngloam.sceneNames = " + nlohmann::json(scenes).dump() +
                       ";\nObject.assign(gloam, (() => {\n" + effect_classes(files) +
                       "return {AmbientOcclusion, Passes};\n})());\n";
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
                     "gloam.addScene(" + scene_json(scene::make_scene(name)) + ");\n");
}

}  // namespace gloam::site
