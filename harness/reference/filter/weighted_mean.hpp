// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
struct GloamWeightedMean {
    T sum;
    T weight;
    T low;
    T high;
};

template <class T = double>
GloamWeightedMean<T> gloam_weighted_mean_empty() {
    return GloamWeightedMean<T>{T(0), T(0), T(1), T(0)};
}

template <class T>
GloamWeightedMean<T> gloam_weighted_mean_add(GloamWeightedMean<T> mean, T value, T weight) {
    if (!(value >= T(0) && value <= T(1) && weight > T(0) && weight <= float_max<T>())) return mean;
    return GloamWeightedMean<T>{mean.sum + weight * value, mean.weight + weight, min(mean.low, value),
                                max(mean.high, value)};
}

template <class T>
T gloam_weighted_mean_value(GloamWeightedMean<T> mean, T fallback) {
    if (mean.weight >= T(1e-8)) return clamp(mean.sum / mean.weight, mean.low, mean.high);
    return fallback > T(0) ? (fallback < T(1) ? fallback : T(1)) : T(0);
}

}  // namespace gloam::reference
