// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_CAMERA_GLSL
#define GLOAM_GEOMETRY_CAMERA_GLSL

#include "gloam/geometry/pixel.glsl"
#include "gloam/geometry/position.glsl"
#include "gloam/geometry/radius.glsl"

// What takes view space to the pixels of an image and back, for either kind of projection.
struct GloamCamera {
    vec2 p00_p11;       // elements (P[0][0], P[1][1]) of the projection; P11 is negative where device y points down
    ivec2 size;         // of the image in pixels
    bool orthographic;  // else perspective
};

// texture coordinates of a view-space position (CAMERA-uv): `ndc / 2 + 1/2, ndc of either projection` [the projection].
// view_position: world units.
// Returns coordinates in [0, 1]^2 inside the image; (1.5, 1.5), outside every image, for a position not in front of
// the eye and wherever the coordinates would not be finite. Error: 2e-7 inside the image.
vec2 gloam_camera_uv(vec3 view_position, GloamCamera camera) {
    return gloam_uv_from_ndc(camera.orthographic ? gloam_ndc_orthographic(view_position, camera.p00_p11)
                                                 : gloam_ndc_perspective(view_position, camera.p00_p11));
}

// view-space position of the surface under a pixel's centre (CAMERA-position): `(ndc.x / P00, ndc.y / P11, -1) d, or
// (ndc.x / P00, ndc.y / P11, -d)` [inverse of the projection].
// pixel: integer pixel. depth: eye-linear depth there, world units.
// Returns the position in world units; the zero vector for background depth and wherever it would not be finite.
// Error: 3 ULP.
vec3 gloam_camera_position(ivec2 pixel, float depth, GloamCamera camera) {
    vec2 ndc = gloam_ndc_from_pixel(pixel, camera.size);
    return camera.orthographic ? gloam_view_position_orthographic(ndc, depth, camera.p00_p11)
                               : gloam_view_position_perspective(ndc, depth, camera.p00_p11);
}

// projected radius of a world length (CAMERA-radius): `R (|P00|, |P11|) / (2 d), or R (|P00|, |P11|) / 2` [the
// projection].
// Half-axes in texture coordinates of a disc parallel to the screen.
// radius: world units, >= 0. depth: eye-linear, world units.
// Returns the half-axes, (0, 0) for background depth. Error: 3 ULP.
vec2 gloam_camera_radius(float radius, float depth, GloamCamera camera) {
    return camera.orthographic ? gloam_projected_radius_uv_orthographic(radius, depth, camera.p00_p11)
                               : gloam_projected_radius_uv(radius, depth, camera.p00_p11);
}

// depth at which a pixel's view ray meets a plane (CAMERA-plane): `t with n . (ray(t) - point) = 0` [ray and plane;
// keeps a bare plane open in TSSAO-3].
// A depth buffer holds the surface at pixel centres only: a point beside the centre is compared with it fairly when it
// is first moved there along the plane that it belongs to; otherwise a bare plane seen at a grazing angle occludes
// itself by up to half a pixel's slope. The ray is t (x, y, -1) in perspective, (x, y, -t) else; n . (ray - point) = 0
// gives t.
// ray: (x, y) where the ray is at depth 1, view space. point: view space, world units, in front of the eye. normal: of
// the plane, view space, any length.
// Returns the eye-linear depth t in world units; the point's own depth where the plane does not face the eye on that
// ray, or meets it behind the eye or beyond what float32 holds. Error: 14 ULP while neither n . ray nor n . point is
// below a quarter of the sum of its products' magnitudes, growing as they cancel further.
float gloam_plane_depth(vec2 ray, vec3 point, vec3 normal, bool orthographic) {
    vec3 start = orthographic ? vec3(ray, 0.0) : vec3(0.0);
    float along = orthographic ? -normal.z : dot(normal, vec3(ray, -1.0));
    float depth = dot(normal, point - start) / (along < 0.0 ? along : -1.0);
    return along < 0.0 && depth > 0.0 && depth <= GLOAM_LARGEST ? depth : -point.z;
}

#endif
