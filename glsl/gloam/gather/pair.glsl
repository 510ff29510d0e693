// SPDX-License-Identifier: MIT
#ifndef GLOAM_GATHER_PAIR_GLSL
#define GLOAM_GATHER_PAIR_GLSL

#include "gloam/gather/fetch.glsl"
#include "gloam/gather/footprint.glsl"
#include "gloam/gather/further_depths.glsl"
#include "gloam/geometry/height_at.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/occlusion/layers.glsl"

// Two opposite surface points at a time (CS-I, CS-P): if one of them is unusable, the other one represents both. The
// surface at a tap is moved parallel to the tangent plane onto the line along the view vector through the aimed
// position. Opposite taps of a bare plane are then opposite at any tilt, and at the border of the image.

// The depths at the two taps of a pair: every layer.
struct GloamPairDepths {
    ivec2 first_pixel;
    ivec2 second_pixel;
    vec4 first;   // of the layers, the nearest in x; 0 for none
    vec4 second;
};

// What a pair contributes.
struct GloamPairShare {
    float occluded;  // occlusion times weight
    float whole;     // weight; 0 for an unusable pair
};

// Background counts as a surface this many radii behind the shaded point.
const float GLOAM_PAIR_FAR = 1e4;

// Depths of all layers at a pixel.
vec4 gloam_pair_layers(ivec2 pixel, int layers) {
    return vec4(gloam_fetch_depth(pixel), abs(gloam_further_depths(pixel, layers)));
}

// The depths at two opposite taps. tap: of the unit disc, y as in the image.
GloamPairDepths gloam_pair_depths(GloamFootprint footprint, vec2 tap, int layers) {
    ivec2 first = gloam_footprint_pixel(footprint, tap);
    ivec2 second = gloam_footprint_pixel(footprint, -tap);
    return GloamPairDepths(first, second, gloam_pair_layers(first, layers), gloam_pair_layers(second, layers));
}

// Height of a tap's surface over an aimed position, along the view vector (gloam_height_at).
// depth: at the pixel. position, normal: of the shaded point, unit normal. facing: view . normal, at least 1e-4.
// Returns a length in world units. Error: 3e-7 of the offset over the facing.
float gloam_pair_height(GloamFootprint footprint, ivec2 pixel, float depth, vec3 aim, vec3 position, vec3 normal,
                        float facing, float radius) {
    float known = gloam_tap_sees(depth) ? depth : GLOAM_PAIR_FAR * radius - position.z;
    return gloam_height_at(gloam_footprint_position(footprint, pixel, known) - position, aim, normal, facing);
}

// The depths of one try. Layers are tried in order: first the visible surface at both taps, then each further layer at
// the first tap, then each at the second. At each tap the layer with which the pair blocks most is kept. A try has the
// kept depths, with the new layer at its tap.
// look: number of the try, from 0. stayed: kept depths at both taps.
// Returns depths at both taps; 0 at a tap without such a layer.
vec2 gloam_pair_look(GloamPairDepths depths, vec2 stayed, int look, int layers) {
    if (look == 0) return vec2(depths.first.x, depths.second.x);
    return look < layers ? vec2(gloam_layer_depth(depths.first.x, depths.first.yzw, look), stayed.y)
                         : vec2(stayed.x, gloam_layer_depth(depths.second.x, depths.second.yzw, look - layers + 1));
}

// Whether a try is kept: if it blocks at least as much. Equality suffices, because beside an unusable tap a new partner
// cannot block more until both are replaced.
// depths: of the try. found, most: contributions of the try and of the best one before it.
bool gloam_pair_stays(vec2 depths, int look, int layers, GloamPairShare found, GloamPairShare most) {
    if (look == 0) return true;
    bool seen = gloam_tap_sees(look < layers ? depths.x : depths.y);
    return seen && (most.whole > 0.0 ? found.occluded * most.whole >= most.occluded * found.whole : found.whole > 0.0);
}

#endif
