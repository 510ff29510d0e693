// SPDX-License-Identifier: MIT
#include "cli/variant.hpp"

#include <stdexcept>

namespace gloam::cli {

std::vector<Variant> variants() {
    return {{"shipped", "the SPIR-V that glslang makes", shader::Optimization::none},
            {"optimized", "optimised for speed by SPIRV-Tools (-O)", shader::Optimization::performance},
            {"small", "optimised for size by SPIRV-Tools (-Os)", shader::Optimization::size}};
}

std::vector<Variant> select_variants(const std::string& name) {
    if (name == "all") return variants();
    std::string names;
    for (const Variant& variant : variants()) {
        if (variant.name == name) return {variant};
        names += variant.name + ", ";
    }
    throw std::invalid_argument("unknown variant \"" + name + "\": expected " + names + "or all");
}

}  // namespace gloam::cli
