// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
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

// Numbers that were given in the order of first use, each as its distance below the next new one: 7 bits a
// byte, the lowest first, with the high bit where more follow. Most are small.
class Stream {
  public:
    void add(std::uint16_t number) {
        auto distance = static_cast<std::uint32_t>(next_ - number);
        next_ = std::max(next_, std::uint32_t{number} + 1U);
        for (; distance > 127U; distance >>= 7U) bytes_.add(static_cast<std::uint8_t>(distance | 128U));
        bytes_.add(static_cast<std::uint8_t>(distance));
    }
    [[nodiscard]] std::string text() const { return bytes_.text(); }

  private:
    Bytes bytes_;
    std::uint32_t next_ = 0;
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
                {"points", streams_of(points_.values())},
                {"directions", streams_of(directions_.values())},
                {"palette", colors.text()},
                {"vertices", streams_of(vertices_.values())},
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

    // The first, the second and the third numbers.
    static ordered_json streams_of(const std::vector<Triple>& triples) {
        std::array<Stream, 3> streams;
        for (const auto& [a, b, c] : triples) {
            streams[0].add(a);
            streams[1].add(b);
            streams[2].add(c);
        }
        return {streams[0].text(), streams[1].text(), streams[2].text()};
    }

    const scene::Mesh& mesh_;
    Numbered<std::uint32_t> floats_;  // as bits: zeros of both signs and NaN stay what they are
    Numbered<Triple> points_;
    Numbered<Triple> directions_;
    Numbered<Color> colors_;
    Numbered<Triple> vertices_;  // of a point, a direction and a colour
    Stream indices_;
};

}  // namespace

std::string scene_json(const scene::Scene& scene, int frames) {
    Bytes cameras;  // of each frame: the eye and what it looks at; doubles
    for (int frame = 0; frame < frames; ++frame) {
        const scene::Camera camera = scene::camera_at(scene, frame);
        if (camera.up != glm::dvec3(0, 1, 0))
            throw std::runtime_error("the camera of the scene " + scene.name + " does not keep y upright");
        for (const glm::dvec3& point : {camera.eye, camera.target})
            for (int k = 0; k < 3; ++k) cameras.add(point[k]);
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
