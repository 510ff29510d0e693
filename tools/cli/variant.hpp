// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "shader/compile.hpp"

namespace gloam::cli {

// One way to compile the shaders.
struct Variant {
    std::string name;
    std::string description;
    shader::Optimization optimization = shader::Optimization::none;
};

[[nodiscard]] std::vector<Variant> variants();

// The variant of that name, or all of them for "all". Throws std::invalid_argument that lists the names.
[[nodiscard]] std::vector<Variant> select_variants(const std::string& name);

}  // namespace gloam::cli
