// SPDX-License-Identifier: MIT
#include "cli/framework/variants.hpp"

#include <stdexcept>

#include "base/text.hpp"
#include "base/version.hpp"
#include "module/steps.hpp"

namespace gloam::cli {

std::vector<shader::Variant> select_variants(const std::string& name) {
    if (name == "all") return shader::variants();
    try {
        return {shader::variant(name)};
    } catch (const std::invalid_argument& error) {
        if (name.find(shader::step_separator) != std::string::npos) throw;
        throw std::invalid_argument(std::string(error.what()) + ", or all");
    }
}

std::string versions() {
    return "gloam " + base::version() + ", " + base::one_line(shader::compiler_version());
}

}  // namespace gloam::cli
