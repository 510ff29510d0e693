// SPDX-License-Identifier: MIT
#include "scene/camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string_view>

namespace gloam::scene {
namespace {

void require(bool condition, const std::string& message) {
    if (!condition) throw std::invalid_argument("camera: " + message);
}

void check_direction(const Camera& camera) {
    const glm::dvec3 side = glm::cross(camera.target - camera.eye, camera.up);
    require(glm::length(side) > 0.0, "the eye and its target coincide, or `up` points along the view");
}

// Elements [2][2] and [3][2]: depth-buffer value 0 at the depth `zero`, 1 at `one`.
glm::dvec2 depth_elements(bool perspective, double zero, double one) {
    if (!perspective) return {1.0 / (zero - one), zero / (zero - one)};
    if (std::isinf(one)) return {-1.0, -zero};
    if (std::isinf(zero)) return {0.0, one};
    return {one / (zero - one), one * zero / (zero - one)};
}

glm::dmat4 projection_of(const Camera& camera, double aspect) {
    const bool perspective = camera.projection == Projection::perspective;
    const double scale = perspective ? 1.0 / std::tan(0.5 * camera.fovy_rad) : 2.0 / camera.view_height;
    const glm::dvec2 depth = camera.reversed_z ? depth_elements(perspective, camera.far, camera.near)
                                               : depth_elements(perspective, camera.near, camera.far);
    glm::dmat4 projection(0.0);
    projection[0][0] = scale / aspect;
    projection[1][1] = -scale;
    projection[2][2] = depth.x;
    projection[3][2] = depth.y;
    projection[2][3] = perspective ? -1.0 : 0.0;
    projection[3][3] = perspective ? 0.0 : 1.0;
    return projection;
}

// Matrix from Vulkan's to OpenGL's clip coordinates: y up, z becomes 2 z - w.
const glm::dmat4 clip_gl_from_vk{{1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, 2, 0}, {0, 0, -1, 1}};

constexpr double infinity = std::numeric_limits<double>::infinity();

bool is_depth(double depth) {
    return depth > 0.0 && std::isfinite(depth);
}

// The depth at a depth-buffer value.
double depth_at(const glm::mat4& proj_vk, double value) {
    const bool orthographic = proj_vk[2][3] == 0.0F;
    const double numerator = orthographic ? proj_vk[3][2] - value : double{proj_vk[3][2]};
    const double denominator = orthographic ? double{proj_vk[2][2]} : value + proj_vk[2][2];
    return denominator == 0.0 ? infinity : numerator / denominator;
}

// Whether the far plane has depth-buffer value 0.
bool reversed(const CameraFrame& camera) {
    return camera.proj_vk[2][2] > (camera.orthographic() ? 0.0F : -0.5F);
}

glm::dvec2 folded(const glm::dvec2& v) {
    return {(1.0 - std::abs(v.y)) * (v.x >= 0.0 ? 1.0 : -1.0),
            (1.0 - std::abs(v.x)) * (v.y >= 0.0 ? 1.0 : -1.0)};
}

}  // namespace

CameraFrame make_frame(const Camera& camera, double aspect) {
    check_direction(camera);
    require(aspect > 0.0 && std::isfinite(aspect), "expected a positive aspect ratio");
    require(camera.near > 0.0 && camera.near < camera.far, "expected 0 < near < far");
    require(camera.fovy_rad > 0.0 && camera.fovy_rad < std::numbers::pi,
            "expected a field of view in (0, pi)");
    return {.view = glm::mat4(glm::lookAt(camera.eye, camera.target, camera.up)),
            .proj_vk = glm::mat4(projection_of(camera, aspect))};
}

CameraFrame make_frame(const Camera& camera, double aspect, const Camera& previous) {
    CameraFrame frame = make_frame(camera, aspect);
    frame.previous_view = glm::mat4(glm::lookAt(previous.eye, previous.target, previous.up));
    const glm::dmat3 before = view_rotation(previous);
    glm::dmat4 change(before * glm::transpose(view_rotation(camera)));
    change[3] = glm::dvec4(before * (camera.eye - previous.eye), 1.0);
    frame.previous_from_current = glm::mat4(change);
    return frame;
}

glm::dmat3 view_rotation(const Camera& camera) {
    check_direction(camera);
    return glm::dmat3(glm::lookAt(glm::dvec3(0), camera.target - camera.eye, camera.up));
}

glm::dmat4 gl_from_vk(const glm::dmat4& proj_vk) {
    return clip_gl_from_vk * proj_vk;
}

glm::dmat4 vk_from_gl(const glm::dmat4& proj_gl) {
    return glm::inverse(clip_gl_from_vk) * proj_gl;
}

Planes planes_of(const glm::mat4& proj_vk) {
    const double zero = depth_at(proj_vk, 0.0);
    const double one = depth_at(proj_vk, 1.0);
    return {.near = std::min(zero, one), .far = std::max(zero, one), .reversed_z = zero > one};
}

Encoding encoding_named(const std::string& depth, const std::string& normals) {
    Encoding encoding{.depth_buffer = depth == "buffer"};
    if (!encoding.depth_buffer && depth != "linear")
        throw std::invalid_argument("--depth " + depth + ": expected linear or buffer");
    std::string_view rest = normals;
    const auto take = [&](std::string_view word) {
        const bool next = rest.starts_with(word);
        if (next) rest.remove_prefix(word.size());
        return next;
    };
    encoding.world = take("world");
    const bool known = encoding.world || take("view");
    for (std::size_t before = 0; before != rest.size();) {
        before = rest.size();
        encoding.octahedral |= take("-octahedral");
        encoding.unorm |= take("-unorm");
    }
    if (known && (rest.empty() || rest == "-")) return encoding;
    throw std::invalid_argument(
        "--normals " + normals +
        ": expected view or world, and behind it -octahedral, -unorm or both, as in world-unorm");
}

float linear_depth(float stored, const Encoding& encoding, const CameraFrame& camera) {
    double depth = double{stored};
    if (encoding.depth_buffer) {
        const bool in_front = reversed(camera) ? stored > 0.0F : stored < 1.0F;
        depth = in_front ? depth_at(camera.proj_vk, depth) : infinity;
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
    if (encoding.world) v = glm::dmat3(camera.view) * v;
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? glm::vec3(v / length) : glm::vec3(0.0F);
}

glm::vec3 other_handed(glm::vec3 stored, const Encoding& encoding) {
    if (!encoding.octahedral) return {stored.x, stored.y, encoding.unorm ? 1.0F - stored.z : -stored.z};
    const glm::dvec2 at(stored);
    const glm::dvec2 turned = encoding.unorm ? 0.5 * folded(2.0 * at - 1.0) + 0.5 : folded(at);
    return {glm::vec2(turned), stored.z};
}

double stored_depth(double depth, const Encoding& encoding, const CameraFrame& camera) {
    if (!encoding.depth_buffer) return depth;
    if (!is_depth(depth)) return reversed(camera) ? 0.0 : 1.0;
    const double p22 = double{camera.proj_vk[2][2]};
    const double p32 = double{camera.proj_vk[3][2]};
    return camera.orthographic() ? p32 - p22 * depth : p32 / depth - p22;
}

glm::dvec3 stored_normal(const glm::dvec3& normal, const Encoding& encoding, const CameraFrame& camera) {
    glm::dvec3 v = encoding.world ? glm::transpose(glm::dmat3(camera.view)) * normal : normal;
    if (encoding.octahedral) {
        const double sum = std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
        glm::dvec2 at = sum > 0.0 ? glm::dvec2(v) / sum : glm::dvec2(0.0);
        if (v.z < 0.0) at = folded(at);
        v = {at.x, at.y, 0.0};
    }
    return encoding.unorm ? 0.5 * v + 0.5 : v;
}

}  // namespace gloam::scene
