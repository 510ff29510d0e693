// SPDX-License-Identifier: MIT
#include "scene/encoding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>

namespace gloam::scene {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool is_depth(double depth) {
    return depth > 0.0 && std::isfinite(depth);
}

// Whether the far plane has depth-buffer value 0.
bool reversed(const CameraFrame& camera) {
    return camera.proj_vk[2][2] > (camera.orthographic() ? 0.0F : -0.5F);
}

glm::dmat3 view_from_world(const CameraFrame& camera) {
    return glm::dmat3(glm::mat3(camera.view));
}

glm::dvec2 folded(const glm::dvec2& v) {
    return {(1.0 - std::abs(v.y)) * (v.x >= 0.0 ? 1.0 : -1.0),
            (1.0 - std::abs(v.x)) * (v.y >= 0.0 ? 1.0 : -1.0)};
}

}  // namespace

Encoding encoding_named(const std::string& depth, const std::string& normals) {
    Encoding encoding{.depth_buffer = depth == "buffer"};
    if (!encoding.depth_buffer && depth != "linear")
        throw std::invalid_argument("--depth " + depth + ": expected linear or buffer");
    std::string_view rest = normals;
    for (bool first = true; first || !rest.empty(); first = false) {
        const std::size_t end = std::min(rest.find('-'), rest.size());
        const std::string_view part = rest.substr(0, end);
        if (first && (part == "view" || part == "world")) {
            encoding.world = part == "world";
        } else if (!first && part == "octahedral") {
            encoding.octahedral = true;
        } else if (!first && part == "unorm") {
            encoding.unorm = true;
        } else {
            throw std::invalid_argument(
                "--normals " + normals +
                ": expected view or world, and behind it -octahedral, -unorm or both, as in world-unorm");
        }
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return encoding;
}

float linear_depth(float stored, const Encoding& encoding, const CameraFrame& camera) {
    double depth = double{stored};
    if (encoding.depth_buffer) {
        const double p22 = double{camera.proj_vk[2][2]};
        const double p32 = double{camera.proj_vk[3][2]};
        const bool in_front = reversed(camera) ? stored > 0.0F : stored < 1.0F;
        depth = camera.orthographic() ? (p32 - depth) / p22 : p32 / (depth + p22);
        if (!in_front) depth = infinity;
    }
    return static_cast<float>(is_depth(depth) ? depth : infinity);
}

glm::vec3 view_normal(const glm::vec3& stored, const Encoding& encoding, const CameraFrame& camera) {
    glm::dvec3 v(stored);
    if (encoding.unorm) v = 2.0 * v - 1.0;
    if (encoding.octahedral) {
        v.z = 1.0 - std::abs(v.x) - std::abs(v.y);
        if (v.z < 0.0) {
            const glm::dvec2 back = folded(glm::dvec2(v));
            v = {back.x, back.y, v.z};
        }
    }
    if (encoding.world) v = view_from_world(camera) * v;
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? glm::vec3(v / length) : glm::vec3(0.0F);
}

double stored_depth(double depth, const Encoding& encoding, const CameraFrame& camera) {
    if (!encoding.depth_buffer) return depth;
    if (!is_depth(depth)) return reversed(camera) ? 0.0 : 1.0;
    const double p22 = double{camera.proj_vk[2][2]};
    const double p32 = double{camera.proj_vk[3][2]};
    return camera.orthographic() ? p32 - p22 * depth : p32 / depth - p22;
}

glm::dvec3 stored_normal(const glm::dvec3& normal, const Encoding& encoding, const CameraFrame& camera) {
    glm::dvec3 v = encoding.world ? glm::transpose(view_from_world(camera)) * normal : normal;
    if (encoding.octahedral) {
        const double sum = std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
        glm::dvec2 at = sum > 0.0 ? glm::dvec2(v) / sum : glm::dvec2(0.0);
        if (v.z < 0.0) at = folded(at);
        v = {at.x, at.y, 0.0};
    }
    return encoding.unorm ? 0.5 * v + 0.5 : v;
}

}  // namespace gloam::scene
