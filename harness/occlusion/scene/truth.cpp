// SPDX-License-Identifier: MIT
#include "scene/truth.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/cached_file.hpp"
#include "base/threads.hpp"
#include "scene/internal/bytes.hpp"
#include "scene/tracer.hpp"

namespace gloam::scene {
namespace {

// The depth at a place of the image; 0 outside.
float depth_at(const GBuffer& view, const glm::ivec2& at) {
    const glm::ivec2 size(view.extent.width, view.extent.height);
    if (at.x < 0 || at.y < 0 || at.x >= size.x || at.y >= size.y) return 0.0F;
    return view.depth[static_cast<std::size_t>(at.y) * view.extent.width + static_cast<std::size_t>(at.x)];
}

// Whether two neighbouring pixels belong to one surface: their depths differ by at most the thickness, or the
// slope between them continues one of the pixels beyond.
bool connected(const GBuffer& view, double thickness, const glm::ivec2& at, const glm::ivec2& step) {
    const float a = depth_at(view, at);
    const float b = depth_at(view, at + step);
    const auto continues = [&](float first, float second, float third) {
        if (!is_surface(first)) return false;
        if (view.camera.orthographic()) return std::abs(2.0 * second - first - third) <= thickness;
        const double expected = 2.0 / second - 1.0 / first;
        return std::abs(expected - 1.0 / third) * third * third <= thickness;
    };
    if (!is_surface(a) || !is_surface(b)) return false;
    return std::isinf(thickness) || std::abs(double{a} - double{b}) <= thickness ||
           continues(depth_at(view, at - step), a, b) || continues(depth_at(view, at + 2 * step), b, a);
}

// Along an axis, the difference of positions to the neighbour that is nearer in depth, with the sign of the
// positive direction; 0 without a neighbour.
glm::dvec3 slope_at(const GBuffer& view, const PixelPositions& positions, std::size_t pixel, int axis) {
    const auto width = static_cast<int>(view.extent.width);
    const glm::ivec2 at(static_cast<int>(pixel) % width, static_cast<int>(pixel) / width);
    const double depth = view.depth[pixel];
    glm::dvec3 best(0.0);
    double least = std::numeric_limits<double>::infinity();
    for (const int side : {-1, 1}) {
        glm::ivec2 beside = at;
        beside[axis] += side;
        const float other = depth_at(view, beside);
        const double jump = std::abs(other - depth);
        if (!is_surface(other) || !(jump < least)) continue;
        least = jump;
        best = static_cast<double>(side) *
               (positions.at(static_cast<std::size_t>(beside.y * width + beside.x), other) -
                positions.at(pixel, depth));
    }
    return best;
}

glm::vec3 normal_at(const GBuffer& view, const PixelPositions& positions, std::size_t pixel) {
    const glm::dvec3 area =
        glm::cross(slope_at(view, positions, pixel, 1), slope_at(view, positions, pixel, 0));
    const glm::dvec3 from_eye = positions.ray(pixel).direction;  // rows may go up or down
    if (glm::length(area) > 0.0) return {glm::normalize(glm::faceforward(area, from_eye, area))};
    return {0, 0, 1};  // a surface of a single pixel: facing the viewer
}

// A point of the G-buffer, unchanged. reach: the largest coordinate of the triangles around it.
Receiver as_it_is(const glm::dvec3& at, const glm::dvec3& normal, double reach) {
    return {.position = at, .normal = normal, .facet = normal, .clearance = 16.0 * 0x1p-24 * reach};
}

// For each vertex the largest coordinate of its triangles.
std::vector<double> reaches(const Mesh& mesh) {
    std::vector<double> reach(mesh.positions.size());
    for (std::size_t i = 0; i < reach.size(); ++i) reach[i] = largest(glm::dvec3(mesh.positions[i]));
    std::vector<double> result = reach;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const std::span corners(&mesh.indices[i], 3);
        for (const std::uint32_t a : corners)
            for (const std::uint32_t b : corners) result[a] = std::max(result[a], reach[b]);
    }
    return result;
}

// The point of the geometry that a pixel shows: the first surface along the ray through its centre, within a
// thousandth of the distance, far above the rounding of a depth. A surface that faces away from the pixel's
// normal has its own.
std::optional<Receiver> shown_by(const OcclusionTracer& tracer, const PixelPositions& positions,
                                 const glm::dvec3& at, const glm::dvec3& normal) {
    const glm::dvec3 eye = positions.orthographic() ? glm::dvec3(at.x, at.y, 0.0) : glm::dvec3(0.0);
    const double distance = glm::distance(at, eye);
    auto receiver = tracer.surface(eye, (at - eye) / distance, distance * 0.999, distance * 1.001);
    if (receiver && glm::dot(receiver->facet, normal) > 0.0) receiver->normal = normal;
    return receiver;
}

// The truth of a view in which nothing blocks.
TracedTruth open(const GBuffer& view) {
    const std::vector<float> zeros(view.depth.size(), 0.0F);
    return {.occlusion = zeros,
            .standard_error = zeros,
            .pixels = static_cast<std::uint64_t>(std::ranges::count_if(view.depth, is_surface))};
}

// Calls `receiver_of(pixel)` for each pixel with geometry and traces the result.
template <class ReceiverOf>
TracedTruth trace(const GBuffer& view, const OcclusionTracer& tracer, const TruthSettings& settings,
                  const ReceiverOf& receiver_of) {
    TracedTruth truth = open(view);
    truth.rays = tracer.rays();
    const std::size_t width = view.extent.width;
    const auto trace_row = [&](std::size_t row) {
        for (std::size_t i = row * width; i < (row + 1) * width; ++i) {
            if (!is_surface(view.depth[i])) continue;
            const OcclusionEstimate estimate = tracer.occlusion(receiver_of(i), i);
            truth.occlusion[i] = static_cast<float>(estimate.occlusion);
            truth.standard_error[i] = static_cast<float>(estimate.standard_error);
        }
    };
    base::for_each_index(view.extent.height, 0, trace_row, settings.progress);
    return truth;
}

namespace fs = std::filesystem;

// Increase it whenever the tracer's results change for the same input.
constexpr std::uint64_t version = 3;

base::Fingerprint hash_of(char kind, const GBuffer& view, const TruthSettings& settings) {
    base::Fingerprint hash;
    hash.add(version);
    hash.add(static_cast<std::uint64_t>(kind));
    hash.add(std::uint64_t{view.extent.width});
    hash.add(std::uint64_t{view.extent.height});
    hash.add_all(view.depth);
    hash.add_all(view.normal);
    hash.add(double{view.camera.p00_p11().x});
    hash.add(double{view.camera.p00_p11().y});
    hash.add(std::uint64_t{view.camera.orthographic()});
    if (view.off_centre != glm::ivec2(0)) hash.add_all(std::vector{view.off_centre});
    hash.add(settings.rays.radius);
    hash.add(static_cast<std::uint64_t>(settings.rays.falloff));
    hash.add(static_cast<std::uint64_t>(settings.rays.rays));
    hash.add(static_cast<std::uint64_t>(settings.rays.weighting));
    return hash;
}

// The truth that is in the cache by this hash, or else is traced.
template <class Trace>
TracedTruth kept(const fs::path& folder, const base::Hash& hash, const Trace& trace) {
    if (folder.empty()) return trace();
    const fs::path path = folder / (base::to_hex(hash) + ".truth");
    TracedTruth truth;
    std::vector<std::uint64_t> counts;
    if (const auto bytes = base::read_cached(path, hash)) {
        read_bytes(*bytes, counts, truth.occlusion, truth.standard_error);
        truth.rays = counts.at(0);
        truth.pixels = counts.at(1);
        truth.unmatched = counts.at(2);
        return truth;
    }
    truth = trace();
    counts = {truth.rays, truth.pixels, truth.unmatched};
    base::write_cached(path, hash, bytes_of(counts, truth.occlusion, truth.standard_error));  // optional
    return truth;
}

// The scene as an object saw it in the frame before: the object (from 1, 0: the mesh) is where it is in this
// frame, and all else stands to it as it stood then.
Scene seen_from(const Scene& scene, std::size_t object, int frame) {
    glm::dmat4 along(1.0);
    if (object > 0) {
        const auto& transform = scene.objects[object - 1].transform;
        along = transform(frame) * glm::inverse(transform(frame - 1));
    }
    Scene seen = scene;
    for (MovingObject& other : seen.objects)
        other.transform = [along, then = other.transform](int number) { return along * then(number - 1); };
    if (object == 0) return seen;
    seen.objects.push_back({std::exchange(seen.mesh, {}), [along](int) { return along; }});
    return seen;
}

}  // namespace

Mesh depth_field(const GBuffer& view, double thickness) {
    if (std::ranges::none_of(view.depth, is_surface))
        throw std::invalid_argument("depth field: no geometry in the view");
    const PixelPositions positions(view);
    Mesh mesh;
    for (std::size_t pixel = 0; pixel < view.depth.size(); ++pixel) {
        const bool surface = is_surface(view.depth[pixel]);
        mesh.positions.emplace_back(surface ? positions.at(pixel, double{view.depth[pixel]}) : glm::dvec3(0));
        mesh.normals.push_back(!surface              ? glm::vec3(0)
                               : view.normal.empty() ? normal_at(view, positions, pixel)
                                                     : view.normal[pixel]);
    }
    const std::uint32_t width = view.extent.width;
    const glm::ivec2 right(1, 0);
    const glm::ivec2 down(0, 1);
    for (std::uint32_t y = 0; y + 1 < view.extent.height; ++y) {
        for (std::uint32_t x = 0; x + 1 < width; ++x) {
            const glm::ivec2 at(x, y);
            if (!connected(view, thickness, at, right) || !connected(view, thickness, at, down) ||
                !connected(view, thickness, at + down, right) ||
                !connected(view, thickness, at + right, down))
                continue;
            const std::uint32_t corner = y * width + x;
            const std::uint32_t below = corner + width;
            mesh.indices.insert(mesh.indices.end(),
                                {corner, below, corner + 1, corner + 1, below, below + 1});
        }
    }
    return mesh;
}

TracedTruth trace_geometry(const Scene& scene, int frame, const GBuffer& view,
                           const TruthSettings& settings) {
    const Mesh mesh = view_space_mesh(scene, frame);
    base::Fingerprint hash = hash_of('G', view, settings);
    hash.add_all(mesh.positions);
    hash.add_all(mesh.indices);
    return kept(settings.cache, hash.hash(), [&] {
        const OcclusionTracer tracer(mesh, settings.rays);
        const PixelPositions positions(view);
        std::atomic<std::uint64_t> unmatched = 0;
        TracedTruth truth = trace(view, tracer, settings, [&](std::size_t pixel) {
            const glm::dvec3 normal = view.normal[pixel];
            const glm::dvec3 at = positions.at(pixel, double{view.depth[pixel]});
            if (const auto receiver = shown_by(tracer, positions, at, normal)) return *receiver;
            ++unmatched;
            return as_it_is(at, normal, largest(at));
        });
        truth.unmatched = unmatched;
        return truth;
    });
}

TracedTruth trace_depth(const GBuffer& view, const TruthSettings& settings) {
    base::Fingerprint hash = hash_of('D', view, settings);
    hash.add(settings.thickness);
    return kept(settings.cache, hash.hash(), [&] {
        const Mesh field = depth_field(view, settings.thickness);
        if (field.indices.empty()) return open(view);  // no four pixels form a surface: nothing blocks
        const OcclusionTracer tracer(field, settings.rays);
        const std::vector<double> reach = reaches(field);
        return trace(view, tracer, settings, [&](std::size_t pixel) {
            return as_it_is(glm::dvec3(field.positions[pixel]), glm::dvec3(field.normals[pixel]),
                            reach[pixel]);
        });
    });
}

std::vector<float> trace_before(const Scene& scene, int frame, const GBuffer& view,
                                const TruthSettings& settings) {
    std::vector<float> all(view.depth.size(), 0.0F);
    for (std::size_t object = 0; object <= scene.objects.size(); ++object) {
        GBuffer part = view;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (view.object[i] != object) part.depth[i] = std::numeric_limits<float>::infinity();
        const TracedTruth traced = trace_geometry(seen_from(scene, object, frame), frame, part, settings);
        std::ranges::transform(all, traced.occlusion, all.begin(), std::plus{});
    }
    return all;
}

}  // namespace gloam::scene
