// SPDX-License-Identifier: MIT
#ifndef GLOAM_TEMPORAL_FRAME_HISTORY_GLSL
#define GLOAM_TEMPORAL_FRAME_HISTORY_GLSL

// The history of the frame, behind its filter: two means of the filtered occlusion, and how many frames the slow one
// has. The fast one follows what changes; the slow one is kept near to it.

// where a pixel's point was in the frame before (FRAME-before): `(u d', v d', d') = (x m0 + y m1 + m2) d + m3;
// orthographic (u, v, d') = x m0 + y m1 + m2 + d m3` [TSSAO, eqs 6 and 7, with both cameras in m].
// pixel: (x, y), its column and row; 0 is the centre of the first one. depth: d, > 0. m: columns m0 to m3.
// Returns (u, v, d'): place in the image, 0 to 1, and depth. Trusts the caller that d' > 0, or that (u, v) is not used.
// Error: 5e-6, in an image of 100 x 100 pixels for depths to 10.
vec3 gloam_frame_before(vec2 pixel, float depth, mat4x3 m, bool orthographic) {
    vec3 ray = m[0] * pixel.x + (m[1] * pixel.y + m[2]);
    if (orthographic) return ray + m[3] * depth;
    vec3 before = ray * depth + m[3];
    return vec3(before.xy / before.z, before.z);
}

// whether the frame before did not show a point (FRAME-moved): `min(d, f) < (1 - t) min(d_i, f) or min(d, f) > (1 + t)
// max d_i` [gloam; TSSAO, eq 8].
// It has moved, or it was hidden, or it is background that something has left.
// depth: d, that it had in that frame. before: d_i > 0, of the four pixels around. far: f; depth from there on is that
// of background. tolerance: t, in [0, 1). A difference within rounding of the tolerance may fall to either side.
bool gloam_frame_moved(float depth, vec4 before, float far, float tolerance) {
    float least = min(min(before.x, before.y), min(before.z, before.w));
    float most = max(max(before.x, before.y), max(before.z, before.w));
    float own = min(depth, far);
    return own < (1.0 - tolerance) * min(least, far) || own > (1.0 + tolerance) * most;
}

// mean with less of its neighbours (FRAME-sharp): `(s1 - p (s1 - s0)) / (w1 - p (w1 - w0))` [gloam].
// own: (s0, w0), sums of weighted occlusion and of weights, of the pixel itself. all: (s1, w1), of its neighbours, too.
// part: p, of the neighbours' weights that is left out, in [0, 1].
// Returns a mean; trusts the caller that the weights' sum is > 0. Error: 1.5e-6.
float gloam_frame_sharp(vec2 own, vec2 all, float part) {
    vec2 sum = all - part * (all - own);
    return sum.x / sum.y;
}

// history with a new frame (FRAME-blend): `f = f' + max(w, 0.7) (F - f'); m = c + w (C - c), c = clamp(m', f - r, f +
// r), w = 1 / (n + 1)` [gloam; TSSAO, eq 5].
// mean: m', of n frames. fast: f'. weight: w. fresh: C, of this frame. filtered: F, the same with less noise. range: r,
// how far the mean may be from the fast one, which follows what changes.
// Returns (m, f); trusts the caller to have all in [0, 1]. Error: 4e-7.
vec2 gloam_frame_blend(float mean, float fast, float weight, float fresh, float filtered, float range) {
    float quick = fast + max(weight, 0.7) * (filtered - fast);
    float kept = clamp(mean, quick - range, quick + range);
    return vec2(kept + weight * (fresh - kept), quick);
}

#endif
