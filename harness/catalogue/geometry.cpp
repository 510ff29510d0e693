// SPDX-License-Identifier: MIT
#include "catalogue/rooms.hpp"

namespace gloam::catalogue {

void append_geometry(Entries&) {}

}  // namespace gloam::catalogue
