// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "effect/plan.hpp"
#include "module/compile.hpp"
#include "scene/pass_library.hpp"

namespace gloam::cli {

// A pass of a plan as one text, with its constants set.
[[nodiscard]] std::string text_of(const effect::PlannedPass& pass, const scene::PassLibrary& library,
                                  shader::Language language = shader::Language::vulkan450);

}  // namespace gloam::cli
