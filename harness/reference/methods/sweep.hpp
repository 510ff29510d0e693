// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/into_slice.hpp"
#include "reference/occlusion/slice_gather.hpp"
#include "reference/occlusion/sweep.hpp"

namespace gloam::reference {

template <class T>
struct GloamSweep {
    unsigned steps;
    unsigned falloff;
};

// A side as (cosine of the horizon, distance of the last tap); share: what both sides hold with its falloff.
template <class T>
struct SweepMethod {
    unsigned falloff;

    vec3<T> view(vec3<T> eye) const { return eye; }
    GloamMarch<T> start(GloamSlice<T> slice, vec3<T> /*normal*/, T /*share*/,
                        GloamMethod<T> /*method*/) const {
        const vec2<T> lowest = gloam_gtao_lowest(slice);
        return {vec2<T>(lowest.y, T(0)), vec2<T>(lowest.x, T(0)), T(0), 0U};
    }
    GloamMarch<T> step(GloamMarch<T> march, GloamSlice<T> slice, vec3<T> offset, bool positive,
                       GloamKernel<T> kernel, GloamMethod<T> /*method*/) const {
        return tap(march, slice, offset, positive, true, kernel.radius);
    }
    GloamMarch<T> below(GloamMarch<T> march, GloamSlice<T> slice, vec3<T> offset, bool positive,
                        GloamKernel<T> kernel, GloamMethod<T> /*method*/) const {
        return tap(march, slice, offset, positive, false, kernel.radius);
    }
    vec2<T> end(vec2<T> accumulated, GloamMarch<T> march, GloamSlice<T> slice,
                GloamMethod<T> /*method*/) const {
        if (!(slice.weight > T(0))) return accumulated;
        return accumulated + vec2<T>(march.share, gloam_slice_whole(slice)) * slice.weight;
    }

  private:
    // What is behind a horizon is calculated anew for each tap: I(H) - I(h) as printed.
    GloamMarch<T> tap(GloamMarch<T> march, GloamSlice<T> slice, vec3<T> offset, bool positive, bool rises,
                      T radius) const {
        const GloamSlice<T> half_plane = gloam_sweep_slice(slice, positive ? T(1) : T(-1));
        vec2<T>& seen = positive ? march.positive : march.negative;
        const vec2<T> horizon(seen.x, sqrt(max(T(1) - seen.x * seen.x, T(0))));
        GloamSweepSide<T> side{seen.x, gloam_sweep_behind(horizon, half_plane), seen.y, march.share};
        const vec2<T> in_slice =
            vec2<T>(dot(offset, slice.view), dot(offset, slice.tangent)) * (T(1) / radius);
        side = gloam_sweep_tap(side, half_plane, in_slice, true, rises, falloff);
        seen = vec2<T>(side.horizon, side.before);
        march.share = side.occluded;
        return march;
    }
};

}  // namespace gloam::reference
