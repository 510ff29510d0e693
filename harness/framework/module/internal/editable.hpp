// SPDX-License-Identifier: MIT
#pragma once

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

    // Calls visit(id) for every operand that is an ID, behind the result. Returns false, without a call, for
    // an instruction whose operands it does not know: it knows those that calculate, select, load, store
    // and call.
    bool visit_ids(const std::function<void(std::uint32_t& id)>& visit);
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

    [[nodiscard]] Id bool_type() { return global_of(opcode_type_bool, 0, {}); }
    [[nodiscard]] Id uint_type() { return global_of(opcode_type_int, 0, {32, 0}); }
    [[nodiscard]] Id uint_constant(std::uint32_t value);

    // The types of all results of a function, and of all global values.
    [[nodiscard]] std::map<Id, Id> types_of(const FunctionBody& function) const;

    // The decorations of an ID apply to another one as well. NoContraction, which is for arithmetic alone,
    // moves if `moves`.
    void share_decorations(Id from, Id to, bool moves);

    // Whether one truth value selects between vectors (SPIR-V 1.4).
    [[nodiscard]] bool selects_vectors() const { return header_[1] >= 0x00010400U; }

    // Empty: it has none.
    [[nodiscard]] std::string name_of(Id id) const;

  private:
    static constexpr std::uint32_t opcode_type_bool = 20;
    static constexpr std::uint32_t opcode_type_int = 21;

    std::vector<std::uint32_t> header_;
    std::vector<Op> debug_;  // capabilities to names
    std::vector<Op> decorations_;
    std::vector<Op> globals_;
    std::map<Id, std::size_t> places_;  // in globals_
    Id bound_ = 0;
};

// Divides the block `at` of the function before the instruction `position`; the second part, a new block
// behind it, gets the terminator. Returns the label of the second part.
Id split(Editable& module, FunctionBody& function, std::size_t at, std::size_t position);

}  // namespace gloam::shader::internal
