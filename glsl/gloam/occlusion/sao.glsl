// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_SAO_GLSL
#define GLOAM_OCCLUSION_SAO_GLSL

// contribution of a surface point (CS-Q): `5 sigma (1 - v^2 / r^2)^3 max(v . n - bias, 0) / (v^2 + epsilon), |v| < r`
// [McGuire, Mara and Luebke 2012 (Scalable Ambient Obscurance)].
// offset: v = s - p, view space, world units. normal: n, unit vector, same space. radius: r, world units. bias: world
// units. epsilon: world units squared, > 0. scale: 5 sigma, world units: sigma is the paper's intensity.
// Returns a contribution >= 0, whose mean is the occlusion; 0 at and beyond the radius, below the plane raised by the
// bias, and for NaN. Error: 7e-7 of the scale over the root of epsilon.
float gloam_contribution_sao(vec3 offset, vec3 normal, float radius, float bias, float epsilon, float scale) {
    float squared = dot(offset, offset);
    float window = 1.0 - squared / (radius * radius);
    float above = dot(offset, normal) - bias;
    if (!(window > 0.0 && above > 0.0)) return 0.0;
    return scale * window * window * window * (above / (squared + epsilon));
}

#endif
