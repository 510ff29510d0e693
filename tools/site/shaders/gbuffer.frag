// SPDX-License-Identifier: MIT
// G-buffer of the page, fragments: eye-linear depth, the normal that faces the eye, the colour of the surface. The
// images are cleared to 0: no geometry. Normals are those of scene::draw().
#include "gloam/geometry/vector.glsl"

in vec3 view_position;
in vec3 view_normal;
in vec3 albedo;

layout(location = 0) out vec4 depth_out;
layout(location = 1) out vec4 normal_out;
layout(location = 2) out vec4 albedo_out;

// The interpolated normal, turned to the viewer's side of the surface; flat_normal where it has no direction.
vec3 shading_normal(vec3 interpolated, vec3 flat_normal, vec3 away) {
    vec3 n = gloam_safe_normalize(interpolated, flat_normal);
    if (dot(n, flat_normal) < 0.0) n = -n;
    float beyond = dot(n, away);
    return beyond < 0.0 ? n : gloam_safe_normalize(n - (beyond + 1e-4) * away, flat_normal);
}

void main() {
    vec3 away = gloam_safe_normalize(view_position, vec3(0.0, 0.0, -1.0));
    vec3 flat_normal = gloam_safe_normalize(cross(dFdx(view_position), dFdy(view_position)), -away);
    if (dot(flat_normal, away) > 0.0) flat_normal = -flat_normal;
    depth_out = vec4(-view_position.z, 0.0, 0.0, 1.0);
    normal_out = vec4(shading_normal(view_normal, flat_normal, away), 0.0);
    albedo_out = vec4(albedo, 1.0);
}
