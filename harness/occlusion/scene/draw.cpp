// SPDX-License-Identifier: MIT
#include "scene/draw.hpp"

#include <cmath>
#include <limits>

#include "base/threads.hpp"
#include "scene/tracer.hpp"

namespace gloam::scene {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Whether a surface behind another, or beside it, touches it on their ray. What touches in the scene is apart
// by the rounding of its corners, up to 2^-22 of the reach, at right angles to it; along the ray, which may
// graze it, by any multiple of that.
bool touching(const RaySurface& before, const RaySurface& surface, const glm::dvec3& direction) {
    const double slope = std::max(-glm::dot(before.facet, direction), -glm::dot(surface.facet, direction));
    return (surface.distance - before.distance) * slope <= 0x1p-20 * std::max(before.reach, surface.reach);
}

glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& otherwise) {
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? v / length : otherwise;
}

// The interpolated normal, turned to the viewer's side of the surface. facet: of the triangle, unit, facing
// the viewer; returned where the interpolated one has no direction. away: unit, from the viewer. On smooth
// silhouettes interpolation can turn the normal away from the viewer; then its part perpendicular to the view
// is returned.
glm::dvec3 shading_normal(const glm::dvec3& interpolated, const glm::dvec3& facet, const glm::dvec3& away) {
    glm::dvec3 n = unit_or(interpolated, facet);
    if (glm::dot(n, facet) < 0.0) n = -n;
    const double beyond = glm::dot(n, away);
    return beyond < 0.0 ? n : unit_or(n - (beyond + 1e-4) * away, facet);
}

// Motion of a pixel from the position of its surface point in the frame before: dx, dy in pixels, and whether
// the point was in the previous image. before: that frame's view.
glm::vec3 motion_of(std::size_t pixel, const glm::vec3& previous_position, const GBuffer& before) {
    const PixelPositions positions(before);
    if (!(previous_position.z < 0.0F || positions.orthographic())) return glm::vec3(0);
    const glm::dvec2 then = positions.pixel_of(previous_position);
    return {glm::vec2(positions.center(pixel) - then), positions.contains(then) ? 1.0F : 0.0F};
}

// One frame of one scene.
class Shot {
  public:
    Shot(const Scene& scene, backend::Extent frame, const DrawOptions& options)
        : options_(options),
          mesh_(view_space_mesh(scene, options.frame)),
          rays_(mesh_),
          objects_(scene.mesh.triangle_count(), 0) {
        for (std::uint32_t k = 0; k < scene.objects.size(); ++k)
            objects_.insert(objects_.end(), scene.objects[k].mesh.triangle_count(), k + 1);
        const backend::Extent border = guard_border(frame, options.guard);
        const backend::Extent wide = with_border(frame, border);
        const double aspect = static_cast<double>(wide.width) / wide.height;
        const int previous = std::max(0, options.frame - 1);
        const Camera now = with_border(camera_at(scene, options.frame), frame, border);
        const Camera then = with_border(camera_at(scene, previous), frame, border);
        near_ = now.near;
        far_ = now.far;
        if (options.motion) earlier_ = view_space_mesh(scene, previous).positions;
        before_ = {.extent = wide, .camera = make_frame(then, aspect)};
        view_ = {.extent = wide,
                 .camera = options.frame > 0 ? make_frame(now, aspect, then) : make_frame(now, aspect),
                 .ao_radius = scene.ao_radius,
                 .border = border};
    }

    [[nodiscard]] GBuffer take() && {
        const std::size_t pixels = std::size_t{view_.extent.width} * view_.extent.height;
        constexpr auto background = static_cast<float>(infinity);
        view_.depth.assign(pixels, background);
        view_.normal.assign(pixels, glm::vec3(0));
        view_.layers.assign(static_cast<std::size_t>(options_.layers - 1), std::vector(pixels, background));
        if (options_.motion) view_.motion = view_.previous_position = view_.normal;
        if (options_.color) view_.color = view_.normal;
        view_.object.assign(pixels, 0);
        base::for_each_index(view_.extent.height, 0, [&](std::size_t row) {
            for (std::size_t x = 0; x < view_.extent.width; ++x) trace(row * view_.extent.width + x);
        });
        return std::move(view_);
    }

  private:
    // The value at a surface of what is given for each vertex.
    [[nodiscard]] glm::dvec3 interpolated(const std::vector<glm::vec3>& values,
                                          const RaySurface& surface) const {
        const std::uint32_t* corner = &mesh_.indices[3 * std::size_t{surface.triangle}];
        glm::dvec3 sum(0);
        for (int k = 0; k < 3; ++k) sum += surface.weights[k] * glm::dvec3(values[corner[k]]);
        return sum;
    }

    void trace(std::size_t pixel) {
        const auto [origin, direction] = PixelPositions(view_).ray(pixel);
        auto before = rays_.surface(origin, direction, near_, far_);
        if (!before) return;
        show(pixel, *before, glm::normalize(direction));
        if (view_.layers.empty()) return;
        auto layer = view_.layers.begin();
        float* depth = nullptr;  // of the layer before, behind the first
        for (const RaySurface& surface : rays_.surfaces(origin, direction, before->distance, far_)) {
            // Negative where the mesh's normal points to the far side: the eye sees the surface from behind.
            const bool back = glm::dot(interpolated(mesh_.normals, surface), surface.facet) < 0.0;
            if (touching(*before, surface, direction)) {
                if (depth != nullptr && !back) *depth = std::abs(*depth);
                continue;
            }
            if (layer == view_.layers.end()) return;
            depth = &(*layer++)[pixel];
            *depth = static_cast<float>(back ? -surface.distance : surface.distance);
            before = surface;
        }
    }

    void show(std::size_t pixel, const RaySurface& surface, const glm::dvec3& away) {
        view_.depth[pixel] = static_cast<float>(surface.distance);
        view_.normal[pixel] = shading_normal(interpolated(mesh_.normals, surface), surface.facet, away);
        if (options_.color)
            view_.color[pixel] = mesh_.colors.empty() ? default_color : mesh_.colors[surface.triangle];
        view_.object[pixel] = objects_[surface.triangle];
        if (!options_.motion) return;
        view_.previous_position[pixel] = interpolated(earlier_, surface);
        if (options_.frame > 0)
            view_.motion[pixel] = motion_of(pixel, view_.previous_position[pixel], before_);
    }

    DrawOptions options_;
    Mesh mesh_;
    RayScene rays_;
    std::vector<std::uint32_t> objects_;  // of each triangle
    std::vector<glm::vec3> earlier_;      // positions of the frame before
    double near_ = 0.0;
    double far_ = 0.0;
    GBuffer before_;  // the frame before, without images
    GBuffer view_;
};

}  // namespace

Camera camera_at(const Scene& scene, int frame) {
    return scene.camera_path ? scene.camera_path(frame) : scene.camera;
}

Mesh view_space_mesh(const Scene& scene, int frame) {
    const Camera camera = camera_at(scene, frame);
    const glm::dmat3 rotation = view_rotation(camera);
    Mesh all;
    const auto add = [&](const Mesh& mesh, const glm::dmat4& world_from_mesh) {
        const glm::dmat3 turn = rotation * glm::dmat3(world_from_mesh);
        const glm::dvec3 move = rotation * (glm::dvec3(world_from_mesh[3]) - camera.eye);
        // A static mesh is moved relative to the eye before it is rotated, so that no digits are lost far
        // from the origin.
        const bool still = world_from_mesh == glm::dmat4(1.0);
        Mesh seen = mesh;
        for (glm::vec3& p : seen.positions)
            p = still ? rotation * (glm::dvec3(p) - camera.eye) : turn * glm::dvec3(p) + move;
        for (glm::vec3& n : seen.normals) n = turn * glm::dvec3(n);
        append(all, seen);
    };
    add(scene.mesh, glm::dmat4(1.0));
    for (const MovingObject& object : scene.objects) add(object.mesh, object.transform(frame));
    return all;
}

GBuffer draw(const Scene& scene, backend::Extent extent, const DrawOptions& options) {
    return Shot(scene, extent, options).take();
}

}  // namespace gloam::scene
