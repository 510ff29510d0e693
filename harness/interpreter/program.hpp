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

// The value of a specialization constant, as its bits.
struct Constant {
    std::uint32_t id = 0;  // constant_id
    std::uint32_t bits = 0;
};

// An entry point of a SPIR-V module, decoded once to be run many times (Machine). Copies share what was
// decoded; it never changes, so that any number of threads may run it.
class Program {
  public:
    // Decodes the entry point of that name and everything it calls. The module is expected to be valid
    // (shader::validate); one that is not throws Error, like one with an instruction that the interpreter
    // does not know.
    explicit Program(const shader::Spirv& module, std::span<const Constant> constants = {},
                     const std::string& entry_point = "main");

    // Whether the module lets a driver contract or rearrange some float operation: one that has no
    // NoContraction.
    [[nodiscard]] bool may_be_rearranged() const;

    // Instructions after decoding. Every call is replaced by a copy of the function called.
    [[nodiscard]] std::size_t size() const;

    [[nodiscard]] const internal::Code& code() const { return *code_; }

  private:
    std::shared_ptr<const internal::Code> code_;
};

}  // namespace gloam::interpreter
