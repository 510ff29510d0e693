// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "check/lab.hpp"
#include "check/reproduction.hpp"

namespace CLI {
class App;
}

namespace gloam::cli {

// The smallest module that spirv-reduce finds for which a failure stays: a step that compiles still changes
// what it means, or the device is still outside its rules. For a kernel of one invocation without images.
// Empty where there is none, or no spirv-reduce. It takes 10 s at most.
[[nodiscard]] shader::Spirv smallest_module(const check::Lab& lab, const check::Reproduction& failure);

// Adds the hidden subcommand that tells spirv-reduce whether a module still fails: exit status 0.
void add_module_test(CLI::App& app, int& status);

}  // namespace gloam::cli
