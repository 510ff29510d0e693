// SPDX-License-Identifier: MIT
#include "cli/variant.hpp"

#include <stdexcept>

namespace gloam::cli {

std::vector<shader::Variant> select_variants(const std::string& name) {
    if (name == "all") return shader::variants();
    try {
        return {shader::variant(name)};
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(std::string(error.what()) + ", or all");
    }
}

}  // namespace gloam::cli
