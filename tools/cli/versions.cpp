// SPDX-License-Identifier: MIT
#include "cli/versions.hpp"

#include "base/text.hpp"
#include "shader/compile.hpp"

namespace gloam::cli {

std::string versions() {
    return "gloam " GLOAM_VERSION ", " + base::one_line(shader::compiler_version());
}

}  // namespace gloam::cli
