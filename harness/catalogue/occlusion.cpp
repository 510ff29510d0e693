// SPDX-License-Identifier: MIT
#include "catalogue/occlusion_parts.hpp"
#include "catalogue/rooms.hpp"

namespace gloam::catalogue {

void append_occlusion(Entries& entries) {
    append_falloffs(entries);
    append_contributions(entries);
    append_gathers(entries);
}

}  // namespace gloam::catalogue
