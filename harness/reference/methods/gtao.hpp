// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/length.hpp"
#include "reference/occlusion/falloff.hpp"
#include "reference/occlusion/gtao.hpp"
#include "reference/occlusion/slice_gather.hpp"

namespace gloam::reference {

struct GloamGtao {
    unsigned steps;
};

struct GtaoMethod {
    dvec3 view(dvec3 eye) const { return eye; }
    GloamMarch start(GloamSlice slice, dvec3 /*normal*/, double share, GloamMethod /*method*/) const {
        const dvec2 lowest = gloam_gtao_lowest(slice);
        return {dvec2(-1.0, lowest.y), dvec2(-1.0, lowest.x), share, 0U};
    }
    GloamMarch step(GloamMarch march, GloamSlice slice, dvec3 offset, bool positive, GloamKernel kernel,
                    GloamMethod /*method*/) const {
        const double weight = gloam_falloff_linear(gloam_length(offset), kernel.radius);
        dvec2& side = positive ? march.positive : march.negative;
        side.x = gloam_gtao_horizon(side.x, side.y, offset, slice.view, weight);
        return march;
    }
    dvec2 end(dvec2 accumulated, GloamMarch march, GloamSlice slice, GloamMethod /*method*/) const {
        return gloam_gtao_add(accumulated, slice, dvec2(march.negative.x, march.positive.x));
    }
};

}  // namespace gloam::reference
