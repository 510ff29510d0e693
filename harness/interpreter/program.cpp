// SPDX-License-Identifier: MIT
#include "interpreter/program.hpp"

#include "interpreter/internal/code.hpp"
#include "interpreter/internal/lowering.hpp"
#include "interpreter/internal/operations.hpp"
#include "interpreter/machine.hpp"

namespace gloam::interpreter {

Program::Program(const shader::Spirv& module, std::span<const Constant> constants,
                 const std::string& entry_point) {
    const internal::Module read(module, constants);
    code_ = std::make_shared<const internal::Code>(internal::Lowering(read).run(entry_point));
}

std::string name_of_operation(std::uint16_t opcode) {
    return internal::name_of(opcode);
}

bool Program::may_be_rearranged() const {
    return code_->may_be_rearranged;
}

std::size_t Program::size() const {
    return code_->instructions.size();
}

}  // namespace gloam::interpreter
