// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTER_UPSAMPLE_GLSL
#define GLOAM_FILTER_UPSAMPLE_GLSL

// Occlusion of a full-size pixel from the half-size pixels around it, by depth alone. Of a plane, the reciprocal of the
// depth is linear in the image of a perspective camera, and the depth itself in that of an orthographic one. So two
// pixels show the plane of a third one in their middle if its depth is the mean of theirs in this sense.

#include "gloam/geometry/background.glsl"
#include "gloam/sampling/unit_interval.glsl"

// Relative difference from that mean, up to which depths are of one surface.
const float GLOAM_UPSAMPLE_TOLERANCE = 0.006;

// whether a surface continues through two pixels around another (UPSAMPLE-continues): `|(d / a + d / b) / 2 - 1| <=
// 0.006; orthographic |(a + b) / (2 d) - 1| <= 0.006` [derived].
// Whether the surface of a pixel continues through two pixels on opposite sides of it, equally far away:
// |(depth / first + depth / second) / 2 - 1| <= 0.006 (perspective), |(first + second) / (2 depth) - 1| <= 0.006
// (orthographic).
// depth: eye-linear, of the pixel. first, second: of the other two, in the same unit.
// Returns false if one of them is background. Error: none, but for a mean within rounding of the tolerance.
bool gloam_upsample_continues(float depth, float first, float second, bool orthographic) {
    if (gloam_is_background(depth) || gloam_is_background(first) || gloam_is_background(second)) return false;
    float mean = orthographic ? 0.5 * (first / depth) + 0.5 * (second / depth)
                              : 0.5 * (depth / first) + 0.5 * (depth / second);
    return abs(mean - 1.0) <= GLOAM_UPSAMPLE_TOLERANCE;
}

// value of the pixel nearest in depth (UPSAMPLE-nearest): `v_i where |d_i - d| is least` [derived].
// The value of that of four pixels whose depth is nearest to a depth; of equally near ones the first.
// depth: eye-linear, not background. depths: of the four, in the same unit. values: theirs.
// Returns 0 if all four are background. Error: none, but for distances equal within rounding.
float gloam_upsample_nearest(float depth, vec4 depths, vec4 values) {
    float none = gloam_background_depth();
    vec4 apart = vec4(gloam_is_background(depths.x) ? none : abs(depths.x - depth),
                      gloam_is_background(depths.y) ? none : abs(depths.y - depth),
                      gloam_is_background(depths.z) ? none : abs(depths.z - depth),
                      gloam_is_background(depths.w) ? none : abs(depths.w - depth));
    float least = min(min(apart.x, apart.y), min(apart.z, apart.w));
    if (!(least < none)) return 0.0;
    if (apart.x <= least) return values.x;
    if (apart.y <= least) return values.y;
    return apart.z <= least ? values.z : values.w;
}

// occlusion of a full-size pixel from half-size pixels (UPSAMPLE): `mean of the opposite pairs through which the
// surface continues, else the nearest in depth` [derived].
// gloam_upsample_continues tells which pairs those are. A constant occlusion stays as it is.
// depth: eye-linear, of the full-size pixel. depths, occlusions: of the half-size pixels; x and w are opposite, and so
// are y and z. Between two half-size pixels a and b: (a, b, a, b).
// Returns a value in [0, 1]; 0 at the background, where all four are background, and for NaN. Error: 1.2e-7, but for
// decisions within rounding.
float gloam_upsample(float depth, vec4 depths, vec4 occlusions, bool orthographic) {
    if (gloam_is_background(depth)) return 0.0;
    float xw = 0.5 * (occlusions.x + occlusions.w);
    float yz = 0.5 * (occlusions.y + occlusions.z);
    bool along_xw = gloam_upsample_continues(depth, depths.x, depths.w, orthographic);
    bool along_yz = gloam_upsample_continues(depth, depths.y, depths.z, orthographic);
    if (along_xw && along_yz) return gloam_unit_interval(0.5 * (xw + yz));
    if (along_xw) return gloam_unit_interval(xw);
    if (along_yz) return gloam_unit_interval(yz);
    return gloam_unit_interval(gloam_upsample_nearest(depth, depths, occlusions));
}

#endif
