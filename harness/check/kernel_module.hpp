// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "check/kernel_code.hpp"
#include "interpreter/program.hpp"
#include "shader/compile.hpp"

namespace gloam::check {

// A compiled kernel, as it is passed to a driver or the interpreter.
struct KernelModule {
    shader::Spirv spirv;  // follows the interface of kernel_code()
    std::vector<interpreter::Constant> constants;
    std::size_t input_words = 0;
    std::size_t output_words = 0;
    std::vector<ImagePrototype> images;
    std::size_t fixed_inputs = 0;  // inputs that are constants in it; 0: they come from memory
    std::string glsl;              // the same kernel as text, for an OpenGL device; else empty
    bool judged_by_rules = true;   // off where the version of GLSL has no precision rules to ask
};

// The modules that evaluated a run's inputs, one after another. A single module evaluated all inputs;
// otherwise each evaluated its fixed_inputs.
using KernelModules = std::vector<std::shared_ptr<const KernelModule>>;

}  // namespace gloam::check
