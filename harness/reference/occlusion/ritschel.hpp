// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
T gloam_contribution_ritschel(T blocked, T falloff, T cosine) {
    return gloam_unit_interval(blocked) * gloam_unit_interval(falloff) * gloam_unit_interval(cosine);
}

template <class T>
T gloam_contribution_cosine_directions(T blocked, T falloff) {
    return gloam_unit_interval(blocked) * gloam_unit_interval(falloff);
}

template <class T>
T gloam_contribution_uniform_directions(T blocked, T falloff, T cosine) {
    return T(2) * gloam_unit_interval(blocked) * gloam_unit_interval(falloff) * gloam_unit_interval(cosine);
}

}  // namespace gloam::reference
