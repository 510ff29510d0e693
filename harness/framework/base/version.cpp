// SPDX-License-Identifier: MIT
#include "base/version.hpp"

namespace gloam::base {

std::string version() {
    return GLOAM_VERSION;
}

}  // namespace gloam::base
