// SPDX-License-Identifier: MIT
#pragma once

#include "shader/compile.hpp"

namespace gloam::shader::internal {

// The module with its storage buffers as SPIR-V has them from version 1.3 on: blocks of the storage class
// StorageBuffer. glslang's HLSL front end makes them BufferBlocks of the class Uniform. Throws
// std::runtime_error for a module that has uniform buffers too: their pointers are of the same class.
[[nodiscard]] Spirv with_storage_buffers(Spirv module);

}  // namespace gloam::shader::internal
