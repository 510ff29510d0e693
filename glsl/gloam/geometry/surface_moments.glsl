// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_SURFACE_MOMENTS_GLSL
#define GLOAM_GEOMETRY_SURFACE_MOMENTS_GLSL

// Mean and variance of the surface points of several pixels, for methods that take one sample of an area: of a plane
// they say exactly where it is and that nothing stands out of it.
struct GloamSurfaceMoments {
    float weight;     // pixels with a surface; 0: nothing else is meant
    vec3 mean;        // of their positions, world units
    vec3 variance;    // of x, y, z, world units squared
    vec3 covariance;  // of (y, z), (z, x), (x, y), world units squared
};

// moments of no surface point (MOMENTS-empty): `weight 0` [definition].
// Of no pixel. Returns a weight of 0 and zeros. Error: none.
GloamSurfaceMoments gloam_moments_empty() {
    return GloamSurfaceMoments(0.0, vec3(0.0), vec3(0.0), vec3(0.0));
}

// moments of one surface point (MOMENTS-of): `weight 1, its mean, no variance` [definition].
// Of one pixel. point: its surface, any space, world units, finite. Returns its moments. Error: none.
GloamSurfaceMoments gloam_moments_of(vec3 point) {
    return GloamSurfaceMoments(1.0, point, vec3(0.0), vec3(0.0));
}

// moments of two groups of surface points (MOMENTS-add): `m = m_a + t d;  C = (1 - t) C_a + t C_b + t (1 - t) d d^T,  d
// = m_b - m_a,  t = w_b / w` [Chan, Golub and LeVeque 1979].
// Of all pixels of two groups (Chan, Golub and LeVeque 1979): the mean of both, and as variance the mean of both plus
// what the means lie apart. Sums of squares would lose the variance in the digits of the distance from the eye.
// a, b: finite; weights of at least 2^-10, or 0: then the rest is not read.
// Returns the moments of both; those of the other for a weight of 0. Error: 4 ULP of the weight, 3e-7 of the
// larger mean, 1e-6 of the larger of the variances and the squared distance of the means.
GloamSurfaceMoments gloam_moments_add(GloamSurfaceMoments a, GloamSurfaceMoments b) {
    if (!(b.weight > 0.0)) return a;
    if (!(a.weight > 0.0)) return b;
    float weight = a.weight + b.weight;
    float part = b.weight / weight;
    float spread = part * (a.weight / weight);
    vec3 apart = b.mean - a.mean;
    vec3 mean = a.mean + part * apart;
    vec3 variance = a.variance + part * (b.variance - a.variance) + spread * (apart * apart);
    vec3 covariance = a.covariance + part * (b.covariance - a.covariance) + spread * (apart.yzx * apart.zxy);
    return GloamSurfaceMoments(weight, mean, variance, covariance);
}

// variance of surface points along a direction (MOMENTS-along): `max(n^T C n, 0)` [definition].
// moments: finite. direction: n, unit, the same space.
// Returns a variance in world units squared, >= 0: what rounding takes below is 0, and so is NaN. Error: 1e-6 of the
// largest of the variances.
float gloam_moments_along(GloamSurfaceMoments moments, vec3 direction) {
    float along = dot(moments.variance, direction * direction) +
                  2.0 * dot(moments.covariance, direction.yzx * direction.zxy);
    return along > 0.0 ? along : 0.0;
}

#endif
