// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_CLOSED_MARCH_GLSL
#define GLOAM_OCCLUSION_CLOSED_MARCH_GLSL

#include "gloam/geometry/slice.glsl"
#include "gloam/numeric/square_root.glsl"

// Which taps of a march along a slice can still change its result. The others may be skipped: the result is then the
// same to the bit.

// how near to the view axis the taps of a slice may see something (SLICE-clearance): `s -> (1 - B / D) (s a - b) / (1 +
// R / D (sqrt(1 - a^2) + b))` [derived from the rays of pixels beside the slice].
// How near to the view axis the taps of a slice through the eye may see a point of a ball. A tap is aimed at the share
// s of the radius, in the plane parallel to the image, and its point is moved into the slice (gloam_into_slice). It
// then sees no point of the ball nearer to the axis than x s - y radii. The reason: its ray passes the aim within half
// a pixel, and the points of the ball are at least |position| - ball radius from the eye.
// position: of the shaded point, view space, world units. direction: of the slice in the image, unit, y as in view
// space. end: of the march to that side, texture coordinates. pixels: half-axes of the radius in the image. radius:
// world units, of the march. ball: radius of the ball around the point, as part of that, [0, 1].
// Returns (x, y), x in [0, 1], y >= 0, of which 2e-4 for the rounding of positions. Returns (0, 0), nothing known, for
// an end outside the image (taps there are moved) and for a slice that nearly lies in the tangent plane. The same for a
// point nearer than 2 radii or further than 128, for a radius of about a pixel, and for NaN. Error: 8e-7.
vec2 gloam_slice_clearance(GloamSlice slice, vec3 position, vec2 direction, vec2 end, vec2 pixels, float radius,
                           float ball) {
    bool inside = all(greaterThanEqual(end, vec2(0.0))) && all(lessThanEqual(end, vec2(1.0)));
    if (!(inside && ball >= 0.0 && ball <= 1.0)) return vec2(0.0);
    float squared = slice.weight * slice.weight;
    // A little more than half a pixel, texture coordinates being rounded; and what it is moved by in the slice, along
    // the tangent plane.
    float beside = 0.52 * length(1.0 / pixels) * (1.0 + gloam_sqrt((1.0 - squared) / squared));
    float ratio = radius / length(position);
    float along = abs(dot(direction, slice.tangent.xy));
    if (!(ratio <= 0.5 && ratio >= 0.0078125 && squared >= 0.1 && beside <= 0.9 && along <= 1.001)) return vec2(0.0);
    float nearer = (1.0 - ball * ratio) / (1.0 + ratio * (gloam_sqrt(1.0 - along * along) + beside));
    return vec2(nearer * along, nearer * beside + 2e-4);
}

// taps of a side of a slice that may see something within a ball (SLICE-taps): `ceil(n sqrt((b + y) / x) - jitter), at
// most n` [definition].
// They are the first ones.
// clearance: of gloam_slice_clearance, for that ball. ball: its radius as part of that of the march; 0 or less:
// nothing there counts.
// jitter, steps: tap i is aimed at the share ((i + jitter) / steps)^2 of the radius.
// Returns a number up to steps: 0 for ball <= 0, all of them for a ball of 1 or more and where nothing is known.
// Error: none, but for a tap within rounding of the ball.
uint gloam_slice_taps(vec2 clearance, float ball, float jitter, uint steps) {
    if (ball <= 0.0) return 0u;
    if (!(ball < 1.0 && clearance.x > 0.0)) return steps;
    float end = float(steps) * gloam_sqrt((ball + clearance.y) / clearance.x) - jitter;
    return end < float(steps) ? uint(max(ceil(end), 0.0)) : steps;
}

#endif
