// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "subject/own_function.hpp"

namespace gloam::check::internal {

inline constexpr const char* judged_samplers =
    "sampler2D, sampler2DArray, sampler3D, samplerCube, samplerCubeArray, those of integers, and "
    "sampler2DShadow";

// Why an excerpt does not compile as a part of a compute shader. `errors`: what the compiler says.
[[nodiscard]] LeftOut refused(const shader::Excerpt& excerpt, const std::string& definition,
                              const std::string& errors);

}  // namespace gloam::check::internal
