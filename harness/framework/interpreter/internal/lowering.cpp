// SPDX-License-Identifier: MIT
#include "interpreter/internal/lowering.hpp"

#include <fmt/format.h>
#include "interpreter/internal/opcodes.hpp"

#include <algorithm>
#include <array>

namespace gloam::interpreter::internal {
namespace {

// Limit of instructions. Only a hostile shader expands to more.
constexpr std::size_t most_instructions = 1U << 21;
constexpr std::uint32_t most_slots = 1U << 24;

bool is_resource(std::uint32_t storage) {
    return storage == SpvStorageClassUniform || storage == SpvStorageClassStorageBuffer ||
           storage == SpvStorageClassPushConstant || storage == SpvStorageClassUniformConstant;
}

}  // namespace

void Lowering::fail(Error::Kind kind, const std::string& message) const {
    throw Error(kind, message, place_);
}

Instruction& Lowering::emit(std::uint16_t op, std::uint32_t count, Slot result, Slot a, Slot b, Slot c) {
    if (code_.instructions.size() == most_instructions)
        fail(Error::Kind::malformed,
             fmt::format("more than {} instructions with all calls", most_instructions));
    const auto place = static_cast<std::uint32_t>(code_.places.size() - 1);
    code_.instructions.push_back(
        {.op = op, .count = count, .result = result, .a = a, .b = b, .c = c, .place = place});
    code_.origins.push_back(static_cast<std::uint32_t>(place_.word));
    return code_.instructions.back();
}

Instruction& Lowering::emit_for(const module::Instruction& i, std::uint16_t op, Slot a, Slot b, Slot c) {
    Instruction& emitted = emit(op, module_.types.slots(i.word(1)), slot_of(i.word(2)), a, b, c);
    emitted.flags = flags_of(i.word(2), i.word(1));
    return emitted;
}

Slot Lowering::new_slots(std::uint32_t count) {
    if (count > most_slots - code_.slots)
        fail(Error::Kind::malformed, fmt::format("variables of more than {} scalars", most_slots));
    const Slot first = code_.slots;
    code_.slots += count;
    return first;
}

void Lowering::undefine_variable(PointerInfo& variable, std::uint32_t count, const std::string& name) {
    variable.variable = static_cast<std::uint32_t>(code_.variables.size());
    code_.variables.push_back(name);
    emit(undefine, count, variable.target.offset).extra = variable.variable;
}

std::uint32_t Lowering::new_pointer(const Pointer& target) {
    code_.pointers.push_back(target);
    return static_cast<std::uint32_t>(code_.pointers.size() - 1);
}

std::uint32_t Lowering::pointer_index(const PointerInfo& info) {
    return info.is_static ? new_pointer(info.target) : info.index;
}

std::uint32_t Lowering::new_list(const std::vector<std::uint32_t>& list) {
    const auto first = static_cast<std::uint32_t>(code_.lists.size());
    code_.lists.insert(code_.lists.end(), list.begin(), list.end());
    return first;
}

std::uint32_t Lowering::new_edge() {
    code_.edges.emplace_back();
    return static_cast<std::uint32_t>(code_.edges.size() - 1);
}

std::uint32_t Lowering::edge_to(Id label) {
    const std::uint32_t edge = new_edge();
    scope_.open_edges.push_back({edge, scope_.block, label});
    return edge;
}

Slot Lowering::slot_of(Id id) const {
    if (const auto found = scope_.slots.find(id); found != scope_.slots.end()) return found->second;
    if (const auto found = global_slots_.find(id); found != global_slots_.end()) return found->second;
    fail(Error::Kind::malformed, fmt::format("ID {} has no value", id));
}

Id Lowering::type_of(Id id) const {
    if (const auto found = scope_.types.find(id); found != scope_.types.end()) return found->second;
    if (const auto found = global_types_.find(id); found != global_types_.end()) return found->second;
    fail(Error::Kind::malformed, fmt::format("ID {} has no type", id));
}

const PointerInfo& Lowering::pointer_of(Id id) const {
    if (const auto found = scope_.pointers.find(id); found != scope_.pointers.end()) return found->second;
    if (const auto found = global_pointers_.find(id); found != global_pointers_.end()) return found->second;
    fail(Error::Kind::unknown_instruction,
         fmt::format("the pointer {} is not made by a variable or an access chain", id));
}

std::uint8_t Lowering::flags_of(Id result, Id type) const {
    const Type& scalar = module_.types.scalar_of(type);
    const module::spirv::Decorations decorations = module_.declared.decorations_of(result);
    std::uint8_t all = 0;
    if (scalar.kind != Type::Kind::real) return all;
    if (decorations.no_contraction) all |= flags::no_contraction;
    if (decorations.relaxed) all |= flags::relaxed;
    if (scalar.width == 16) all |= flags::half;
    return all;
}

void Lowering::remember_place(const module::Instruction& i) {
    place_.word = i.at;
    place_.function = module_.name_of(scope_.function->id);
    const bool known = !code_.places.empty() && place_.line != 0 && code_.places.back().line == place_.line &&
                       code_.places.back().file == place_.file &&
                       code_.places.back().function == place_.function;
    if (!known) code_.places.push_back(place_);
}

void Lowering::place_variable(const module::Instruction& variable) {
    const Type& pointer = module_.types.at(variable.word(1));
    const Id id = variable.word(2);
    const module::spirv::Decorations decorations = module_.declared.decorations_of(id);
    PointerInfo info{.pointee = pointer.element};
    // A block without an instance has only its own name.
    const std::string own = module_.name_of(id);
    const std::string name = own.empty() ? module_.name_of(pointer.element) : own;
    const std::uint32_t count = module_.types.slots(pointer.element);
    const bool shared = variable.word(3) == SpvStorageClassWorkgroup;
    if (shared || is_resource(variable.word(3))) {
        const bool opaque = variable.word(3) == SpvStorageClassUniformConstant;
        info.space = shared   ? PointerInfo::Space::shared
                     : opaque ? PointerInfo::Space::resource
                              : PointerInfo::Space::memory;
        info.target = {static_cast<std::uint32_t>(code_.resources.size()), 0};
        if (opaque && module_.types.at(pointer.element).kind == Type::Kind::array)
            fail(Error::Kind::unknown_instruction,
                 fmt::format("\"{}\", an array of samplers or images", name));
        code_.resources.push_back({.kind = opaque ? Resource::Kind::image : Resource::Kind::memory,
                                   .set = decorations.set,
                                   .binding = decorations.binding,
                                   .is_push_constant = variable.word(3) == SpvStorageClassPushConstant,
                                   .name = name,
                                   .shared_words = shared ? count : 0});
    } else {
        info.target.offset = new_slots(count);
        if (decorations.built_in)
            code_.built_ins.push_back({*decorations.built_in, info.target.offset, count});
        else
            undefine_variable(info, count, name);
        if (variable.words.size() > 4) emit(copy, count, info.target.offset, slot_of(variable.word(4)));
    }
    global_pointers_[id] = info;
    global_types_[id] = variable.word(1);
}

void Lowering::place_globals() {
    for (const auto& [id, constant] : module_.constants) {
        const Slot first = new_slots(static_cast<std::uint32_t>(constant.bits.size()));
        global_slots_[id] = first;
        global_types_[id] = constant.type;
        const Type& scalar = module_.types.scalar_of(constant.type);
        for (std::size_t i = 0; i < constant.bits.size(); ++i)
            code_.constants.push_back({.slot = static_cast<Slot>(first + i),
                                       .bits = constant.bits[i],
                                       .is_float = scalar.kind == Type::Kind::real});
    }
    for (const auto& [id, type] : module_.undefined) {
        global_slots_[id] = new_slots(module_.types.slots(type));
        global_types_[id] = type;
    }
    static const Function none{};
    scope_.function = &none;
    for (const module::Instruction& i : module_.computed_constants) {
        // [length | OpSpecConstantOp, type, result, opcode, operands...] rewritten as an instruction with
        // that opcode.
        computed_.emplace_back(i.words.begin(), i.words.end());
        std::vector<std::uint32_t>& words = computed_.back();
        std::uint32_t opcode = SpvOpCompositeConstruct;
        if (i.opcode == SpvOpSpecConstantOp) {
            opcode = i.word(3);
            if (words.size() > 3) words.erase(words.begin() + 3);
        }
        words[0] = static_cast<std::uint32_t>(words.size()) << 16U | opcode;
        global_slots_[i.word(2)] = new_slots(module_.types.slots(i.word(1)));
        global_types_[i.word(2)] = i.word(1);
        lower({.at = i.at, .opcode = opcode, .words = words});
    }
    for (const module::Instruction& variable : module_.variables) place_variable(variable);
}

Code Lowering::run(const std::string& entry_point) {
    code_.places.push_back({});
    code_.variables.emplace_back();
    place_globals();
    scope_ = {};
    lower_function(module_.function(module_.entry_point(entry_point)));
    emit(finish, 0, 0);
    for (const Edge& edge : code_.edges) {
        std::uint32_t copied = 0;
        for (const Edge::Copy& part : edge.copies) copied += part.count;
        code_.most_copies = std::max(code_.most_copies, copied);
    }
    return std::move(code_);
}

// Allocates slots for every result of the function before its first use, because a phi can refer to a later
// result.
void Lowering::allocate_results(const Function& function) {
    for (const module::Instruction& i : function.body) {
        const auto [has_result, has_type] = module::spirv::result_shape(i.opcode);
        if (!has_result || !has_type || i.opcode == SpvOpFunctionParameter) continue;
        const Type& type = module_.types.at(i.word(1));
        scope_.types[i.word(2)] = i.word(1);
        if (type.kind == Type::Kind::pointer || type.kind == Type::Kind::void_) continue;
        if (!scope_.slots.contains(i.word(2))) scope_.slots[i.word(2)] = new_slots(type.slots);
    }
}

void Lowering::lower_function(const Function& function) {
    if (std::ranges::find(calls_, function.id) != calls_.end())
        fail(Error::Kind::malformed, module_.name_of(function.id) + " calls itself");
    const auto has_code = [](const module::Instruction& i) {
        return i.opcode != SpvOpFunctionParameter && i.opcode != SpvOpLine;
    };
    if (std::ranges::none_of(function.body, has_code))
        fail(Error::Kind::missing, module_.name_of(function.id) + " has no body");
    calls_.push_back(function.id);
    const Location caller = place_;
    scope_.function = &function;
    allocate_results(function);
    if (module_.meets() && calls_.size() > 1) {
        scope_.returns.push_back(new_edge());
        emit(construct, 0, 0).extra = scope_.returns.back();
    }
    const auto enter_line = [this](const module::Instruction& line) {
        place_.file = module_.string_of(line.word(1));
        place_.line = line.word(2);
    };
    // Instructions before the first line of their own belong to the first statement: the front end evaluates
    // a condition before it states the line of the branch.
    for (const module::Instruction& i : function.body) {
        if (i.opcode != SpvOpLine) continue;
        enter_line(i);
        if (&i != &function.body.front()) break;
    }
    for (const module::Instruction& i : function.body) {
        if (i.opcode == SpvOpLine && &i != &function.body.front()) enter_line(i);
        lower(i);
    }
    close_edges();
    place_ = caller;
    calls_.pop_back();
}

void Lowering::close_edges() {
    for (const Scope::OpenEdge& open : scope_.open_edges) {
        Edge& edge = code_.edges[open.edge];
        const auto target = scope_.blocks.find(open.to);
        if (target == scope_.blocks.end()) fail(Error::Kind::malformed, fmt::format("no block {}", open.to));
        edge.target = target->second;
        for (const Scope::Phi& phi : scope_.phis[open.to]) {
            for (const auto& [value, before] : phi.values) {
                if (before == open.from) edge.copies.push_back({phi.result, slot_of(value), phi.count});
            }
        }
        for (const Edge::Copy& one : edge.copies) {
            for (const Edge::Copy& other : edge.copies)
                edge.through_memory =
                    edge.through_memory ||
                    (&one != &other && one.to < other.from + other.count && other.from < one.to + one.count);
        }
    }
    const auto end = static_cast<std::uint32_t>(code_.instructions.size());
    for (const std::uint32_t edge : scope_.returns) code_.edges[edge].target = end;
}

void Lowering::lower(const module::Instruction& i) {
    constexpr std::array<std::uint32_t, 4> without_code{SpvOpNop, SpvOpLine, SpvOpNoLine,
                                                        SpvOpFunctionParameter};
    if (std::ranges::find(without_code, i.opcode) != without_code.end()) return;
    remember_place(i);
    lower_control(i);
}

}  // namespace gloam::interpreter::internal
