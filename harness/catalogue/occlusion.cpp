// SPDX-License-Identifier: MIT
#include "catalogue/rooms.hpp"

namespace gloam::catalogue {

void append_occlusion(Entries&) {}

}  // namespace gloam::catalogue
