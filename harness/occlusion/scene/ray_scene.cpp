// SPDX-License-Identifier: MIT
#include "scene/internal/ray_scene.hpp"

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
#include <type_traits>

namespace gloam::scene {

struct EmbreeReleaser {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
template <class Handle>
using EmbreeOwned = std::unique_ptr<std::remove_pointer_t<Handle>, EmbreeReleaser>;

namespace {

[[noreturn]] void fail(RTCDevice device) {
    throw std::runtime_error("Embree: error " + std::to_string(static_cast<int>(rtcGetDeviceError(device))) +
                             " while it prepared the triangles");
}

void check(const std::vector<glm::vec3>& positions, const std::vector<std::uint32_t>& indices) {
    if (indices.empty() || indices.size() % 3 != 0)
        throw std::invalid_argument("nothing to trace: " + std::to_string(indices.size()) +
                                    " indices, expected three for each triangle, one triangle at least");
    for (const std::uint32_t index : indices) {
        if (index < positions.size()) continue;
        throw std::invalid_argument("index " + std::to_string(index) + " is beyond the " +
                                    std::to_string(positions.size()) + " positions");
    }
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const glm::vec3& p = positions[i];
        if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) continue;
        throw std::invalid_argument("vertex " + std::to_string(i) + " is (" + std::to_string(p.x) + ", " +
                                    std::to_string(p.y) + ", " + std::to_string(p.z) +
                                    "), expected finite numbers");
    }
}

EmbreeOwned<RTCGeometry> make_geometry(RTCDevice device, const std::vector<glm::vec3>& positions,
                                       const std::vector<std::uint32_t>& indices) {
    EmbreeOwned<RTCGeometry> geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
    if (!geometry) fail(device);
    const auto fill = [&](RTCBufferType type, RTCFormat format, const void* data, std::size_t count) {
        constexpr std::size_t stride = 12;  // three words
        void* buffer = rtcSetNewGeometryBuffer(geometry.get(), type, 0, format, stride, count);
        if (buffer == nullptr) fail(device);
        std::memcpy(buffer, data, count * stride);
    };
    fill(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, positions.data(), positions.size());
    fill(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, indices.data(), indices.size() / 3);
    rtcCommitGeometry(geometry.get());
    return geometry;
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

struct RayScene::Impl {
    EmbreeOwned<RTCDevice> device;
    EmbreeOwned<RTCScene> scene;
};

RayScene::RayScene(std::vector<glm::vec3> positions, std::vector<std::uint32_t> indices)
    : positions_(std::move(positions)), indices_(std::move(indices)), impl_(base::make_hidden<Impl>()) {
    check(positions_, indices_);
    // One thread builds the tree, so it is the same every time.
    impl_->device.reset(rtcNewDevice("threads=1"));
    if (!impl_->device) fail(nullptr);
    impl_->scene.reset(rtcNewScene(impl_->device.get()));
    if (!impl_->scene) fail(impl_->device.get());
    // Robust: no ray passes between two triangles with a common edge.
    rtcSetSceneFlags(impl_->scene.get(), RTC_SCENE_FLAG_ROBUST);
    const EmbreeOwned<RTCGeometry> geometry = make_geometry(impl_->device.get(), positions_, indices_);
    rtcAttachGeometry(impl_->scene.get(), geometry.get());
    rtcCommitScene(impl_->scene.get());
    if (rtcGetDeviceError(impl_->device.get()) != RTC_ERROR_NONE) fail(impl_->device.get());
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
    intersect(impl_->scene.get(), &ray);
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
