// SPDX-License-Identifier: MIT
// G-buffer, fragments: eye-linear depth, computed from the value that goes into the depth buffer, and the view-space
// normal. With GLOAM_MOTION also the view-space position in the previous frame, the object and the triangle. All images
// are cleared to 0: no geometry.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "gloam/geometry/linear_depth.glsl"
#include "gloam/geometry/safe_normalize.glsl"

layout(location = 0) in vec3 view_position;
layout(location = 1) in vec3 view_normal;

layout(location = 0) out float linear_depth;
layout(location = 1) out vec4 normal;
#ifdef GLOAM_MOTION
layout(location = 2) in vec3 previous_view_position;
layout(location = 3) flat in vec2 object_and_triangle;
layout(location = 2) out vec4 previous_and_object;  // integers up to 2^24 are exact
layout(location = 3) out float triangle_and_one;
#endif

layout(push_constant) uniform Parameters {
    mat4 projection;
};

// The interpolated normal, turned to the viewer's side of the surface.
// interpolated: of any length. flat_normal: of the triangle, unit, facing the viewer. away: unit, from the viewer.
// Returns a unit vector n with dot(n, away) < 0; flat_normal where the interpolated one has no direction. On smooth
// silhouettes interpolation can turn the normal away from the viewer. Then n is its part perpendicular to the view.
vec3 shading_normal(vec3 interpolated, vec3 flat_normal, vec3 away) {
    vec3 n = gloam_safe_normalize(interpolated, flat_normal);
    if (dot(n, flat_normal) < 0.0) n = -n;
    float beyond = dot(n, away);
    return beyond < 0.0 ? n : gloam_safe_normalize(n - (beyond + 1e-4) * away, flat_normal);
}

void main() {
    float b = gl_FragCoord.z;
    bool orthographic = projection[2][3] == 0.0;
    linear_depth = orthographic ? gloam_linear_depth_orthographic_vk(b, projection[2][2], projection[3][2])
                                : gloam_linear_depth_perspective_vk(b, projection[2][2], projection[3][2]);
    vec3 away = orthographic ? vec3(0.0, 0.0, -1.0) : gloam_safe_normalize(view_position, vec3(0.0, 0.0, -1.0));
    // Seen edge-on, the derivatives may have no direction; then the normal points straight at the viewer.
    vec3 flat_normal = gloam_safe_normalize(cross(dFdx(view_position), dFdy(view_position)), -away);
    if (dot(flat_normal, away) > 0.0) flat_normal = -flat_normal;
    // Geometry is background where the depth buffer cannot distinguish its depth from infinity.
    bool background = gloam_is_background(linear_depth);
    normal = vec4(background ? vec3(0.0) : shading_normal(view_normal, flat_normal, away), 0.0);
#ifdef GLOAM_MOTION
    previous_and_object = background ? vec4(0.0) : vec4(previous_view_position, object_and_triangle.x);
    triangle_and_one = background ? 0.0 : object_and_triangle.y + 1.0;
#endif
}
