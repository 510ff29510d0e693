// SPDX-License-Identifier: MIT
#pragma once

#include "reference/filter/gaussian.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_separable_mean(double along_u, double along_v) {
    return (gloam_unit_interval(along_u) + gloam_unit_interval(along_v)) / 2.0;
}

inline double gloam_separable_weight(dvec3 offset, dvec3 normal, double sigma, double tolerance) {
    return abs(dot(offset, normal)) <= tolerance ? gloam_gaussian(dot(offset, offset), sigma) : 0.0;
}

}  // namespace gloam::reference
