// SPDX-License-Identifier: MIT
#include "catalogue/rooms.hpp"

namespace gloam::catalogue {

void append_filter(Entries&) {}

}  // namespace gloam::catalogue
