// SPDX-License-Identifier: MIT
#ifndef GLOAM_SHADING_REMAP_GLSL
#define GLOAM_SHADING_REMAP_GLSL

// visibility remapped by offset, brightness and contrast (CS-REMAP): `clamp((b (v + a))^c, 0, 1)` [Aalund and
// Baerentzen 2013].
// ao: v, visibility in [0, 1], 1 = open. a: offset; 0.5 undoes the self-occlusion of methods that sample a whole
// sphere, else 0.
// b: brightness, 1. c: contrast, 1 (larger is darker).
// Returns visibility in [0, 1]. A base b (v + a) of 0 or less gives 0, but 1 for c < 0, where the power is infinite.
// c = 0 gives 1 whatever the base. NaN in any argument gives 1. c = 1 gives the base itself.
// Error: 2e-6 for |c| up to 16; by any device that keeps Vulkan's rules for pow(), 6e-6, most where the base is just
// below 1.
float gloam_remap(float ao, float a, float b, float c) {
    float base = b * (ao + a);
    if (!(base > 0.0)) return base <= 0.0 && c > 0.0 ? 0.0 : 1.0;
    // Where the power is 1 or more, pow() is not asked: its error would show most there.
    bool open = c > 0.0 ? base >= 1.0 : (c < 0.0 ? base <= 1.0 : true);
    if (open) return 1.0;
    return c == 1.0 ? base : clamp(pow(base, c), 0.0, 1.0);
}

#endif
