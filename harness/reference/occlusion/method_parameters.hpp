// SPDX-License-Identifier: MIT
#pragma once

namespace gloam::reference {

struct GloamMethod {
    double range;
    double epsilon;
    double intensity;
    double thickness;
    double angle_bias;
    double mip_distance;
    unsigned steps;
    double disagreement;
};

}  // namespace gloam::reference
