// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "base/image_files.hpp"
#include "site/page_data.hpp"

namespace gloam::site {

namespace {

using nlohmann::ordered_json;

// Little-endian bytes of values one after another, which the pages read.
class Bytes {
  public:
    template <class T>
    void add(T value) {
        static_assert(std::endian::native == std::endian::little);
        const auto bytes = std::bit_cast<std::array<unsigned char, sizeof(T)>>(value);
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    }
    // Compressed, as base64: gloam.values() reads it.
    [[nodiscard]] std::string text() const { return base::deflated_base64(bytes_); }

  private:
    std::vector<unsigned char> bytes_;
};

// Position, normal and colour as bits: zeros of both signs stay what they are.
using Vertex = std::array<std::uint32_t, 7>;

std::uint32_t color_bits(const glm::vec3& color) {
    const auto byte = [](float x) {
        return static_cast<std::uint32_t>(std::lround(std::clamp(x, 0.0F, 1.0F) * 255.0F));
    };
    return byte(color.x) | byte(color.y) << 8U | byte(color.z) << 16U | 0xff000000U;
}

Vertex vertex_of(const glm::vec3& position, const glm::vec3& normal, const glm::vec3& color) {
    const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x); };
    return {bits(position.x), bits(position.y), bits(position.z), bits(normal.x),
            bits(normal.y),   bits(normal.z),   color_bits(color)};
}

// Each vertex once, in the order of first use, and the indices of the triangles.
ordered_json mesh_json(const scene::Mesh& mesh) {
    std::map<Vertex, std::uint32_t> numbers;
    Bytes vertices;
    Bytes indices;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::uint32_t at = mesh.indices[i];
        const glm::vec3 color = mesh.colors.empty() ? scene::default_color : mesh.colors[i / 3];
        const Vertex vertex = vertex_of(mesh.positions[at], mesh.normals[at], color);
        const auto [known, is_new] = numbers.try_emplace(vertex, static_cast<std::uint32_t>(numbers.size()));
        if (is_new)
            for (const std::uint32_t word : vertex) vertices.add(word);
        indices.add(known->second);
    }
    return {{"vertices", vertices.text()}, {"indices", indices.text()}};
}

}  // namespace

std::string scene_json(const scene::Scene& scene, int frames) {
    Bytes path;  // of each frame: the eye and what it looks at; doubles
    for (int frame = 0; frame < frames; ++frame) {
        const scene::Camera camera = scene::camera_at(scene, frame);
        if (camera.up != glm::dvec3(0, 1, 0))
            throw std::runtime_error("the camera of the scene " + scene.name + " does not keep y upright");
        for (const glm::dvec3& point : {camera.eye, camera.target})
            for (int k = 0; k < 3; ++k) path.add(point[k]);
    }
    ordered_json json = mesh_json(scene.mesh);
    json["name"] = scene.name;
    json["radius"] = scene.ao_radius;
    json["fovy"] = scene.camera.fovy_rad;
    json["near"] = scene.camera.near;
    json["far"] = scene.camera.far;
    json["frames"] = frames;
    json["path"] = path.text();
    return json.dump();
}

}  // namespace gloam::site
