// SPDX-License-Identifier: MIT
#include "catalogue/rooms.hpp"

namespace gloam::catalogue {

void append_temporal(Entries&) {}

}  // namespace gloam::catalogue
