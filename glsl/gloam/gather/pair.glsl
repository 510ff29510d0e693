// SPDX-License-Identifier: MIT
#ifndef GLOAM_GATHER_PAIR_GLSL
#define GLOAM_GATHER_PAIR_GLSL

#include "gloam/gather/footprint.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/occlusion/layers.glsl"

// Two opposite surface points at a time (CS-I, CS-P): where one of them tells nothing, the other stands for both.

// Defined by the user: eye-linear depth of a pixel inside the image, world units.
float gloam_fetch_depth(ivec2 pixel);

// Defined by the user: depths of the layers behind that, negative where seen from behind, 0 where there is none; read
// where the kernel has more than one layer.
vec3 gloam_fetch_layers(ivec2 pixel);

// Two opposite taps. The surface seen at a tap is moved along the tangent plane to the place that was aimed at, on the
// line along the view vector: opposite taps of a bare plane are then opposite at any tilt, and at the border of the
// image.
struct GloamPair {
    vec3 aim;     // from the shaded point to the place of the first tap, in the plane of the image; the second is
                  // opposite; world units
    float first;  // height of the surface over the disc parallel to the image, towards the eye, at the first tap, world
                  // units
    float second;   // likewise at the second
};

// What the two taps of a pair may see: every layer.
struct GloamPairDepths {
    ivec2 first_pixel;
    ivec2 second_pixel;
    vec4 first;   // of the layers, the nearest in x; 0 for none
    vec4 second;
};

// What a pair contributes.
struct GloamPairShare {
    float occluded;  // occlusion times weight
    float whole;     // weight; 0 for a pair that tells nothing
};

// Background counts as a surface this many radii behind the shaded point.
const float GLOAM_PAIR_FAR = 1e4;

// Depths of all layers at a pixel.
vec4 gloam_pair_layers(ivec2 pixel, int layers) {
    vec3 further = layers > 1 ? abs(gloam_fetch_layers(pixel)) : vec3(0.0);
    return vec4(gloam_fetch_depth(pixel), further);
}

// tap: of the unit disc, y as in the image.
GloamPairDepths gloam_pair_depths(GloamFootprint footprint, vec2 tap, int layers) {
    ivec2 first = gloam_footprint_pixel(footprint, tap);
    ivec2 second = gloam_footprint_pixel(footprint, -tap);
    return GloamPairDepths(first, second, gloam_pair_layers(first, layers), gloam_pair_layers(second, layers));
}

// How far along the view vector from an aimed place the surface lies that is as high over the tangent plane as what
// is seen at a pixel.
// depth: at the pixel. position, normal: of the shaded point, unit normal. facing: view . normal, at least 1e-4.
// Returns a length in world units, ((s - p - aim) . n) / facing: gloam_height_at. Error: 3e-7 of the offset over the
// facing.
float gloam_pair_height(GloamFootprint footprint, ivec2 pixel, float depth, vec3 aim, vec3 position, vec3 normal,
                        float facing, float radius) {
    float known = gloam_tap_sees(depth) ? depth : GLOAM_PAIR_FAR * radius - position.z;
    return dot(gloam_footprint_position(footprint, pixel, known) - position - aim, normal) / facing;
}

// Depth of a layer at a tap. layer: 0 to 3.
float gloam_pair_layer(vec4 depths, int layer) {
    return gloam_layer_depth(depths.x, depths.yzw, layer);
}

// Layers are tried one after the other: first what the eye sees at both taps, then each further one at the first tap,
// then at the second; of each tap the one stays with which the pair blocks most. This says which depths a try has:
// those that stayed, but for the new one.
// look: number of the try, from 0. stayed: depths at both taps.
// Returns depths at both taps; 0 at a tap that has no such layer.
vec2 gloam_pair_look(GloamPairDepths depths, vec2 stayed, int look, int layers) {
    if (look == 0) return vec2(depths.first.x, depths.second.x);
    return look < layers ? vec2(gloam_pair_layer(depths.first, look), stayed.y)
                         : vec2(stayed.x, gloam_pair_layer(depths.second, look - layers + 1));
}

// Whether a try is to stay. As much is taken too: beside a tap that tells nothing its partner cannot tell more
// either, until both are replaced.
// depths: of the try. found, most: what it and the best before it contribute.
bool gloam_pair_stays(vec2 depths, int look, int layers, GloamPairShare found, GloamPairShare most) {
    if (look == 0) return true;
    bool seen = gloam_tap_sees(look < layers ? depths.x : depths.y);
    return seen && (most.whole > 0.0 ? found.occluded * most.whole >= most.occluded * found.whole : found.whole > 0.0);
}

#endif
