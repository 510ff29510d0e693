// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_PLANE_DEPTH_GLSL
#define GLOAM_GEOMETRY_PLANE_DEPTH_GLSL

#include "gloam/numeric/constants.glsl"

// depth at which a pixel's view ray meets a plane (CAMERA-plane): `t with n . (ray(t) - point) = 0` [ray and plane;
// keeps a bare plane open in TSSAO-3].
// Depth at which the view ray through a pixel's centre meets the plane through a point. A depth buffer holds the
// surface at pixel centres only: a point beside the centre is compared with it fairly when it is first moved there
// along the plane that it belongs to; otherwise a bare plane seen at a grazing angle occludes itself by up to half a
// pixel's slope. The ray is t (x, y, -1) in perspective, (x, y, -t) else; n . (ray - point) = 0 gives t.
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
