// SPDX-License-Identifier: MIT
#include "scene/tracer.hpp"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <cmath>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>

namespace gloam::scene {

namespace {

[[noreturn]] void fail(RTCDevice device) {
    throw std::runtime_error("Embree: error " + std::to_string(static_cast<int>(rtcGetDeviceError(device))) +
                             " while it prepared the triangles");
}

template <class Handle>
std::shared_ptr<Handle> owned(Handle* handle, void (*release)(Handle*), RTCDevice device) {
    if (handle == nullptr) fail(device);
    return {handle, release};
}

template <class T>
void fill(RTCDevice device, RTCGeometry geometry, RTCBufferType type, RTCFormat format,
          const std::vector<T>& values) {
    constexpr std::size_t stride = 12;  // three words
    const std::size_t bytes = values.size() * sizeof(T);
    void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, stride, bytes / stride);
    if (buffer == nullptr) fail(device);
    std::memcpy(buffer, values.data(), bytes);
}

// The call that differs between Embree 3 and 4.
#if RTC_VERSION_MAJOR >= 4
void intersect(RTCScene scene, RTCRayHit* ray) {
    rtcIntersect1(scene, ray, nullptr);
}
#else
void intersect(RTCScene scene, RTCRayHit* ray) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, ray);
}
#endif

}  // namespace

RayScene::RayScene(const Mesh& mesh)
    : positions_(mesh.positions),
      indices_(mesh.indices),
      // One thread builds the tree, so it is the same every time.
      device_(owned(rtcNewDevice("threads=1"), rtcReleaseDevice, nullptr)),
      scene_(owned(rtcNewScene(device_.get()), rtcReleaseScene, device_.get())) {
    RTCDevice device = device_.get();
    // Robust: no ray passes between two triangles with a common edge.
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
    const auto geometry =
        owned(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE), rtcReleaseGeometry, device);
    fill(device, geometry.get(), RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, positions_);
    fill(device, geometry.get(), RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, indices_);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometry(scene_.get(), geometry.get());
    rtcCommitScene(scene_.get());
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) fail(device);
}

std::optional<RayHit> RayScene::first_hit(const glm::vec3& origin, const glm::vec3& direction, float near,
                                          float far) const {
    RTCRayHit ray{};
    ray.ray.org_x = origin.x;
    ray.ray.org_y = origin.y;
    ray.ray.org_z = origin.z;
    ray.ray.dir_x = direction.x;
    ray.ray.dir_y = direction.y;
    ray.ray.dir_z = direction.z;
    ray.ray.tnear = near;
    ray.ray.tfar = far;
    ray.ray.mask = 0xFFFFFFFFU;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    intersect(scene_.get(), &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return RayHit{ray.hit.primID, ray.ray.tfar};
}

std::array<glm::dvec3, 3> RayScene::corners(std::uint32_t triangle) const {
    const std::uint32_t* corner = &indices_[3 * std::size_t{triangle}];
    return {positions_[corner[0]], positions_[corner[1]], positions_[corner[2]]};
}

std::optional<RaySurface> RayScene::surface(const glm::dvec3& origin, const glm::dvec3& direction,
                                            double near, double far) const {
    const auto hit =
        first_hit(glm::vec3(origin), glm::vec3(direction), static_cast<float>(near), static_cast<float>(far));
    if (!hit) return std::nullopt;
    const auto [a, b, c] = corners(hit->triangle);
    const glm::dvec3 area = glm::cross(b - a, c - a);
    const double squared = glm::dot(area, area);
    if (!(squared > 0.0)) return std::nullopt;
    glm::dvec3 facet = area / std::sqrt(squared);
    const double slope = glm::dot(facet, direction);
    // Embree's distance, made exact on the triangle's plane, unless the plane is seen edge-on.
    double distance = hit->distance;
    if (std::abs(slope) > 1e-6 * glm::length(direction)) distance = glm::dot(facet, a - origin) / slope;
    const glm::dvec3 at = origin + distance * direction - a;
    glm::dvec3 weights(0, glm::dot(glm::cross(at, c - a), area), glm::dot(glm::cross(b - a, at), area));
    weights.x = squared - weights.y - weights.z;
    // Embree finds points beyond an edge by its rounding; seen edge-on, the plane there is far off.
    const glm::dvec3 inside = glm::max(weights, 0.0);
    if (inside != weights) {
        weights = inside;
        const glm::dvec3 nearest =
            (inside.x * a + inside.y * b + inside.z * c) / (inside.x + inside.y + inside.z);
        distance = glm::dot(nearest - origin, direction) / glm::dot(direction, direction);
    }
    weights /= weights.x + weights.y + weights.z;
    return RaySurface{hit->triangle, distance, hit->distance, slope > 0.0 ? -facet : facet, weights};
}

}  // namespace gloam::scene
