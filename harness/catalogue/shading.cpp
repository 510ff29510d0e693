// SPDX-License-Identifier: MIT
#include "catalogue/rooms.hpp"

namespace gloam::catalogue {

void append_shading(Entries&) {}

}  // namespace gloam::catalogue
