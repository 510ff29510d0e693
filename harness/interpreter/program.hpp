// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "shader/compile.hpp"

namespace gloam::interpreter {

namespace internal {
struct Code;
}

// The value of a specialization constant, as bits.
struct Constant {
    std::uint32_t id = 0;  // constant_id
    std::uint32_t bits = 0;
};

// An entry point of a SPIR-V module, decoded once for many runs (Machine). Copies share the decoded code,
// which never changes, so that any number of threads may run it.
class Program {
  public:
    // Decodes the entry point with this name and everything that it calls. Throws Error for a module that is
    // invalid (see shader::validate) and for an instruction that the interpreter does not know.
    explicit Program(const shader::Spirv& module, std::span<const Constant> constants = {},
                     const std::string& entry_point = "main");

    // Whether the module lets a driver contract or rearrange some float operation, because the operation is
    // not decorated with NoContraction.
    [[nodiscard]] bool may_be_rearranged() const;

    // Number of instructions after decoding. Every call is replaced by a copy of the called function.
    [[nodiscard]] std::size_t size() const;

    [[nodiscard]] const internal::Code& code() const { return *code_; }

  private:
    std::shared_ptr<const internal::Code> code_;
};

}  // namespace gloam::interpreter
