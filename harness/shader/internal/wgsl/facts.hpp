// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <set>
#include <vector>

#include "shader/internal/wgsl/module.hpp"
#include "shader/type.hpp"

namespace gloam::shader::internal::wgsl {

// The IDs that an instruction uses, without its type and result.
[[nodiscard]] std::vector<Id> operands(const Instruction& instruction);

// Whether an instruction works on a subgroup: its result depends on the invocations that run it.
[[nodiscard]] bool is_subgroup_operation(std::uint32_t opcode);

// The result of an instruction; 0 where it has none.
[[nodiscard]] Id result_of(const Instruction& instruction);

// How a parameter is passed in WGSL.
enum class Passing {
    value,    // never changed by the function
    copied,   // by value; the function changes its copy
    pointer,  // out, inout
};

// What a function does, with all that it calls.
struct FunctionFacts {
    std::vector<Passing> passing;
    bool changes_memory = false;  // or has another effect besides its result
    bool reads_memory = false;
    std::set<Id> pointers_written;  // parameters
};

// How often a local variable is used, and how.
struct VariableUses {
    int stores = 0;   // as a whole
    int loads = 0;    // as a whole
    int parts = 0;    // access chains and all other uses
    int calls = 0;    // as an argument
    int changes = 0;  // stores, also of parts, and arguments that the called function changes
};

// The declaration of a function of the module by its name and types; nullptr where there is none.
[[nodiscard]] const shader::Function* declaration_of(const Module& module, const Function& function,
                                                     const std::vector<shader::Function>& declared);

// Facts of the functions of a module.
class Facts {
  public:
    Facts(const Module& module, const std::vector<shader::Function>& declared);

    [[nodiscard]] const FunctionFacts& of(Id function) const {
        return entry_of(facts_, function, "a call of a function without a body");
    }
    [[nodiscard]] const VariableUses& uses_of(Id variable) const {
        return entry_of(uses_, variable, "a pointer to no variable");
    }
    // The variable or parameter behind a pointer.
    [[nodiscard]] Id base_of(Id pointer) const;
    // The variable of a loaded image.
    [[nodiscard]] Id image_of(Id value) const;
    // Members of structures, and whole variables, that atomic operations change.
    [[nodiscard]] bool is_atomic(Id structure, std::uint32_t member) const {
        return atomic_members_.contains({structure, member});
    }
    [[nodiscard]] bool is_atomic(Id variable) const { return atomic_variables_.contains(variable); }
    // Whether it leads to a scalar that atomic operations change.
    [[nodiscard]] bool is_atomic_pointer(Id pointer) const;
    [[nodiscard]] bool is_written(Id variable) const { return written_.contains(variable); }
    // Whether a combined sampler is read by its sampler, not only by texelFetch().
    [[nodiscard]] bool is_sampled(Id variable) const { return sampled_.contains(variable); }
    [[nodiscard]] bool is_read(Id variable) const { return read_.contains(variable); }
    // Whether the function, or one that it calls, uses the variable of the module.
    [[nodiscard]] const std::set<Id>& calls_of(Id function) const {
        return entry_of(calls_, function, "a call of a function without a body");
    }
    [[nodiscard]] const std::set<Id>& globals_of(Id function) const {
        return entry_of(globals_, function, "a call of a function without a body");
    }

  private:
    void read_function(const Function& function);
    void read_use(const Instruction& instruction, FunctionFacts& facts);
    void read_atomic(const Instruction& instruction);
    // The innermost structure that the pointer goes through, and the member; nothing where there is none.
    [[nodiscard]] std::optional<std::pair<Id, std::uint32_t>> owner_of(Id pointer) const;
    void store_to(Id pointer, FunctionFacts& facts);
    void load_from(Id pointer, FunctionFacts& facts);
    void read_call(const Instruction& instruction, FunctionFacts& facts);
    void decide_passing(const Function& function, const shader::Function* declared);
    [[nodiscard]] bool only_given(Id function, std::size_t parameter) const;

    const Module& module_;
    std::map<Id, FunctionFacts> facts_;
    std::map<Id, VariableUses> uses_;
    std::map<Id, Instruction> chains_;  // by their result
    std::map<Id, Id> loaded_;
    std::set<Id> globals_of_module_;
    std::set<std::pair<Id, std::uint32_t>> atomic_members_;
    std::set<Id> atomic_variables_;
    std::set<Id> written_;
    std::set<Id> read_;
    std::set<Id> sampled_;
    std::map<Id, std::set<Id>> calls_;
    std::map<Id, std::set<Id>> globals_;
    std::map<Id, std::vector<Instruction>> call_sites_;
    Id open_ = 0;
};

}  // namespace gloam::shader::internal::wgsl
