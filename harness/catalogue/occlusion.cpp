// SPDX-License-Identifier: MIT
#include "catalogue/occlusion_parts.hpp"
#include "catalogue/relatives_parts.hpp"
#include "catalogue/rooms.hpp"

namespace gloam::catalogue {

void append_occlusion(Entries& entries) {
    append_falloffs(entries);
    append_contributions(entries);
    append_points(entries);
    append_horizons(entries);
    append_slice_methods(entries);
    append_sweeps(entries);
    append_volumes(entries);
    append_gathers(entries);
    append_slice_gathers(entries);
    append_ray_gathers(entries);
    append_occlusion_scalable(entries);
    append_occlusion_layers(entries);
    append_occlusion_proxies(entries);
}

}  // namespace gloam::catalogue
