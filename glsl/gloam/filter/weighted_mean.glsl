// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTER_WEIGHTED_MEAN_GLSL
#define GLOAM_FILTER_WEIGHTED_MEAN_GLSL

#include "gloam/numeric/constants.glsl"

// A weighted mean of occlusion values being formed. The range of the values is kept as well: the quotient of two
// rounded sums may leave it, and with it a constant image would change, and a lone neighbour would not give its own
// value.
struct GloamWeightedMean {
    float sum;     // of weight times value
    float weight;  // sum of weights (K of TSSAO-10)
    float low;     // smallest value with a weight
    float high;    // largest value with a weight
};

// weighted mean of nothing (TSSAO-10-empty): `(0, 0)` [TSSAO, the quotient of eq 10].
// The mean of nothing: no weight, an empty range. Error: none.
GloamWeightedMean gloam_weighted_mean_empty() {
    return GloamWeightedMean(0.0, 0.0, 1.0, 0.0);
}

// one more value in a weighted mean (TSSAO-10-add): `(sum + w AO, K + w)` [TSSAO, the quotient of eq 10].
// mean: what was added so far. value: occlusion in [0, 1]. weight: >= 0.
// Returns the mean with the value; unchanged for a value outside [0, 1] or NaN and for a weight that is not positive
// and finite.
// Error: 1.5 ULP for each addition.
GloamWeightedMean gloam_weighted_mean_add(GloamWeightedMean mean, float value, float weight) {
    if (!(value >= 0.0 && value <= 1.0 && weight > 0.0 && weight <= GLOAM_LARGEST)) return mean;
    return GloamWeightedMean(mean.sum + weight * value, mean.weight + weight, min(mean.low, value),
                             max(mean.high, value));
}

// weighted mean, or what stands in for it (TSSAO-10-mean): `sum / K, the fallback for K < 1e-8` [TSSAO,
// the quotient of eq 10].
// The mean of the values added.
// mean: of weights below 1e30. fallback: what to return where the weights sum to less than 1e-8; taken to the nearer
// end outside [0, 1], NaN to 0.
// Returns the mean, between the smallest and the largest value, both included. Error: 2.5 ULP of the quotient.
float gloam_weighted_mean_value(GloamWeightedMean mean, float fallback) {
    if (mean.weight >= 1e-8) return clamp(mean.sum / mean.weight, mean.low, mean.high);
    return fallback > 0.0 ? (fallback < 1.0 ? fallback : 1.0) : 0.0;
}

#endif
