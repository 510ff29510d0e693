// SPDX-License-Identifier: MIT
#pragma once

namespace gloam::reference {

template <class T>
struct GloamMethod {
    T range;
    T epsilon;
    T intensity;
    T thickness;
    T angle_bias;
    T mip_distance;
    unsigned steps;
    T disagreement;
};

}  // namespace gloam::reference
