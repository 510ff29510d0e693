// SPDX-License-Identifier: MIT
#include "scene/tracer.hpp"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

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

// All hits of this thread's ray, where they are asked for: each is taken down and then passed by.
thread_local std::vector<RayHit>* hits_of_ray = nullptr;

void take_down(const RTCFilterFunctionNArguments* hit) {
    if (hits_of_ray == nullptr) return;
    hits_of_ray->push_back({RTCHitN_primID(hit->hit, hit->N, 0), RTCRayN_tfar(hit->ray, hit->N, 0)});
    *hit->valid = 0;
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
    rtcSetGeometryIntersectFilterFunction(geometry.get(), take_down);
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

std::optional<RaySurface> RayScene::surface(const glm::dvec3& origin, const glm::dvec3& direction,
                                            double near, double far) const {
    const auto hit =
        first_hit(glm::vec3(origin), glm::vec3(direction), static_cast<float>(near), static_cast<float>(far));
    return hit ? surface_of(*hit, origin, direction) : std::nullopt;
}

std::vector<RaySurface> RayScene::surfaces(const glm::dvec3& origin, const glm::dvec3& direction, double near,
                                           double far) const {
    std::vector<RayHit> hits;
    hits_of_ray = &hits;
    (void)first_hit(glm::vec3(origin), glm::vec3(direction), static_cast<float>(near),
                    static_cast<float>(far));
    hits_of_ray = nullptr;
    std::vector<RaySurface> found;
    for (const RayHit& hit : hits)
        if (const auto surface = surface_of(hit, origin, direction)) found.push_back(*surface);
    std::ranges::sort(found, {}, [](const RaySurface& s) { return std::pair(s.distance, s.triangle); });
    return found;
}

std::optional<RaySurface> RayScene::surface_of(const RayHit& hit, const glm::dvec3& origin,
                                               const glm::dvec3& direction) const {
    const std::uint32_t* corner = &indices_[3 * std::size_t{hit.triangle}];
    const glm::dvec3 a = positions_[corner[0]];
    const glm::dvec3 b = positions_[corner[1]];
    const glm::dvec3 c = positions_[corner[2]];
    const glm::dvec3 area = glm::cross(b - a, c - a);
    const double squared = glm::dot(area, area);
    if (!(squared > 0.0)) return std::nullopt;
    glm::dvec3 facet = area / std::sqrt(squared);
    const double slope = glm::dot(facet, direction);
    // Embree's distance, made exact on the triangle's plane, unless the plane is seen edge-on.
    double distance = hit.distance;
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
    const glm::dvec3 found = origin + distance * direction;
    const double reach = std::max({largest(found), largest(b - a), largest(c - a)});
    return RaySurface{hit.triangle, distance, slope > 0.0 ? -facet : facet, weights, reach};
}

}  // namespace gloam::scene
