// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_INVALIDATION_GLSL
#define GLOAM_PASSES_INVALIDATION_GLSL

#include "gloam/temporal/invalidation.glsl"

// What a changed neighbourhood leaves of a history (TSSAO-SI); values of the setting `invalidation`.
const uint INVALIDATION_CLAMP = 1u;
const uint INVALIDATION_CONFIDENCE = 2u;

// Weight that a history keeps.
// weight: samples. seen: the largest change of a distance, world units. radius: of influence, world units.
// invalidation: 0 nothing is lost, 1 at most weight_small samples count, 2 by confidence. tolerance: change up to which
// it is rounding, world units. factor: S of the confidence, per radius of change.
float invalidated_weight(float weight, float seen, float radius, uint invalidation, float tolerance, float weight_small,
                         float factor) {
    if (invalidation == INVALIDATION_CLAMP) {
        bool unchanged = gloam_neighborhood_unchanged(seen, tolerance);
        return unchanged ? weight : gloam_invalidate_clamp(weight, weight_small);
    }
    if (invalidation != INVALIDATION_CONFIDENCE) return weight;
    // Only what exceeds the tolerance: the rounding of positions must not eat the history of a scene at rest.
    float change = max(seen - tolerance, 0.0);
    return gloam_invalidate_confidence(weight, gloam_confidence(change / radius, factor));
}

#endif
