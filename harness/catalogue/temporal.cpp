// SPDX-License-Identifier: MIT
#include "catalogue/relatives_parts.hpp"
#include "catalogue/rooms.hpp"
#include "catalogue/temporal_parts.hpp"

namespace gloam::catalogue {

void append_temporal(Entries& entries) {
    append_accumulation(entries);
    append_history(entries);
    append_packed_history(entries);
    append_displacement(entries);
    append_validity(entries);
    append_reprojection(entries);
    append_temporal_smoothing(entries);
}

}  // namespace gloam::catalogue
