// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <tuple>

#include "site/page_data.hpp"

namespace gloam::site {

namespace {

using nlohmann::ordered_json;

// Values without repetition, in the order of their first use.
template <class T>
class Numbered {
  public:
    std::uint16_t number_of(const T& value) {
        const auto [at, is_new] = known_.try_emplace(value, values_.size());
        if (is_new) values_.push_back(value);
        if (values_.size() > std::size_t{1} << 16U)
            throw std::runtime_error("a scene of the site has more than 65536 different values of one kind");
        return static_cast<std::uint16_t>(at->second);
    }
    [[nodiscard]] const std::vector<T>& values() const { return values_; }

  private:
    std::map<T, std::size_t> known_;
    std::vector<T> values_;
};

using Triple = std::tuple<std::uint16_t, std::uint16_t, std::uint16_t>;
using Color = std::tuple<std::uint8_t, std::uint8_t, std::uint8_t>;

// A mesh in which floats, points, directions and colours stand once: a third of the size, and the same to the
// bit.
class CompactMesh {
  public:
    explicit CompactMesh(const scene::Mesh& mesh) : mesh_(mesh) {
        for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
            const std::uint32_t at = mesh.indices[i];
            indices_.add(vertices_.number_of({points_.number_of(triple(mesh.positions[at])),
                                              directions_.number_of(triple(mesh.normals[at])),
                                              colors_.number_of(color_of(i / 3))}));
        }
    }

    [[nodiscard]] ordered_json json() const {
        Bytes floats;
        for (const std::uint32_t bits : floats_.values()) floats.add(bits);
        Bytes colors;
        for (const auto& [red, green, blue] : colors_.values()) add(colors, {red, green, blue});
        return {{"floats", floats.text()},
                {"points", triples_text(points_.values())},
                {"directions", triples_text(directions_.values())},
                {"palette", colors.text()},
                {"vertices", triples_text(vertices_.values())},
                {"indices", indices_.text()}};
    }

  private:
    [[nodiscard]] Color color_of(std::size_t triangle) const {
        const glm::vec3 color = mesh_.colors.empty() ? scene::default_color : mesh_.colors[triangle];
        const auto byte = [](float x) {
            return static_cast<std::uint8_t>(std::lround(std::clamp(x, 0.0F, 1.0F) * 255.0F));
        };
        return {byte(color.x), byte(color.y), byte(color.z)};
    }

    Triple triple(const glm::vec3& v) {
        const auto number = [this](float x) { return floats_.number_of(std::bit_cast<std::uint32_t>(x)); };
        return {number(v.x), number(v.y), number(v.z)};
    }

    template <class T>
    static void add(Bytes& bytes, std::initializer_list<T> values) {
        for (const T value : values) bytes.add(value);
    }

    static std::string triples_text(const std::vector<Triple>& triples) {
        Bytes bytes;
        for (const auto& [a, b, c] : triples) add(bytes, {a, b, c});
        return bytes.text();
    }

    const scene::Mesh& mesh_;
    Numbered<std::uint32_t> floats_;  // as bits: zeros of both signs and NaN stay what they are
    Numbered<Triple> points_;
    Numbered<Triple> directions_;
    Numbered<Color> colors_;
    Numbered<Triple> vertices_;  // of a point, a direction and a colour
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
    ordered_json json = CompactMesh(scene.mesh).json();
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
