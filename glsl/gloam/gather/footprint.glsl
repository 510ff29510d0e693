// SPDX-License-Identifier: MIT
#ifndef GLOAM_GATHER_FOOTPRINT_GLSL
#define GLOAM_GATHER_FOOTPRINT_GLSL

#include "gloam/geometry/camera.glsl"

// The image of the ball of influence around a shaded point, and the mapping from a tap in it to its pixel and to the
// surface there. Computed once a pixel; requires gloam_can_gather.
struct GloamFootprint {
    vec2 center;        // where the point is seen, texture coordinates
    vec2 reach;         // half-axes of the radius of influence, texture coordinates
    ivec2 pixel;        // that the point lies in
    vec2 size;          // of the image, pixels
    vec2 p00_p11;       // of the camera
    bool orthographic;  // the camera; else perspective
};

// Pixel at texture coordinates, the nearest one inside the image. By comparisons: llvmpipe takes three instructions for
// the min and max of a clamp, because it looks for NaN.
ivec2 gloam_footprint_at(GloamFootprint footprint, vec2 uv) {
    vec2 at = uv * footprint.size;
    vec2 last = footprint.size - 1.0;
    at = mix(last, at, lessThan(at, last));
    return ivec2(mix(vec2(0.0), at, greaterThan(at, vec2(0.0))));
}

// position: of the shaded point, view space, world units. radius: of influence, world units.
// Returns the center of gloam_camera_uv and the reach of gloam_camera_radius, without their care for background and
// infinities, which gloam_can_gather rejects; neither is beyond 1e18. Error of both: 3 ULP.
GloamFootprint gloam_footprint(vec3 position, float radius, GloamCamera camera) {
    vec2 p = camera.p00_p11;
    float depth = camera.orthographic ? 1.0 : -position.z;
    vec2 center = 0.5 * clamp(p * position.xy / depth, vec2(-1e18), vec2(1e18)) + 0.5;
    vec2 reach = min(0.5 * abs(p) * (radius / depth), vec2(1e18));
    GloamFootprint footprint = GloamFootprint(center, reach, ivec2(0), vec2(camera.size), p, camera.orthographic);
    footprint.pixel = gloam_footprint_at(footprint, center);
    return footprint;
}

// Pixel that a tap reads.
// tap: in units of the radius, y down. Returns a pixel inside the image, the nearest where the tap lies outside.
// Error: none, but a tap within rounding of a pixel's border may fall to either side.
ivec2 gloam_footprint_pixel(GloamFootprint footprint, vec2 tap) {
    return gloam_footprint_at(footprint, footprint.center + footprint.reach * tap);
}

// Pixel in which a point of the view space is seen, the nearest one inside the image; of a point that is not in front
// of the eye any.
// at: view space, world units. Error: none, but a point within rounding of a pixel's border may fall to either side.
ivec2 gloam_footprint_seen(GloamFootprint footprint, vec3 at) {
    vec2 ndc = footprint.p00_p11 * at.xy / (footprint.orthographic ? 1.0 : max(-at.z, 1e-18));
    return gloam_footprint_at(footprint, 0.5 * ndc + 0.5);
}

// Where the view ray of a pixel is at depth 1. Divided as gloam_camera_position divides: a product with a reciprocal
// would move all taps against the shaded point, by more than the bias where a tilted plane is far away.
// Returns (x, y), view space. Error: 2 ULP.
vec2 gloam_footprint_ray(GloamFootprint footprint, ivec2 pixel) {
    return (vec2(2 * pixel + 1) - footprint.size) / footprint.size / footprint.p00_p11;
}

// The surface at a pixel.
// depth: eye-linear, world units. Returns its position in view space, world units. Error: 3 ULP.
vec3 gloam_footprint_position(GloamFootprint footprint, ivec2 pixel, float depth) {
    vec2 ray = gloam_footprint_ray(footprint, pixel);
    return vec3(footprint.orthographic ? ray : ray * depth, -depth);
}

// Product of a vector with the offset from the shaded point to the surface of a tap, as an affine function of the tap's
// pixel and depth. It takes no division at a tap. Both are counted from the pixel of the point, so where the point is
// that pixel's surface, nothing of its own position is rounded.
struct GloamFootprintProduct {
    vec2 across;    // for each pixel to the right and down, at depth 1
    float further;  // for each unit of depth
    float rest;     // of the surface at the point's pixel and depth
};

// position: of the shaded point, the one of gloam_footprint. vector: view space.
// Returns the product. Error: 3 ULP of its largest term.
GloamFootprintProduct gloam_footprint_product(GloamFootprint footprint, vec3 position, vec3 vector) {
    vec2 ray = gloam_footprint_ray(footprint, footprint.pixel);
    vec2 rest = (footprint.orthographic ? ray : -position.z * ray) - position.xy;
    float further = (footprint.orthographic ? 0.0 : dot(ray, vector.xy)) - vector.z;
    return GloamFootprintProduct(2.0 / footprint.size / footprint.p00_p11 * vector.xy, further, dot(rest, vector.xy));
}

// The surface of a tap, for products.
// pixel: of the tap. depth: there, eye-linear, world units. center: depth of the shaded point.
// Returns (pixels to the right times its scale, pixels down likewise, depth beyond the point's). Error: 1 ULP.
vec3 gloam_footprint_tap(GloamFootprint footprint, ivec2 pixel, float depth, float center) {
    return vec3((footprint.orthographic ? 1.0 : depth) * vec2(pixel - footprint.pixel), depth - center);
}

// Value of a product. tap: of gloam_footprint_tap. Error: 3 ULP of its largest term.
float gloam_footprint_value(GloamFootprintProduct product, vec3 tap) {
    GLOAM_PRECISE float value = dot(product.across, tap.xy) + (product.further * tap.z + product.rest);
    return value;
}

// Depth at which the view ray of a pixel meets the plane through a point (gloam_plane_depth).
float gloam_footprint_plane_depth(GloamFootprint footprint, ivec2 pixel, vec3 point, vec3 normal) {
    return gloam_plane_depth(gloam_footprint_ray(footprint, pixel), point, normal, footprint.orthographic);
}

// From a surface to the eye: unit vector.
// position: view space, world units, in front of the eye. Error: 5 ULP.
vec3 gloam_toward_eye(vec3 position, bool orthographic) {
    return orthographic ? vec3(0.0, 0.0, 1.0) : normalize(-position);
}

// Turns an offset in the image, y down in Vulkan, into one of the view space, y up, and back: (1, -1) or (1, 1).
vec2 gloam_upright(GloamCamera camera) {
    return vec2(1.0, camera.p00_p11.y < 0.0 ? -1.0 : 1.0);
}

#endif
