// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

struct GloamWeightedMean {
    double sum;
    double weight;
    double low;
    double high;
};

inline GloamWeightedMean gloam_weighted_mean_empty() {
    return GloamWeightedMean{0.0, 0.0, 1.0, 0.0};
}

inline GloamWeightedMean gloam_weighted_mean_add(GloamWeightedMean mean, double value, double weight) {
    if (!(value >= 0.0 && value <= 1.0 && weight > 0.0 && weight <= float_max)) return mean;
    return GloamWeightedMean{mean.sum + weight * value, mean.weight + weight, min(mean.low, value),
                             max(mean.high, value)};
}

inline double gloam_weighted_mean_value(GloamWeightedMean mean, double fallback) {
    if (mean.weight >= 1e-8) return clamp(mean.sum / mean.weight, mean.low, mean.high);
    return fallback > 0.0 ? (fallback < 1.0 ? fallback : 1.0) : 0.0;
}

}  // namespace gloam::reference
