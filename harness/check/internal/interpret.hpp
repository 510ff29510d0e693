// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <string>

#include "check/kernel_core.hpp"

namespace gloam::check::internal {

// The result of KernelCore::run(), computed by the interpreter in float32. Images that the shader stores to
// are those of sequential invocations. Throws KernelError for a module that the interpreter cannot run.
[[nodiscard]] KernelCore::Result interpret(const std::shared_ptr<const KernelModule>& module,
                                           std::span<const Word> inputs, std::size_t count,
                                           const ImageSet& images, const std::string& name);

}  // namespace gloam::check::internal
