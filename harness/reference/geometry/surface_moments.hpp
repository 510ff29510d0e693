// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

struct GloamSurfaceMoments {
    double weight;
    dvec3 mean;
    dvec3 variance;
    dvec3 covariance;  // yz, zx, xy
};

inline GloamSurfaceMoments gloam_moments_empty() {
    return {0.0, dvec3(0.0), dvec3(0.0), dvec3(0.0)};
}

inline GloamSurfaceMoments gloam_moments_of(dvec3 point) {
    return {1.0, point, dvec3(0.0), dvec3(0.0)};
}

// By the moments about the first mean: E[(x - m)(y - m)] less the product of the means.
inline GloamSurfaceMoments gloam_moments_add(const GloamSurfaceMoments& a, const GloamSurfaceMoments& b) {
    if (!(b.weight > 0.0)) return a;
    if (!(a.weight > 0.0)) return b;
    const double weight = a.weight + b.weight;
    const dvec3 apart = b.mean - a.mean;
    const dvec3 mean = b.weight * apart / weight;  // about a.mean
    const dvec3 squares = (a.weight * a.variance + b.weight * (b.variance + apart * apart)) / weight;
    const dvec3 crossed(apart.y * apart.z, apart.z * apart.x, apart.x * apart.y);
    const dvec3 products = (a.weight * a.covariance + b.weight * (b.covariance + crossed)) / weight;
    return {weight, a.mean + mean, squares - mean * mean,
            products - dvec3(mean.y * mean.z, mean.z * mean.x, mean.x * mean.y)};
}

// n^T C n.
inline double gloam_moments_along(const GloamSurfaceMoments& moments, dvec3 direction) {
    const dvec3& v = moments.variance;
    const dvec3& c = moments.covariance;
    const glm::dmat3 matrix{{v.x, c.z, c.y}, {c.z, v.y, c.x}, {c.y, c.x, v.z}};
    const double along = dot(direction, matrix * direction);
    return along > 0.0 ? along : 0.0;
}

}  // namespace gloam::reference
