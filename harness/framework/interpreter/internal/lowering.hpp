// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "interpreter/internal/code.hpp"
#include "interpreter/internal/module.hpp"

namespace gloam::interpreter::internal {

// The target of an ID of pointer type, as far as it is known before the run.
struct PointerInfo {
    // shared: memory of a group, with a word for each scalar, one after another
    enum class Space { slots, memory, shared, resource };
    Space space = Space::slots;
    bool is_static = true;
    Pointer target;                      // if static
    std::uint32_t index = 0;             // of the machine's pointer, if not static
    Id pointee = 0;                      // type
    module::spirv::MatrixLayout matrix;  // in memory
    std::uint32_t scalar_stride = 0;     // of a column of a row-major matrix; 0: consecutive
    std::uint32_t variable = 0;          // in Code::variables; 0: none
};

// Converts an entry point and all that it calls to Code. Every call becomes a copy of the function.
class Lowering {
  public:
    explicit Lowering(const Module& module) : module_(module) {}

    [[nodiscard]] Code run(const std::string& entry_point);

  private:
    // A copy of a function that is being lowered: its IDs, and the edges with unknown targets.
    struct Scope {
        const Function* function = nullptr;
        std::unordered_map<Id, Slot> slots;
        std::unordered_map<Id, Id> types;
        std::unordered_map<Id, PointerInfo> pointers;
        struct Phi {
            Slot result;
            std::uint32_t count;
            std::vector<std::pair<Id, Id>> values;  // value, preceding block
        };
        std::unordered_map<Id, std::uint32_t> blocks;  // first instruction
        std::unordered_map<Id, std::vector<Phi>> phis;
        struct OpenEdge {
            std::uint32_t edge;
            Id from;
            Id to;
        };
        std::vector<OpenEdge> open_edges;
        std::vector<std::uint32_t> returns;  // edges to the end of the function
        Slot result = 0;
        Id block = 0;
    };

    void place_globals();
    void place_variable(const module::Instruction& variable);
    void lower_function(const Function& function);
    void allocate_results(const Function& function);
    void close_edges();
    void lower(const module::Instruction& i);
    // Down to lower_group(), each hands on to the next what is not its own.
    void lower_control(const module::Instruction& i);
    void lower_memory(const module::Instruction& i);
    void lower_composite(const module::Instruction& i);
    void lower_matrix(const module::Instruction& i);
    void lower_atomic(const module::Instruction& i);
    void lower_fetch(const module::Instruction& i);
    void lower_image(const module::Instruction& i);
    void lower_sampling(const module::Instruction& i);
    void lower_group(const module::Instruction& i);
    Slot lower_difference(Slot of, std::uint32_t count, std::uint32_t pick, std::uint8_t how);
    Slot lower_slope(Slot of, std::uint32_t count, std::uint32_t axis, std::uint8_t how, bool fine);
    struct Coordinates {
        Slot first;
        std::uint32_t count;
    };
    Coordinates lower_gradients(const module::Instruction& i, Coordinates at, Sampling& how);
    void lower_derivative(const module::Instruction& i);
    void lower_collective(const module::Instruction& i);
    void list_offsets(const PointerInfo& pointer, Instruction& instruction);
    void lower_operation(const module::Instruction& i);
    void lower_bits(const module::Instruction& i);
    void lower_call(const module::Instruction& i);
    void lower_access_chain(const module::Instruction& i);
    void lower_local_variable(const module::Instruction& i);
    void lower_shuffle(const module::Instruction& i);
    void lower_switch(const module::Instruction& i);
    void load(Slot result, const PointerInfo& from, std::uint8_t flags);
    void store(const PointerInfo& to, Slot value);

    Instruction& emit(std::uint16_t op, std::uint32_t count, Slot result, Slot a = 0, Slot b = 0, Slot c = 0);
    // The same with the type, the result and the flags of an instruction.
    Instruction& emit_for(const module::Instruction& i, std::uint16_t op, Slot a = 0, Slot b = 0, Slot c = 0);
    [[nodiscard]] std::uint32_t new_edge();
    // Leaves a variable unwritten.
    void undefine_variable(PointerInfo& variable, std::uint32_t count, const std::string& name);
    [[nodiscard]] std::uint32_t edge_to(Id label);
    [[nodiscard]] Slot new_slots(std::uint32_t count);
    [[nodiscard]] std::uint32_t new_pointer(const Pointer& target = {});
    [[nodiscard]] std::uint32_t pointer_index(const PointerInfo& info);
    [[nodiscard]] std::uint32_t new_list(const std::vector<std::uint32_t>& list);
    [[nodiscard]] Slot slot_of(Id id) const;
    [[nodiscard]] Id type_of(Id id) const;
    [[nodiscard]] const PointerInfo& pointer_of(Id id) const;
    [[nodiscard]] std::uint8_t flags_of(Id result, Id type) const;
    // Whether an instruction of the function names the result of another one.
    [[nodiscard]] bool is_used(Id result) const;
    void remember_place(const module::Instruction& i);
    [[noreturn]] void fail(Error::Kind kind, const std::string& message) const;

    const Module& module_;
    Code code_;
    Scope scope_;
    std::unordered_map<Id, Slot> global_slots_;
    std::unordered_map<Id, Id> global_types_;
    std::unordered_map<Id, PointerInfo> global_pointers_;
    std::vector<Id> calls_;                             // functions that are being lowered
    std::vector<std::vector<std::uint32_t>> computed_;  // the words of computed constants
    Location place_;
};

}  // namespace gloam::interpreter::internal
