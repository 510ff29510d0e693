// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_ENGINE_INPUTS_GLSL
#define GLOAM_PASSES_ENGINE_INPUTS_GLSL

// Depth and normals as an engine stores them, and their conversion to what all other passes read. For an engine with
// another encoding, change linear_depth() and view_direction().

#include "gloam/geometry/linear_depth.glsl"
#include "gloam/geometry/vector.glsl"

layout(constant_id = 0) const bool depth_buffer = false;  // depth is that of a depth buffer; else eye-linear
layout(constant_id = 1) const bool orthographic = false;  // the camera; else perspective
layout(constant_id = 2) const bool world_normals = false;       // in world space; else in view space
layout(constant_id = 3) const bool octahedral_normals = false;  // two numbers; else three
layout(constant_id = 4) const bool unorm_normals = false;       // 0 to 1 stands for -1 to 1; else as they are

// Eye-linear depth, world units; +infinity for background.
// stored: eye-linear depth, or the value of a depth buffer in [0, 1]. Its far end, 1 (reversed: 0), is background.
// p22_p32: elements [2][2] and [3][2] of the projection with depth range [0, 1]. They say which depth buffer it is:
// standard or reversed, with a finite or an infinite far plane.
// Error: that of gloam_linear_depth_perspective_vk and gloam_linear_depth_orthographic_vk.
float linear_depth(float stored, vec2 p22_p32) {
    if (!depth_buffer) return gloam_is_background(stored) ? gloam_background_depth() : stored;
    bool reversed = p22_p32.x > (orthographic ? 0.0 : -0.5);
    bool in_front_of_far_plane = reversed ? stored > 0.0 : stored < 1.0;
    if (!in_front_of_far_plane) return gloam_background_depth();
    return orthographic ? gloam_linear_depth_orthographic_vk(stored, p22_p32.x, p22_p32.y)
                        : gloam_linear_depth_perspective_vk(stored, p22_p32.x, p22_p32.y);
}

// The vector of two octahedral coordinates (Cigolle et al. 2014), not normalised. at: in [-1, 1].
vec3 octahedral_vector(vec2 at) {
    vec3 v = vec3(at, 1.0 - abs(at.x) - abs(at.y));
    float folded = max(-v.z, 0.0);
    return vec3(v.x - (v.x >= 0.0 ? folded : -folded), v.y - (v.y >= 0.0 ? folded : -folded), v.z);
}

// Normal in view space, not normalised.
// stored: a texel of the engine's normals. columns: of the rotation from world space to view space, in xyz. The last w
// is 2 where the engine's view space is left-handed, else 0: its z is turned, that of the matrix is right-handed.
vec3 view_direction(vec3 stored, mat3x4 columns) {
    vec3 v = unorm_normals ? 2.0 * stored - 1.0 : stored;
    if (octahedral_normals) v = octahedral_vector(v.xy);
    return world_normals ? columns[0].xyz * v.x + columns[1].xyz * v.y + columns[2].xyz * v.z
                         : vec3(v.xy, v.z - columns[2].w * v.z);
}

// The same as a unit vector; 0 where the stored normal has no direction.
vec3 view_normal(vec3 stored, mat3x4 columns) {
    return gloam_safe_normalize(view_direction(stored, columns), vec3(0.0));
}

#endif
