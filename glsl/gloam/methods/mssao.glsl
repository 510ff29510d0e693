// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_MSSAO_GLSL
#define GLOAM_METHODS_MSSAO_GLSL

#include "gloam/filter/resolution.glsl"
#include "gloam/filter/weights.glsl"
#include "gloam/gather/method.glsl"
#include "gloam/gather/pixels.glsl"
#include "gloam/occlusion/disc_taps.glsl"

// Multi-resolution ambient occlusion (Hoang and Low 2010, 2012): surface points under small discs at several
// resolutions, each disc twice as wide as the one before. Passes prepare the coarser resolutions
// (preparation/mssao_surface.comp, mssao_level.comp). The method itself computes the finest.
struct GloamMssao {
    uint resolutions;  // 1 to 9
};

// What gloam_fetch_prepared reads: surfaces at ever smaller resolutions, and their results, in one image
// (gloam/gather/pixels.glsl): positions, normals and results.
const int GLOAM_PYRAMID_POSITIONS = 0;
const int GLOAM_PYRAMID_NORMALS = 1;
const int GLOAM_PYRAMID_RESULTS = 2;

// Most resolutions that an image needs: the texels of the coarsest one are 256 pixels wide.
const uint GLOAM_MOST_RESOLUTIONS = 9u;

// The last level of a number of resolutions, 0 for one.
int gloam_coarsest_level(uint resolutions) {
    return int(clamp(resolutions, 1u, GLOAM_MOST_RESOLUTIONS)) - 1;
}

// Position of the surface that a texel stands for, view space, world units; the zero vector for background.
vec3 gloam_pyramid_position(ivec2 texel, int level, GloamCamera camera) {
    if (level > 0)
        return gloam_fetch_prepared(gloam_pyramid_texel(texel, level, camera.size, GLOAM_PYRAMID_POSITIONS)).xyz;
    float depth = gloam_fetch_depth(texel);
    return gloam_is_background(depth) ? vec3(0.0) : gloam_camera_position(texel, depth, camera);
}

// One resolution of MSSAO, any of them: a kernel of few texels, then the results of the coarser ones.

// Texels that a kernel reaches at most.
const float GLOAM_MSSAO_REACH = 6.0;
// Height over the tangent plane, as a fraction of the radius, at which a coarser texel counts half to the power below.
const float GLOAM_MSSAO_HEIGHT = 0.05;
const float GLOAM_MSSAO_HEIGHT_POWER = 2.0;
const float GLOAM_MSSAO_NORMAL_POWER = 8.0;

// What is known of a surface: from its own level and the coarser ones.
struct GloamLevels {
    float largest;  // occlusion of all levels
    float mean;     // of it
    float count;    // levels in the mean; one whose kernel is hardly a texel counts less
};

// Texels from the point to the edge of its kernel, along both axes, and the weight of the level's result. The weight
// is 1, but less between 2 texels and 1, because on coarser levels the kernel then comes to lie within its own texel.
vec3 gloam_mssao_reach(GloamFootprint footprint, int level) {
    vec2 texels = footprint.reach * footprint.size / float(1 << level);
    float largest = max(texels.x, texels.y);
    float share = level == 0 ? 1.0 : clamp(largest - 1.0, 0.0, 1.0);
    return vec3(largest > GLOAM_MSSAO_REACH ? texels * (GLOAM_MSSAO_REACH / largest) : texels, share);
}

// Occlusion of one level.
// position, normal: of the surface; unit normal. center: where it is, texels of the level. reach: texels.
float gloam_mssao_occlusion(vec3 position, vec3 normal, vec2 center, vec2 reach, int level, GloamCamera camera,
                            GloamKernel kernel) {
    vec2 accumulated = vec2(0.0);
    vec2 last = vec2(gloam_level_size(camera.size, level) - 1);
    vec2 turn = gloam_sincos_turns(gloam_turns(kernel.angle));
    for (uint i = 0u; i < kernel.count; ++i) {
        vec2 at = center + reach * gloam_turn_disc(gloam_disc_point(kernel.first + i + 1u).xy, turn);
        vec3 seen = gloam_pyramid_position(ivec2(clamp(at, vec2(0.0), last)), level, camera);
        vec3 offset = seen - position;
        float contribution =
            dot(offset, normal) > kernel.bias ? gloam_contribution_mssao(offset, normal, kernel.radius) : 0.0;
        accumulated = gloam_estimator_add(accumulated, seen.z < 0.0 ? contribution : 0.0);
    }
    return gloam_estimator_mean(accumulated);
}

// The levels from `level` on at a surface: those of the four texels around it, as far as they lie on it. Nothing for
// one beyond the coarsest.
// center: where the surface is, pixels of the full image.
GloamLevels gloam_mssao_upsampled(vec3 position, vec3 normal, vec2 center, int level, GloamCamera camera, float radius,
                                  int coarsest) {
    if (level > coarsest) return GloamLevels(0.0, 0.0, 0.0);
    vec2 at = center / float(1 << level) - 0.5;
    ivec2 first = ivec2(floor(at));
    ivec2 last = gloam_level_size(camera.size, level) - 1;
    GloamWeightedMean largest = gloam_weighted_mean_empty();
    GloamWeightedMean mean = gloam_weighted_mean_empty();
    GloamWeightedMean count = gloam_weighted_mean_empty();
    for (int i = 0; i < 4; ++i) {
        ivec2 texel = first + ivec2(i & 1, i >> 1);
        if (texel != clamp(texel, ivec2(0), last)) continue;
        vec3 other = gloam_pyramid_position(texel, level, camera);
        if (!(other.z < 0.0)) continue;
        vec2 share = 1.0 - abs(vec2(texel) - at);
        vec3 facing = gloam_fetch_prepared(gloam_pyramid_texel(texel, level, camera.size, GLOAM_PYRAMID_NORMALS)).xyz;
        float height = dot(other - position, normal) / (GLOAM_MSSAO_HEIGHT * radius);
        float weight = gloam_mssao_upsample_weight(share.x * share.y, height, dot(facing, normal),
                                                   GLOAM_MSSAO_HEIGHT_POWER, GLOAM_MSSAO_NORMAL_POWER);
        vec3 known = gloam_fetch_prepared(gloam_pyramid_texel(texel, level, camera.size, GLOAM_PYRAMID_RESULTS)).xyz;
        float levels = float(coarsest + 1 - level);
        largest = gloam_weighted_mean_add(largest, known.x, weight);
        mean = gloam_weighted_mean_add(mean, known.y, weight);
        count = gloam_weighted_mean_add(count, known.z / levels, weight);
    }
    return GloamLevels(gloam_weighted_mean_value(largest, 0.0), gloam_weighted_mean_value(mean, 0.0),
                       gloam_weighted_mean_value(count, 0.0) * float(coarsest + 1 - level));
}

// A surface at one level, with the coarser ones.
// position: view space, world units, in front of the eye. normal: unit.
GloamLevels gloam_mssao_at(vec3 position, vec3 normal, int level, GloamCamera camera, GloamKernel kernel,
                           int coarsest) {
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    vec2 center = footprint.center * footprint.size;
    vec3 reach = gloam_mssao_reach(footprint, level);
    float own = reach.z == 0.0 ? 0.0
                               : gloam_mssao_occlusion(position, normal, center / float(1 << level), reach.xy, level,
                                                       camera, kernel);
    GloamLevels coarser = gloam_mssao_upsampled(position, normal, center, level + 1, camera, kernel.radius, coarsest);
    float count = reach.z + coarser.count;
    float mean = count > 0.0 ? (reach.z * own + coarser.count * coarser.mean) / count : 0.0;
    return GloamLevels(max(reach.z * own, coarser.largest), clamp(mean, 0.0, 1.0), count);
}

// surface points under discs at several resolutions (METHOD-mssao): `1 - (1 - max) (1 - mean) of the resolutions`
// [Hoang and Low 2012, CS-F].
// All samples of one pixel in one frame: kernel.count at every resolution. Error: that of the levels.
GloamEstimate gloam_mssao(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMssao settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamLevels levels = gloam_mssao_at(position, n, 0, camera, kernel, gloam_coarsest_level(settings.resolutions));
    return GloamEstimate(gloam_mssao_combine(levels.largest, levels.mean), float(kernel.count), 1.0);
}

#endif
