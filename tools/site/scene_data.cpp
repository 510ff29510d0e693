// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "site/bytes.hpp"
#include "site/effect_data.hpp"

namespace gloam::site {
namespace {

using nlohmann::ordered_json;

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
