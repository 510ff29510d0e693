// SPDX-License-Identifier: MIT
#include "scene/truth.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>

#include "scene/depth_field.hpp"
#include "scene/internal/parallel.hpp"
#include "scene/internal/sobol.hpp"
#include "scene/pixel_positions.hpp"

namespace gloam::scene {
namespace {

bool is_surface(float depth) {
    return depth > 0.0F && std::isfinite(depth);
}

double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

// A point of the G-buffer as it is.
Receiver as_it_is(const glm::dvec3& at, const glm::dvec3& normal) {
    return {.position = at, .normal = normal, .facet = normal, .clearance = 16.0 * 0x1p-24 * largest(at)};
}

// The point of the geometry that a pixel sees, if that is there.
std::optional<Receiver> matched(const OcclusionTracer& tracer, const PixelPositions& positions,
                                const glm::dvec3& seen, const glm::dvec3& normal) {
    constexpr double tolerance = 1e-3;  // of the distance; far above the rounding of a depth buffer
    const glm::dvec3 eye = positions.orthographic() ? glm::dvec3(seen.x, seen.y, 0.0) : glm::dvec3(0.0);
    const double distance = glm::distance(seen, eye);
    auto receiver = tracer.surface(eye, (seen - eye) / distance, distance * (1.0 - tolerance),
                                   distance * (1.0 + tolerance));
    if (receiver) receiver->normal = normal;
    return receiver;
}

// Calls `receiver(pixel)` for each pixel with geometry and traces from there.
template <class ReceiverOf>
TracedTruth trace(const GBuffer& view, const OcclusionTracer& tracer, const TruthSettings& settings,
                  const ReceiverOf& receiver_of) {
    const std::size_t pixels = view.depth.size();
    TracedTruth truth{.occlusion = std::vector<float>(pixels, 0.0F),
                      .standard_error = std::vector<float>(pixels, 0.0F),
                      .rays = tracer.rays()};
    constexpr std::size_t batch = 64;  // pixels that a thread takes at once
    const auto work = [&](std::size_t index) {
        for (std::size_t i = index * batch; i < std::min(pixels, (index + 1) * batch); ++i) {
            if (!is_surface(view.depth[i])) continue;
            const OcclusionEstimate estimate = tracer.occlusion(receiver_of(i), i);
            truth.occlusion[i] = static_cast<float>(estimate.occlusion);
            truth.standard_error[i] = static_cast<float>(estimate.standard_error);
        }
    };
    for_each_index((pixels + batch - 1) / batch, settings.threads, work, settings.progress);
    truth.pixels = static_cast<std::uint64_t>(std::ranges::count_if(view.depth, is_surface));
    return truth;
}

void require_images(const GBuffer& view) {
    const std::size_t pixels = std::size_t{view.extent.width} * view.extent.height;
    if (view.depth.size() == pixels && view.normal.size() == pixels) return;
    throw std::invalid_argument("truth: " + std::to_string(view.depth.size()) + " depths and " +
                                std::to_string(view.normal.size()) + " normals for " +
                                std::to_string(pixels) + " pixels");
}

}  // namespace

TracedTruth trace_geometry(const Scene& scene, int frame, const GBuffer& view,
                           const TruthSettings& settings) {
    validate(scene);
    validate(settings.rays);
    require_images(view);
    const OcclusionTracer tracer(view_space_mesh(scene, frame), settings.rays);
    const PixelPositions positions(view);
    std::atomic<std::uint64_t> unmatched = 0;
    TracedTruth truth = trace(view, tracer, settings, [&](std::size_t pixel) {
        const glm::dvec3 seen = positions.at(pixel, double{view.depth[pixel]});
        const glm::dvec3 normal = view.normal[pixel];
        if (const auto receiver = matched(tracer, positions, seen, normal)) return *receiver;
        ++unmatched;
        return as_it_is(seen, normal);
    });
    truth.unmatched = unmatched;
    return truth;
}

TracedTruth trace_depth(const GBuffer& view, const TruthSettings& settings) {
    validate(settings.rays);
    const Mesh field = depth_field(view, settings.rays.radius, settings.thickness);
    const OcclusionTracer tracer(field, settings.rays);
    return trace(view, tracer, settings, [&](std::size_t pixel) {
        return as_it_is(glm::dvec3(field.positions[pixel]), glm::dvec3(field.normals[pixel]));
    });
}

}  // namespace gloam::scene
