// SPDX-License-Identifier: MIT
#ifndef GLOAM_DIRECTIONAL_POINTS_GLSL
#define GLOAM_DIRECTIONAL_POINTS_GLSL

// The bindings, the samples and main() of the passes that estimate in which directions a point is open. The samples
// are those of Ritschel et al. (2009): points of the half ball around the normal, uniform in direction and radius. A
// sample is blocked or open as in the method hemisphere. Bindings from 4 on are as the pass says.
#include "passes/study/input_image.glsl"

layout(binding = 0 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT depth_image;
layout(binding = 1 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT normal_image;

layout(binding = 3, rgba32f) uniform writeonly highp image2D written_image;  // written_at(); 0 at the background

layout(push_constant) uniform Parameters {
    vec2 p00_p11;           // elements [0][0] and [1][1] of the projection, y down
    ivec2 size;             // of the images, pixels, with the guard band
    float radius;           // of influence, world units
    float bias;             // world units
    uint samples;           // for each pixel
    uint orthographic;      // 1, or 0 for perspective
    mat3x4 world_from_view;  // a rotation: only xyz of each column are used
} parameters;

#include "gloam/gather/footprint.glsl"
#include "gloam/geometry/vector.glsl"
#include "gloam/occlusion/blocked.glsl"
#include "gloam/sampling/halton.glsl"
#include "gloam/sampling/hemisphere.glsl"
#include "gloam/sampling/rotation.glsl"
#include "passes/study/method_values.glsl"

layout(binding = 2, std430) readonly buffer MethodSettings { MethodValues method_values; };

float gloam_fetch_depth(ivec2 pixel) {
    return GLOAM_FETCH(depth_image, pixel).x;
}

// The shaded point.
struct Shaded {
    vec3 position;  // view space, world units
    vec3 normal;    // unit
    mat3 frame;     // tangent, bitangent, normal
    GloamFootprint footprint;
    vec2 turn;  // (cos, sin) of the kernel's rotation
};

// One sample: a direction, and whether the point is open there.
struct Sample {
    vec3 direction;    // view space, unit
    float visibility;  // 1 open, 0 blocked
    ivec2 pixel;       // where the sample is compared with the depth
    bool counts;       // false behind the eye and for a point without direction
};

GloamCamera this_camera() {
    return GloamCamera(parameters.p00_p11, parameters.size, parameters.orthographic != 0u);
}

// Whether a pixel has a surface to shade. shaded: written; complete only where the result is true.
bool shaded_at(ivec2 pixel, out Shaded shaded) {
    vec3 normal = GLOAM_FETCH(normal_image, pixel).xyz;
    shaded.position = gloam_camera_position(pixel, gloam_fetch_depth(pixel), this_camera());
    shaded.normal = gloam_safe_normalize(normal, vec3(0.0));
    shaded.turn = gloam_sincos(gloam_hash_rotation(pixel));
    if (!gloam_can_gather(shaded.position, normal, parameters.radius, this_camera())) return false;
    shaded.footprint = gloam_footprint(shaded.position, parameters.radius, this_camera());
    shaded.frame = gloam_tangent_frame(shaded.normal);
    return true;
}

// Tests one sample. point: of the unit half ball, z along the normal.
Sample sample_at(Shaded shaded, vec3 point) {
    vec3 along = shaded.frame * point;
    vec3 at = shaded.position + parameters.radius * along;
    ivec2 pixel = gloam_footprint_seen(shaded.footprint, at);
    bool counts = point != vec3(0.0) && at.z < 0.0;
    float depth = gloam_footprint_plane_depth(shaded.footprint, pixel, at, shaded.frame[2]);
    float seen = gloam_fetch_depth(pixel);
    bool blocked = counts && gloam_sample_blocked(depth, seen, parameters.bias, method_values.range);
    return Sample(gloam_safe_normalize(along, vec3(0.0)), blocked ? 0.0 : 1.0, pixel, counts);
}

// The sample of a sequence that all pixels share, rotated for each pixel. i: number of the sample, from 0.
Sample sample_of(Shaded shaded, uint i) {
    vec3 point = gloam_hemisphere_uniform(gloam_halton_3d(i + 1u));
    return sample_at(shaded, gloam_turn_hemisphere(point, shaded.turn));
}

// Defined by the pass: what it writes of a point.
vec4 written_at(Shaded shaded, ivec2 pixel);

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x >= parameters.size.x || pixel.y >= parameters.size.y) return;
    Shaded shaded;
    vec4 written = vec4(0.0);
    if (shaded_at(pixel, shaded)) written = written_at(shaded, pixel);
    imageStore(written_image, pixel, written);
}

#endif
