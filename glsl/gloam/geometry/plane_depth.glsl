// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_PLANE_DEPTH_GLSL
#define GLOAM_GEOMETRY_PLANE_DEPTH_GLSL

#include "gloam/geometry/background.glsl"
#include "gloam/geometry/camera.glsl"

// depth at which a pixel's view ray meets a plane (CAMERA-plane): `t with n . (ray(t) - point) = 0` [ray and plane;
// keeps a bare plane open in TSSAO-3].
// Depth at which the view ray through a pixel's centre meets the plane through a point. A depth buffer holds the
// surface at pixel centres only: a point beside the centre is compared with it fairly when it is first moved there
// along the plane that it belongs to; otherwise a bare plane seen at a grazing angle occludes itself by up to half a
// pixel's slope. The ray is t (ndc.x / P00, ndc.y / P11, -1) in perspective, (ndc.x / P00, ndc.y / P11, -t) else; n .
// (ray - point) = 0 gives t.
// pixel: integer pixel. point: view space, world units, in front of the eye. normal: of the plane, view space, any
// length.
// Returns the eye-linear depth t in world units; the point's own depth where the plane does not face the eye on that
// ray, or meets it behind the eye or beyond what float32 holds; background for a point that is not in front of the
// eye. Error: 14 ULP while neither n . ray nor n . point is below a quarter of the sum of its products' magnitudes,
// growing as they cancel further.
// No method or pass here calls it: it is there to be copied.
float gloam_plane_depth(ivec2 pixel, vec3 point, vec3 normal, GloamCamera camera) {
    if (gloam_is_background(-point.z)) return gloam_background_depth();
    vec3 ray = gloam_camera_position(pixel, 1.0, camera);
    vec3 start = camera.orthographic ? vec3(ray.xy, 0.0) : vec3(0.0);
    float along = dot(normal, ray - start);
    float depth = dot(normal, point - start) / (along < 0.0 ? along : -1.0);
    return along < 0.0 && !gloam_is_background(depth) ? depth : -point.z;
}

#endif
