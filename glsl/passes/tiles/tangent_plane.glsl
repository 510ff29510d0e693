// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_TILES_TANGENT_PLANE_GLSL
#define GLOAM_PASSES_TILES_TANGENT_PLANE_GLSL

#include "gloam/geometry/camera.glsl"
#include "gloam/geometry/safe_normalize.glsl"

// The tangent plane of a pixel. Its inverse depth t(q) = n . ray(q) / n . p is affine in the image, and at the pixel it
// equals that of the surface. It is stored as t(q) = 1/d + slopes . (q - pixel), which is exact where samples are.
struct TangentPlane {
    ivec2 pixel;
    float inverse;   // 1/d, 1 / world units
    vec2 slopes;     // per pixel
    float rounded;   // relative error of the slopes
    float height;    // N = -n . p: height of the eye above the plane, world units; 0 or less: no plane
    vec3 normal;     // magnitudes of n
    vec3 position;   // and of p, world units
};

const float ROUNDING = 6e-8;  // e = 2^-24: half a ULP; the rounding mode is unknown, so an operation errs by 2 e

// depth: of the pixel, which has geometry. normal: of any length.
TangentPlane tangent_plane(ivec2 pixel, float depth, vec3 normal, GloamCamera camera) {
    vec3 position = gloam_camera_position(pixel, depth, camera);
    vec3 n = gloam_safe_normalize(normal, vec3(0.0));
    float height = -dot(n, position);
    vec2 slopes = n.xy * (-2.0 / (camera.p00_p11 * vec2(camera.size))) / height;
    // The normal's components differ from those that the samples use by 4 e, except for a common factor. The rest of
    // the quotient is exact to 14 e, n . p to 3 e (S + N) with S the sum of magnitudes, and a position to 6 e. The
    // normal enters here again: e (21 + 13 S / N).
    float rounded = ROUNDING * (24.0 + 14.0 * (dot(abs(n), abs(position)) / height));
    return TangentPlane(pixel, 1.0 / depth, slopes, rounded, height, abs(n), abs(position));
}

float inverse_depth(TangentPlane plane, ivec2 pixel) {
    return plane.inverse + dot(plane.slopes, vec2(pixel - plane.pixel));
}

// Error of inverse_depth() at a pixel, 1 / world units: of the quotient 1/d, the slopes, and three products and sums.
float inverse_depth_error(TangentPlane plane, ivec2 pixel) {
    float sloped = dot(abs(plane.slopes), vec2(abs(pixel - plane.pixel)));
    return 16.0 * ROUNDING * plane.inverse + (plane.rounded + 10.0 * ROUNDING) * sloped;
}

#endif
