// SPDX-License-Identifier: MIT
#include "catalogue/rooms.hpp"

namespace gloam::catalogue {

void append_sampling(Entries&) {}

}  // namespace gloam::catalogue
