// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/square_root.hpp"
#include "reference/occlusion/proxy_gather.hpp"
#include "reference/occlusion/sphere_proxy.hpp"

namespace gloam::reference {

struct GloamSphereProxy {
    double intensity;
};

struct SphereProxyMethod {
    double occlusion(GloamProxy proxy, dvec3 normal, GloamCamera /*camera*/, GloamKernel /*kernel*/,
                     GloamMethod /*method*/) const {
        const double radius = 0.5 * gloam_sqrt(double(proxy.size.x * proxy.size.y));
        return gloam_contribution_sphere_cosine(proxy.offset, normal, radius);
    }
};

}  // namespace gloam::reference
