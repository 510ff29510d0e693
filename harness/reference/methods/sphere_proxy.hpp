// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/square_root.hpp"
#include "reference/occlusion/proxy_gather.hpp"
#include "reference/occlusion/sphere_proxy.hpp"

namespace gloam::reference {

template <class T>
struct GloamSphereProxy {
    T intensity;
};

template <class T>
struct SphereProxyMethod {
    T occlusion(GloamProxy<T> proxy, vec3<T> normal, GloamCamera<T> /*camera*/, GloamKernel<T> /*kernel*/,
                GloamMethod<T> /*method*/) const {
        const T radius = T(0.5) * gloam_sqrt(T(proxy.size.x * proxy.size.y));
        return gloam_contribution_sphere_cosine(proxy.offset, normal, radius);
    }
};

}  // namespace gloam::reference
