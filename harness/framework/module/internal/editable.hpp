// SPDX-License-Identifier: MIT
#pragma once

#include <spirv.h>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "module/compile.hpp"

namespace gloam::shader::internal {

using Id = std::uint32_t;

// An instruction that can be changed.
struct Op {
    std::uint32_t opcode = 0;
    std::vector<std::uint32_t> words;  // behind the first one

    // 0 if it has none.
    [[nodiscard]] Id type() const;
    [[nodiscard]] Id result() const;
    void set_result(Id id);

    // The words behind the result.
    [[nodiscard]] std::span<const std::uint32_t> operands() const;

    // Whether it is known which operands are IDs: of instructions that calculate, select, load, store and
    // call.
    [[nodiscard]] bool knows_ids() const;
    // Calls visit(id) for each of these operands, behind the result; none where they are not known.
    void visit_ids(const std::function<void(std::uint32_t& id)>& visit);
};

// A basic block: its first instruction is its label, its last one ends it.
struct Block {
    std::vector<Op> ops;

    [[nodiscard]] Id label() const { return ops.front().words[0]; }
    [[nodiscard]] const Op& end() const { return ops.back(); }
    [[nodiscard]] bool is_loop_header() const;
    // The first position behind phis and variables.
    [[nodiscard]] std::size_t first_free() const;
    // That of its end, or of the merge instruction before it.
    [[nodiscard]] std::size_t last_free() const;
};

struct FunctionBody {
    Op header;
    std::vector<Op> parameters;
    std::vector<Block> blocks;
};

// A place of an instruction.
struct Spot {
    std::size_t function = 0;
    std::size_t block = 0;
    std::size_t op = 0;
};

// A module taken apart, so that instructions and blocks can be added. Its words() is a module again.
class Editable {
  public:
    // Throws std::runtime_error for words that are not a SPIR-V module.
    explicit Editable(const Spirv& module);

    [[nodiscard]] Spirv words() const;

    std::vector<FunctionBody> functions;

    Id fresh() { return bound_++; }

    // The definition of a type, constant or global variable; null for the result of a function's instruction.
    [[nodiscard]] const Op* global(Id id) const;
    // Any type, constant or variable of the module for which the test holds.
    [[nodiscard]] const Op* find_global(const std::function<bool(const Op&)>& wanted) const;
    // The result of a type or constant with these operands (behind the result), which is added if there is
    // none. `type`: 0 for a type.
    Id global_of(std::uint32_t opcode, Id type, const std::vector<std::uint32_t>& operands);

    [[nodiscard]] Id bool_type() { return global_of(SpvOpTypeBool, 0, {}); }
    [[nodiscard]] Id uint_type() { return global_of(SpvOpTypeInt, 0, {32, 0}); }
    [[nodiscard]] Id uint_constant(std::uint32_t value) {
        return global_of(SpvOpConstant, uint_type(), {value});
    }
    // Whether a type is one of numbers or truth values: scalars, vectors and matrices of them.
    [[nodiscard]] bool is_of_numbers(Id type) const;

    // The types of all results of the spot's function, and of all global values.
    [[nodiscard]] std::map<Id, Id> types_of(const Spot& spot) const;

    // Inserts instructions before that of the spot.
    void insert(const Spot& spot, const std::vector<Op>& ops);
    // Divides the spot's block before its instruction; the second part, a new block behind it, gets the
    // terminator. Returns the label of the second part.
    Id split(const Spot& spot);

    // The decorations of an ID apply to another one as well. NoContraction, which is for arithmetic alone,
    // moves if `moves`.
    void share_decorations(Id from, Id to, bool moves);

    // Whether one truth value selects between vectors (SPIR-V 1.4).
    [[nodiscard]] bool selects_vectors() const { return header_[1] >= 0x00010400U; }

    // Empty: it has none.
    [[nodiscard]] std::string name_of(Id id) const;

  private:
    std::vector<std::uint32_t> header_;
    std::vector<Op> debug_;  // capabilities to names
    std::vector<Op> decorations_;
    std::vector<Op> globals_;
    std::map<Id, std::size_t> places_;  // in globals_
    Id bound_ = 0;
};

// The blocks of a spot's function, its block and its instruction. `module`: an Editable.
template <class Module>
[[nodiscard]] auto& blocks_of(Module& module, const Spot& spot) {
    return module.functions[spot.function].blocks;
}
template <class Module>
[[nodiscard]] auto& block_of(Module& module, const Spot& spot) {
    return blocks_of(module, spot)[spot.block];
}
template <class Module>
[[nodiscard]] auto& at(Module& module, const Spot& spot) {
    return block_of(module, spot).ops[spot.op];
}

}  // namespace gloam::shader::internal
