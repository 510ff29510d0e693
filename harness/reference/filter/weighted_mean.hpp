// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

struct GloamWeightedMean {
    double sum;
    double weight;
    double low;
    double high;
};

inline GloamWeightedMean gloam_weighted_mean_empty() {
    return {0.0, 0.0, 1.0, 0.0};
}

inline GloamWeightedMean gloam_weighted_mean_add(const GloamWeightedMean& mean, double value, double weight) {
    if (!(value >= 0.0 && value <= 1.0 && weight > 0.0 && is_finite(weight))) return mean;
    return {mean.sum + weight * value, mean.weight + weight, min(mean.low, value), max(mean.high, value)};
}

inline double gloam_weighted_mean_value(const GloamWeightedMean& mean, double fallback) {
    if (mean.weight >= 1e-8) return clamp(mean.sum / mean.weight, mean.low, mean.high);
    return gloam_unit_interval(fallback);
}

}  // namespace gloam::reference
