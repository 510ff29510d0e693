// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <string>

#include "reference/filter.hpp"
#include "reference/sampling.hpp"
#include "reference/temporal.hpp"
#include "subject/images.hpp"

// The study's passes in double, as the paper's equations have them, on a view that is drawn for them.
namespace gloam::cli::study {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using glm::ivec2;
using subject::Image;
using subject::make_image;
using namespace reference;

inline constexpr ivec2 size(24, 20);
inline constexpr float radius = 1.5F;
inline constexpr float bias = 0.02F;
inline constexpr float range = 1.0F;
inline constexpr float weight_max = 40.0F;
inline constexpr float c_spatial = 0.21F;
inline constexpr float change_tolerance = 0.01F;
inline constexpr float confidence_factor = 0.5F;
inline constexpr unsigned table_size = 50U;

struct Case {
    std::string name;
    bool orthographic = false;
    bool moving = false;  // the plate moves, and the engine says where its points were
    unsigned taps = 2;    // nearest, bilinear, those of the surface
    unsigned invalidation = 0;
    float smoothing = 0.0F;
    bool rejects = false;  // taps too far in front
    bool lattice = false;
    float bias_depth = 0.0F;
    float least_radius = 0.0F;
    float radius_cap = 1e18F;
    float samples_distance = 0.0F;
    float samples_radius = 0.0F;
    unsigned samples_least = 4;
    ivec2 border{0};
    std::string filter = "convergence";
    float filter_cap = 1e18F;
};

using Camera = GloamCamera;

struct View {
    Camera camera;
    glm::mat4 first_from_view{1.0F};
    Image depth, normal, positions;
};

struct Hit {
    double depth = std::numeric_limits<double>::infinity();
    dvec3 normal{0.0};
    bool on_plate = false;
};

// A floor, a wall that ends, and a plate before it.
inline Hit traced(dvec3 from, dvec3 along, dvec3 plate) {
    Hit hit;
    const auto meet = [&](dvec3 point, dvec3 normal, double left, double right, bool on_plate) {
        const double t = dot(point - from, normal) / dot(along, normal);
        const dvec3 at = from + t * along;
        const bool inside = at.x > left && at.x < right && at.z > -6.5 && (!on_plate || at.y < 0.3);
        if (t > 0.0 && t < hit.depth && inside) hit = {t, normal, on_plate};
    };
    meet({0, -1, 0}, {0, 1, 0}, -9.0, 9.0, false);
    meet({0, 0, -6}, {0, 0, 1}, -9.0, 1.5, false);
    meet(plate, {0, 0, 1}, plate.x - 0.8, plate.x + 0.8, true);
    return hit;
}

// The ray of a pixel, at depth 1.
inline dvec2 ray_of(const Camera& camera, ivec2 pixel) {
    return gloam_camera_position(pixel, 1.0, camera);
}

// Where a point is in the image, in pixels; the centre of the first one is at 1/2.
inline dvec2 place_of(const Camera& camera, dvec3 at) {
    return gloam_camera_uv(at, camera) * dvec2(size);
}

// step: what the plate has moved by since the frame before.
inline View seen(const Camera& camera, const glm::mat4& first_from_view, dvec3 step) {
    const glm::dmat4 matrix(first_from_view);
    View view{
        .camera = camera, .first_from_view = first_from_view, .depth = {}, .normal = {}, .positions = {}};
    const auto hit = [&](ivec2 pixel) {
        const dvec3 from(camera.orthographic ? ray_of(camera, pixel) : dvec2(0.0), 0.0);
        const dvec3 along(camera.orthographic ? dvec2(0.0) : ray_of(camera, pixel), -1.0);
        return traced(matrix * dvec4(from, 1.0), matrix * dvec4(along, 0.0), dvec3(-0.2, 0.0, -4.5) + step);
    };
    view.depth = make_image<float>(size, [&](ivec2 pixel) { return hit(pixel).depth; });
    view.normal = make_image<glm::vec4>(
        size, [&](ivec2 pixel) { return dvec4(hit(pixel).normal, 0.0) * matrix; });  // transposed
    view.positions = make_image<glm::vec4>(size, [&](ivec2 pixel) {
        const Hit at = hit(pixel);
        if (std::isinf(at.depth)) return dvec4(0.0);
        return matrix * dvec4(gloam_camera_position(pixel, at.depth, camera), 1.0) -
               dvec4(at.on_plate ? step : dvec3(0.0), 1.0);
    });
    return view;
}

// What a pixel shall have.
struct Wanted {
    dvec4 value{0.0};
    bool tied = false;  // a decision lies within rounding

    // x: how far a decision is from its border.
    void decide(double x, double rounding) { tied = tied || std::abs(x) < rounding; }
};

inline bool inside(ivec2 pixel, ivec2 border = ivec2(0)) {
    return pixel == glm::clamp(pixel, border, size - 1 - border);
}

// TSSAO-RP, -7, -8: (AO, w) of the texels around where the point was that show it, j of the nearest of them.
inline Wanted reprojected(const Case& one, const View& now, const View& before, const Image& history,
                          ivec2 pixel) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const double depth = now.depth.at<double>(pixel);
    if (std::isinf(depth)) return {{0.0, 0.0, 0.0, infinite}};
    dvec3 previous = gloam_previous_view(pixel, depth, now.camera, now.first_from_view);
    if (one.moving) previous = now.positions.at<dvec4>(pixel);
    const dvec2 place = place_of(before.camera, previous);
    Wanted wanted{{0.0, 0.0, 0.0, -previous.z}};
    const dvec2 off = glm::min(place, dvec2(size) - place);
    wanted.decide(std::min(off.x, off.y), 1e-5);  // edge of the image
    if (std::min(off.x, off.y) < 0.0) return wanted;
    const auto shows = [&](ivec2 texel) {
        const double stored = history.at<dvec4>(texel).w;
        const double apart = std::abs(1.0 - -previous.z / stored);
        wanted.decide(apart - 0.02, 1e-6);  // depth at the tolerance
        return apart < 0.02;
    };
    const ivec2 nearest(place);
    const dvec2 middle = place - dvec2(nearest) - 0.5;
    wanted.decide(0.5 - std::max(std::abs(middle.x), std::abs(middle.y)), 1e-5);  // border of two texels
    const bool none = history.at<dvec4>(nearest).y == 0.0;
    if (one.taps < 2U && (none || !shows(nearest))) return wanted;
    const dvec2 apart = glm::abs(middle);
    const dvec2 beyond = glm::abs(apart - 1.0 / 256.0);  // what is as good as a texel's centre
    wanted.decide(std::min(beyond.x, beyond.y), 1e-5);
    const dvec2 part = glm::mix(apart, dvec2(0.0), glm::lessThan(apart, dvec2(1.0 / 256.0)));
    dvec4 mean(0.0);
    double most = 0.0;
    for (const ivec2 step : {ivec2(0), {1, 0}, {0, 1}, {1, 1}}) {
        if (one.taps == 0U && step != ivec2(0)) continue;
        const ivec2 texel = glm::clamp(nearest + step * ivec2(glm::sign(middle)), ivec2(0), size - 1);
        if (one.taps == 2U && !shows(texel)) continue;
        const dvec2 weights = glm::mix(1.0 - part, part, glm::bvec2(step));
        const double weight = weights.x * weights.y;
        const dvec4 stored = history.at<dvec4>(texel);
        wanted.decide(weight - most, 1e-4);  // heaviest of two texels
        if (weight > most) wanted.value.z = stored.z;
        mean += weight * dvec4(dvec2(stored), 1.0, 0.0);
        most = std::max(most, weight);
    }
    if (most > 0.0) wanted.value = {dvec2(mean) / mean.z, wanted.value.z, wanted.value.w};
    return wanted;
}

// The larger half-axis of the projected radius, pixels.
inline double reach_of(const Camera& camera, double depth) {
    const dvec2 axes = gloam_camera_radius(radius, depth, camera) * dvec2(size);
    return std::max(axes.x, axes.y);
}

// TSSAO-AS, CS-N, ISSAO-LOD.
inline int samples_of(const Case& one, double convergence, double depth, double reach) {
    int samples = gloam_sample_count(convergence, c_spatial, 16, 8);
    const int least = std::min(static_cast<int>(one.samples_least), samples);
    if (one.samples_distance > 0.0F)
        samples = gloam_count_by_distance(depth, one.samples_distance, samples, least);
    if (one.samples_radius > 0.0F) samples = gloam_count_by_radius(reach, one.samples_radius, least, samples);
    return samples;
}

// What the samples of a pixel say.
struct Fresh {
    double blocked = 0.0;
    double taken = 0.0;
    double change = 0.0;
};

// TSSAO-9: by how much a surface that may block a pixel has come nearer to it or gone from it.
inline double change_at(const View& view, ivec2 pixel, ivec2 at, double farthest, Wanted& wanted) {
    const auto place = [&](ivec2 p) {
        return gloam_camera_position(p, view.depth.at<double>(p), view.camera);
    };
    const dvec3 now = place(at) - place(pixel);
    const dvec3 before = view.positions.at<dvec4>(at) - view.positions.at<dvec4>(pixel);
    const dvec3 normal = view.normal.at<dvec4>(pixel);
    wanted.decide(dot(now, normal), 1e-5);  // probe in the plane
    return gloam_probe_change(now, before, normal, farthest);
}

// TSSAO-3, -4 and -14: whether the surface under a sample blocks it.
inline Fresh sampled(const Case& one, const View& view, ivec2 pixel, dvec4 history, int samples,
                     Wanted& wanted) {
    const double depth = view.depth.at<double>(pixel);
    const dvec3 point = gloam_camera_position(pixel, depth, view.camera);
    const dvec3 normal = view.normal.at<dvec4>(pixel);
    const double reach =
        double{radius} * std::min(1.0, double{one.radius_cap} / reach_of(view.camera, depth));
    const double rotation =
        one.lattice ? gloam_lattice_rotation(pixel) : gloam_hash_rotation(pixel - one.border);
    const bool rotates = history.y / double{weight_max} < 0.5;
    Fresh fresh;
    for (int i = 1; i <= samples; ++i) {
        const dvec3 s = gloam_hemisphere_cosine(
            gloam_halton_3d(static_cast<unsigned>(history.z) + static_cast<unsigned>(i)));
        const dvec3 turned = gloam_rotate_hemisphere(s, rotates ? rotation : 0.0);
        const dvec3 sample = point + reach * (gloam_tangent_frame(normal) * turned);
        if (sample.z >= 0.0) continue;
        const dvec2 place = place_of(view.camera, sample);
        const dvec2 off = glm::abs(place - glm::round(place));
        if (inside(ivec2(glm::floor(place))))
            wanted.decide(std::min(off.x, off.y), 2e-5);  // sample at a pixel's edge
        const ivec2 at = glm::clamp(ivec2(glm::floor(place)), ivec2(0), size - 1);
        const double buffer = view.depth.at<double>(at);
        if (one.invalidation > 0U && std::isfinite(buffer))
            fresh.change = std::max(fresh.change, change_at(view, pixel, at, reach + double{range}, wanted));
        if (one.rejects && depth - buffer > double{range}) continue;
        const double in_front =
            gloam_plane_depth(ray_of(view.camera, at), sample, normal, view.camera.orthographic) - buffer;
        const double least = std::max(double{bias}, double{one.bias_depth} * depth);
        wanted.decide(in_front - least, 2e-6);          // sample at the bias
        wanted.decide(in_front - double{range}, 2e-6);  // sample at the range
        fresh.blocked += in_front > least && in_front <= double{range} ? 1.0 : 0.0;
        fresh.taken += 1.0;
    }
    return fresh;
}

// TSSAO-4 to -6, -9 and -SI, BUF: the history with the samples of a frame.
inline Wanted blended(const Case& one, const View& view, const Image* before, ivec2 pixel) {
    const double depth = view.depth.at<double>(pixel);
    if (!inside(pixel, one.border)) return {{0.0, 0.0, 0.0, depth}};
    if (std::isinf(depth)) return {{0.0, 0.0, 0.0, depth}};
    const double reach = reach_of(view.camera, depth);
    if (reach < double{one.least_radius}) return {{0.0, weight_max, 0.0, depth}};
    const dvec4 old = before == nullptr ? dvec4(0.0) : before->at<dvec4>(pixel);
    const int samples = samples_of(one, old.y / double{weight_max}, depth, reach);
    Wanted wanted;
    const Fresh fresh = sampled(one, view, pixel, old, samples, wanted);
    const double weight =
        gloam_invalidated_weight(old.y, before == nullptr ? 0.0 : fresh.change, radius, one.invalidation,
                                 change_tolerance, 5.0, confidence_factor);
    const double count = weight + fresh.taken;
    double occlusion = count > 0.0 ? (weight * old.x + fresh.blocked) / count : 0.0;
    if (one.smoothing > 0.0F && fresh.taken > 0.0)
        occlusion = std::lerp(weight > 0.0 ? old.x : fresh.blocked / fresh.taken, fresh.blocked / fresh.taken,
                              double{one.smoothing});
    const auto index = static_cast<unsigned>(old.z) + static_cast<unsigned>(samples);
    wanted.value = {occlusion, std::min(count, double{weight_max}), index % table_size, depth};
    if (count == 0.0) wanted.value = {0.0, 0.0, 0.0, depth};
    return wanted;
}

inline constexpr float c_adaptive = 0.9F;
inline constexpr float filter_depth = 0.5F;
inline constexpr int half_width = 2;
inline constexpr float sigma_pixels = 1.25F;

// The weighted mean along one axis: CS-BLUR, ISSAO-7, SAO's blur, and TSSAO-10 and -11 by convergence.
// source: what is smoothed.
inline double filtered(const Case& one, const View& view, const Image& history, const Image& source,
                       ivec2 pixel, ivec2 axis) {
    const auto occlusion = [&](ivec2 at) {
        return source.element.rows == 1 ? source.at<double>(at) : source.at<dvec4>(at).x;
    };
    const auto depth = [&](ivec2 at) { return history.at<dvec4>(at).w; };
    const auto scaled = [&](ivec2 at) { return depth(at) / double{filter_depth}; };
    if (std::isinf(depth(pixel))) return occlusion(pixel);
    if (one.filter == "bilateral")
        return gloam_bilateral_filter(pixel, half_width * axis, size, sigma_pixels, 1.0, occlusion, scaled);
    if (one.filter == "geometry")
        return gloam_geometry_blur(pixel, axis, size, half_width, {10.0, 0.5}, occlusion, scaled,
                                   [&](ivec2 at) { return dvec3(view.normal.at<dvec4>(at)); });
    if (one.filter == "sao") {
        GloamWeightedMean mean = gloam_weighted_mean_empty();
        for (int i = -half_width; i <= half_width; ++i) {
            const ivec2 at = pixel + 2 * i * axis;
            if (!inside(at) || std::isinf(depth(at))) continue;
            mean = gloam_weighted_mean_add(mean, occlusion(at),
                                           gloam_sao_blur_weight(i, scaled(at) - scaled(pixel), 1.0));
        }
        return gloam_weighted_mean_value(mean, occlusion(pixel));
    }
    const auto convergence = [&](ivec2 at) {
        return std::min(history.at<dvec4>(at).y / double{weight_max}, 1.0);
    };
    const double own = convergence(pixel);
    const double most = own > 0.0 ? double{one.filter_cap} * own : 1.0;
    const double pixel_width = 2.0 / std::abs(view.camera.p00_p11.y) / size.y;
    return gloam_convergence_filter(
        pixel, axis, size, half_width, c_adaptive,
        double{sigma_pixels} * pixel_width * (view.camera.orthographic ? 1.0 : depth(pixel)),
        [&](ivec2 at) { return dvec2(occlusion(at), std::min(convergence(at), most)); },
        [&](ivec2 at) { return gloam_camera_position(at, depth(at), view.camera); });
}

}  // namespace gloam::cli::study
