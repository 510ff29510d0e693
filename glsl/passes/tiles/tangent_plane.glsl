// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_TILES_TANGENT_PLANE_GLSL
#define GLOAM_PASSES_TILES_TANGENT_PLANE_GLSL

#include "gloam/geometry/camera.glsl"
#include "gloam/geometry/safe_normalize.glsl"

// The tangent plane of a pixel. Its inverse depth is affine in the image, t(q) = n . ray(q) / n . p, and that of the
// surface at the pixel: written from there on, t(q) = 1/d + slopes . (q - pixel), it is exact where samples are.
struct TangentPlane {
    ivec2 pixel;
    float inverse;   // 1/d, 1 / world units
    vec2 slopes;     // per pixel
    float rounded;   // error of the slopes, relative
    float height;    // N = -n . p: of the eye above the plane, world units; 0 or less for none
    vec3 normal;     // magnitudes of n
    vec3 position;   // and of p, world units
};

const float ROUNDING = 6e-8;  // e = 2^-24: half a ULP; rounding may go either way, so an operation errs by 2 e

// depth: of the pixel, no background. normal: of any length.
TangentPlane tangent_plane(ivec2 pixel, float depth, vec3 normal, GloamCamera camera) {
    vec3 position = gloam_camera_position(pixel, depth, camera);
    vec3 n = gloam_safe_normalize(normal, vec3(0.0));
    float height = -dot(n, position);
    vec2 slopes = n.xy * (-2.0 / (camera.p00_p11 * vec2(camera.size))) / height;
    // The normal's components differ from those of the samples' by 4 e, but for a common factor, the rest of the
    // quotient is exact to 14 e; n . p is to 3 e (S + N), with S the sum of magnitudes, and a position to 6 e; here
    // the normal counts again: e (21 + 13 S / N).
    float rounded = ROUNDING * (24.0 + 14.0 * (dot(abs(n), abs(position)) / height));
    return TangentPlane(pixel, 1.0 / depth, slopes, rounded, height, abs(n), abs(position));
}

float inverse_depth(TangentPlane plane, ivec2 pixel) {
    return plane.inverse + dot(plane.slopes, vec2(pixel - plane.pixel));
}

// Error of inverse_depth() at a pixel: of the quotient 1/d, of the slopes, and of three products and sums.
float inverse_depth_error(TangentPlane plane, ivec2 pixel) {
    float sloped = dot(abs(plane.slopes), vec2(abs(pixel - plane.pixel)));
    return 16.0 * ROUNDING * plane.inverse + (plane.rounded + 10.0 * ROUNDING) * sloped;
}

#endif
