// SPDX-License-Identifier: MIT
#include "check/kernel_code.hpp"

#include "check/internal/kernel_text.hpp"

namespace gloam::check {

std::string kernel_code(const KernelSource& source) {
    return internal::kernel_text(source, internal::main_of(source.function));
}

}  // namespace gloam::check
