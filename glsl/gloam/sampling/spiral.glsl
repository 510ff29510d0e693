// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_SPIRAL_GLSL
#define GLOAM_SAMPLING_SPIRAL_GLSL

#include "gloam/sampling/circle.glsl"

// point of a spiral (SPIRAL-point): `a = (i + 1/2) / n; a (cos(2 pi a turns), sin(2 pi a turns))` [McGuire, Mara and
// Luebke 2012 (Scalable Ambient Obscurance)].
// Point of a spiral kernel (SAO): a = (index + 1/2) / count, radius a, angle 2 pi a turns.
// index: number of the tap, 0 to count - 1.
// count: number of taps, 1 to 32768.
// turns: turns of the spiral (7 for 9 taps; best coprime with count); negative turns run clockwise.
// Returns an offset in the unit disc: radii uniform, so the taps grow dense towards the centre. The zero vector for a
// count or an index outside its range. Error: 5e-7.
vec2 gloam_spiral_point(int index, int count, int turns) {
    if (count < 1 || count > 32768 || index < 0 || index >= count) return vec2(0.0);
    uint period = 2u * uint(count);
    uint odd = 2u * uint(index) + 1u;
    // The angle in units of 1 / period of a turn, its whole turns taken off in integers.
    uint angle = ((uint(abs(turns)) % period) * odd) % period;
    vec2 tap = gloam_circle_point(float(angle) / float(period));
    float radius = float(odd) / float(period);
    return radius * vec2(tap.x, turns < 0 ? -tap.y : tap.y);
}

#endif
