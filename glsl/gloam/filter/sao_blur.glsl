// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTER_SAO_BLUR_GLSL
#define GLOAM_FILTER_SAO_BLUR_GLSL

// weight of a tap of SAO's blur (CS-Q-blur): `(0.3 + g_r) max(0, 1 - slope |dkey|)` [McGuire, Mara and Luebke 2012
// (Scalable Ambient Obscurance)].
// Weight of a tap of SAO's blur, along one axis: (0.3 + g_r) max(0, 1 - slope |key difference|), g_0 at the centre;
// the taps are two pixels apart. g is a Gaussian of standard deviation 3 taps, normalised over its nine taps (the
// reference shader says 2).
// tap: r, number of the tap, -4 to 4. key_difference: of the tap's depth key to the centre's. slope: per unit of key,
// >= 0: 2000 times the edge sharpness; negative counts as 0.
// Returns a weight in [0, 0.445]; 0 for a tap outside its range, and off the centre where slope |key difference| is
// NaN.
// Error: 2e-7, and that of slope |key difference| times 0.445.
float gloam_sao_blur_weight(int tap, float key_difference, float slope) {
    if (tap == 0) return 0.153170;
    if (tap > 4 || tap < -4) return 0.0;
    int r = abs(tap);
    float g = r == 1 ? 0.144893 : (r == 2 ? 0.122649 : (r == 3 ? 0.092902 : 0.062970));
    float difference = abs(key_difference);
    float fall = difference == 0.0 || slope <= 0.0 ? 0.0 : difference * slope;
    return fall < 1.0 ? (0.3 + g) * (1.0 - fall) : 0.0;
}

#endif
