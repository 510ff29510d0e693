// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/length.hpp"
#include "reference/occlusion/falloff.hpp"
#include "reference/occlusion/gtao.hpp"
#include "reference/occlusion/slice_gather.hpp"

namespace gloam::reference {

template <class T>
struct GloamGtao {
    unsigned steps;
};

template <class T>
struct GtaoMethod {
    vec3<T> view(vec3<T> eye) const { return eye; }
    GloamMarch<T> start(GloamSlice<T> slice, vec3<T> /*normal*/, T share, GloamMethod<T> /*method*/) const {
        const vec2<T> lowest = gloam_gtao_lowest(slice);
        return {vec2<T>(T(-1), lowest.y), vec2<T>(T(-1), lowest.x), share, 0U};
    }
    GloamMarch<T> step(GloamMarch<T> march, GloamSlice<T> slice, vec3<T> offset, bool positive,
                       GloamKernel<T> kernel, GloamMethod<T> /*method*/) const {
        const T weight = gloam_falloff_linear(gloam_length(offset), kernel.radius);
        vec2<T>& side = positive ? march.positive : march.negative;
        side.x = gloam_gtao_horizon(side.x, side.y, offset, slice.view, weight);
        return march;
    }
    vec2<T> end(vec2<T> accumulated, GloamMarch<T> march, GloamSlice<T> slice,
                GloamMethod<T> /*method*/) const {
        return gloam_gtao_add(accumulated, slice, vec2<T>(march.negative.x, march.positive.x));
    }
};

}  // namespace gloam::reference
