// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "reference/occlusion_points.hpp"
#include "reference/occlusion_slices.hpp"

// What the definitions of whole methods share: the shaded point, the surfaces around it, and means over them.
namespace gloam::reference {

// What a method reads of the images.
struct MethodImages {
    Fetch<double> depth;
    Fetch<dvec3> normal;
    Fetch<dvec3> layers;
    Fetch<dvec4> prepared;
};

// The surface at a pixel.
struct Tap {
    glm::ivec2 pixel;
    dvec3 offset;   // from the shaded point
    bool surface;   // else background
    bool rejected;  // too far in front
};

// The request of a pixel. Where it does not gather, the members below `gathers` have no meaning.
struct ShadedPoint {
    ShadedPoint(const MethodImages& from, dvec3 p, dvec3 n, const GloamCamera& eye, const GloamKernel& asked)
        : images(from),
          position(p),
          normal(gloam_safe_normalize(n, dvec3(0.0))),
          camera(eye),
          kernel(asked),
          gathers(gloam_can_gather(p, n, asked.radius, eye)) {
        if (!gathers) return;
        view = camera.orthographic ? dvec3(0.0, 0.0, 1.0) : normalize(-position);
        uv = gloam_camera_uv(position, camera);
        pixel = gloam_nearest_pixel(uv, camera.size);
        axes = gloam_camera_radius(kernel.radius, -position.z, camera);
        upright = {1.0, camera.p00_p11.y < 0.0 ? -1.0 : 1.0};
    }
    [[nodiscard]] ShadedPoint with(const GloamKernel& asked) const {
        return {images, position, normal, camera, asked};
    }

    const MethodImages& images;
    dvec3 position;
    dvec3 normal;  // unit
    GloamCamera camera;
    GloamKernel kernel;
    bool gathers;
    dvec3 view{};        // unit, towards the eye
    dvec2 uv{};          // where the point is seen
    glm::ivec2 pixel{};  // there
    dvec2 axes{};        // half-axes of the radius, texture coordinates
    dvec2 upright{};     // from an offset in the image to one in view space

    // Pixel at a place in units of the radius, and the one in which a point of the view space is seen.
    [[nodiscard]] glm::ivec2 under(dvec2 tap) const {
        return gloam_nearest_pixel(uv + axes * tap, camera.size);
    }
    [[nodiscard]] glm::ivec2 under(dvec3 point) const {
        return gloam_nearest_pixel(gloam_camera_uv(point, camera), camera.size);
    }
    [[nodiscard]] Tap tap(glm::ivec2 at, double depth) const {
        return {at, gloam_camera_position(at, depth, camera) - position, gloam_tap_sees(depth),
                gloam_tap_rejected(-position.z, depth, kernel.farthest)};
    }
    [[nodiscard]] Tap tap(glm::ivec2 at) const { return tap(at, images.depth(at)); }
    // Signed depths of the layers behind the first, and the depth of a layer; 0 is the visible surface.
    [[nodiscard]] dvec3 further(glm::ivec2 at, int layers) const {
        return layers > 1 ? images.layers(at) : dvec3(0.0);
    }
    [[nodiscard]] double depth(glm::ivec2 at, int layer) const {
        return gloam_layer_depth(images.depth(at), further(at, layer + 1), layer);
    }
    [[nodiscard]] double height(const Tap& tap) const { return dot(tap.offset, normal); }
    // Depth on a pixel's ray of the plane through a point, parallel to the tangent plane.
    [[nodiscard]] double plane_depth(glm::ivec2 at, dvec3 point) const {
        const dvec2 ray(gloam_camera_position(at, 1.0, camera));
        return gloam_plane_depth(ray, point, normal, camera.orthographic);
    }
    // Pixels of the image in the disc of the radius.
    [[nodiscard]] double disc_pixels() const { return pi * axes.x * camera.size.x * axes.y * camera.size.y; }
};

// Mean of count(tap) over the taps that are not rejected; background counts nothing.
template <class Count>
GloamEstimate mean_of_taps(const std::vector<Tap>& taps, const Count& count) {
    double sum = 0.0;
    unsigned samples = 0U;
    for (const Tap& tap : taps) {
        if (tap.rejected) continue;
        ++samples;
        sum += tap.surface ? count(tap) : 0.0;
    }
    return gloam_estimate(sum, samples, samples);
}

// Places of the kernel in the disc, in units of the radius (TSSAO-13).
inline std::vector<dvec2> disc_places(const GloamKernel& kernel) {
    std::vector<dvec2> places;
    for (unsigned i = 1; i <= kernel.count; ++i)
        places.push_back(gloam_halton_disc(kernel.first + i, gloam_sincos(kernel.angle)));
    return places;
}

inline std::vector<Tap> taps_at(const ShadedPoint& at, const std::vector<dvec2>& places) {
    std::vector<Tap> taps;
    for (const dvec2 place : places) taps.push_back(at.tap(at.under(place)));
    return taps;
}

}  // namespace gloam::reference
