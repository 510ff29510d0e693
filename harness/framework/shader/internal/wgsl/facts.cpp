// SPDX-License-Identifier: MIT
#include "shader/internal/wgsl/module.hpp"

#include <algorithm>

#include "shader/wgsl.hpp"

namespace gloam::shader::internal::wgsl {
namespace {

bool is_atomic_operation(std::uint32_t opcode) {
    return opcode >= SpvOpAtomicLoad && opcode <= SpvOpAtomicXor;
}

}  // namespace

Facts::Facts(const Module& module, const std::vector<shader::Function>& declared) : module_(module) {
    for (const Variable& variable : module.variables) {
        globals_of_module_.insert(variable.id);
        uses_[variable.id];
    }
    for (const Function& function : module.functions)
        for (const auto& [label, block] : function.blocks)
            for (const Instruction& i : block.body) {
                if (i.opcode == SpvOpAccessChain || i.opcode == SpvOpInBoundsAccessChain)
                    chains_[i.word(2)] = i;
                if (i.opcode == SpvOpLoad) loaded_[i.word(2)] = i.word(3);
                if (i.opcode == SpvOpFunctionCall) call_sites_[i.word(3)].push_back(i);
            }
    for (const Function& function : module.functions) {
        if (!facts_.contains(function.id)) read_function(function);
    }
    for (const Function& function : module.functions)
        decide_passing(function, declaration_of(module, function, declared));
}

Id Facts::base_of(Id pointer) const {
    const auto chain = chains_.find(pointer);
    return chain == chains_.end() ? pointer : base_of(chain->second.word(3));
}

Id Facts::image_of(Id value) const {
    const auto found = loaded_.find(value);
    return found == loaded_.end() ? value : found->second;
}

void Facts::read_function(const Function& function) {
    facts_[function.id];
    calls_[function.id];
    globals_[function.id];
    for (const Id parameter : function.parameters) uses_[parameter];
    for (const Variable& variable : function.variables) uses_[variable.id];
    FunctionFacts facts;
    for (const auto& [label, block] : function.blocks)
        for (const Instruction& i : block.body)
            if (i.opcode == SpvOpFunctionCall) {
                calls_[function.id].insert(i.word(3));
                const auto callee = std::ranges::find(module_.functions, i.word(3), &Function::id);
                if (callee != module_.functions.end() && !facts_.contains(callee->id)) read_function(*callee);
            }
    open_ = function.id;
    for (const Id label : function.order)
        for (const Instruction& i : function.block(label).body) read_use(i, facts);
    for (const Id callee : calls_[function.id])
        globals_[function.id].insert(globals_[callee].begin(), globals_[callee].end());
    std::erase_if(facts.pointers_written, [&](Id id) {
        return std::ranges::find(function.parameters, id) == function.parameters.end();
    });
    facts_[function.id] = std::move(facts);
}

void Facts::read_use(const Instruction& i, FunctionFacts& facts) {
    for (const Id id : operands(i))
        if (globals_of_module_.contains(base_of(id))) globals_[open_].insert(base_of(id));
    if (is_subgroup_operation(i.opcode) || is_derivative(i.opcode)) facts.changes_memory = true;
    switch (i.opcode) {
        case SpvOpStore:
            store_to(i.word(1), facts);
            break;
        case SpvOpLoad:
            load_from(i.word(3), facts);
            break;
        case SpvOpFunctionCall:
            read_call(i, facts);
            break;
        case SpvOpAccessChain:
        case SpvOpInBoundsAccessChain:
            if (uses_.contains(i.word(3))) ++uses_[i.word(3)].parts;
            break;
        case SpvOpImageWrite:
            written_.insert(image_of(i.word(1)));
            facts.changes_memory = true;
            break;
        case SpvOpControlBarrier:
        case SpvOpMemoryBarrier:
        case SpvOpEmitVertex:
            facts.changes_memory = true;
            break;
        case SpvOpImageSampleImplicitLod:
        case SpvOpImageSampleExplicitLod:
        case SpvOpImageGather:
            sampled_.insert(image_of(i.word(3)));
            break;
        case SpvOpImageRead:
        case SpvOpImageFetch:
            read_.insert(image_of(i.word(3)));
            facts.reads_memory = true;
            break;
        default:
            if (is_atomic_operation(i.opcode)) {
                facts.changes_memory = facts.reads_memory = true;
                read_atomic(i);
            }
            for (const Id id : operands(i))
                if (uses_.contains(id)) ++uses_[id].parts;
    }
}

void Facts::read_atomic(const Instruction& i) {
    const Id pointer = i.opcode == SpvOpAtomicStore ? i.word(1) : i.word(3);
    written_.insert(base_of(pointer));
    if (const auto owner = owner_of(pointer)) {
        atomic_members_.insert(*owner);
    } else {
        atomic_variables_.insert(base_of(pointer));
    }
}

std::optional<std::pair<Id, std::uint32_t>> Facts::owner_of(Id pointer) const {
    const auto chain = chains_.find(pointer);
    if (chain == chains_.end()) return std::nullopt;
    std::optional<std::pair<Id, std::uint32_t>> owner = owner_of(chain->second.word(3));
    Id type = module_.pointee(chain->second.word(3));
    for (std::size_t w = 4; w < chain->second.words.size(); ++w) {
        const Type& here = module_.type(type);
        const bool structure = here.kind == TypeKind::structure;
        const std::uint32_t member = structure ? module_.integer(chain->second.word(w)).value_or(0) : 0;
        if (structure) owner = std::pair(type, member);
        type = structure ? here.members.at(member).type : here.element;
    }
    return owner;
}

bool Facts::is_atomic_pointer(Id pointer) const {
    const auto owner = owner_of(pointer);
    return owner ? atomic_members_.contains(*owner) : atomic_variables_.contains(base_of(pointer));
}

void Facts::store_to(Id pointer, FunctionFacts& facts) {
    const Id base = base_of(pointer);
    written_.insert(base);
    ++uses_[base].changes;
    uses_[base].changes_after_load |= uses_[base].loads > 0;
    if (base == pointer) ++uses_[base].stores;
    const std::uint32_t storage = module_.value_type(base).storage;
    if (globals_of_module_.contains(base) || storage != SpvStorageClassFunction) {
        facts.changes_memory = true;
    } else {
        facts.pointers_written.insert(base);
    }
}

void Facts::load_from(Id pointer, FunctionFacts& facts) {
    const Id base = base_of(pointer);
    if (module_.is_opaque(module_.pointee(base))) return;
    read_.insert(base);
    if (base == pointer) ++uses_[base].loads;
    if (!globals_of_module_.contains(base)) return;
    const std::uint32_t storage = module_.value_type(base).storage;
    const bool constant = storage == SpvStorageClassUniformConstant || storage == SpvStorageClassInput;
    if (!constant) facts.reads_memory = true;
}

void Facts::read_call(const Instruction& i, FunctionFacts& facts) {
    const FunctionFacts& callee = facts_[i.word(3)];
    const auto function = std::ranges::find(module_.functions, i.word(3), &Function::id);
    facts.changes_memory |= callee.changes_memory;
    facts.reads_memory |= callee.reads_memory;
    for (std::size_t p = 0; p + 4 < i.words.size(); ++p) {
        const Id argument = i.word(p + 4);
        const Id base = base_of(argument);
        if (uses_.contains(argument)) ++uses_[argument].calls;
        if (function != module_.functions.end() && sampled_.contains(function->parameters.at(p)))
            sampled_.insert(argument);
        const bool written = function != module_.functions.end() &&
                             callee.pointers_written.contains(function->parameters.at(p));
        if (written && globals_of_module_.contains(base)) facts.changes_memory = true;
        if (written) {
            ++uses_[base].changes;
            facts.pointers_written.insert(base);
            written_.insert(base);
        }
    }
}

namespace {

bool fits(const Module& module, Id id, const shader::Type& declared) {
    const Type& type = module.type(id);
    if (type.kind == TypeKind::structure) return declared.name == module.name_of(id);
    if (type.kind == TypeKind::matrix)
        return declared.columns == static_cast<int>(type.count) && fits(module, type.element,
                                                                        {.scalar = declared.scalar,
                                                                         .columns = 1,
                                                                         .rows = declared.rows,
                                                                         .members = {},
                                                                         .name = {}});
    const auto scalar = module.is_float(id)    ? Scalar::float_
                        : module.is_signed(id) ? Scalar::int_
                        : module.is_bool(id)   ? Scalar::bool_
                                               : Scalar::uint_;
    if (module.is_half(id)) return declared.scalar == Scalar::float16_;
    const bool simple = type.kind != TypeKind::array && !module.is_opaque(id);
    if (!simple) return declared.scalar == Scalar::unsupported;
    return declared.scalar == scalar && declared.columns == 1 &&
           declared.rows == static_cast<int>(module.components(id));
}

}  // namespace

const shader::Function* declaration_of(const Module& module, const Function& function,
                                       const std::vector<shader::Function>& declared) {
    const auto same = [&](const shader::Function& other) {
        if (other.name != module.name_of(function.id)) return false;
        if (other.parameters.size() != function.parameters.size()) return false;
        for (std::size_t p = 0; p < function.parameters.size(); ++p) {
            const Id type = module.type_of(function.parameters[p]);
            const bool pointer = module.type(type).kind == TypeKind::pointer;
            if (!fits(module, pointer ? module.type(type).element : type, other.parameters[p].type))
                return false;
        }
        return true;
    };
    const auto found = std::ranges::find_if(declared, same);
    return found == declared.end() ? nullptr : &*found;
}

// Whether all callers use the variable that they give for nothing else: then the parameter is no out.
bool Facts::only_given(Id function, std::size_t parameter) const {
    const auto sites = call_sites_.find(function);
    if (sites == call_sites_.end()) return false;
    return std::ranges::all_of(sites->second, [&](const Instruction& call) {
        const auto uses = uses_.find(call.word(parameter + 4));
        return uses != uses_.end() && uses->second.loads == 0 && uses->second.parts == 0 &&
               uses->second.calls == 1;
    });
}

void Facts::decide_passing(const Function& function, const shader::Function* declared) {
    FunctionFacts& facts = facts_[function.id];
    for (std::size_t p = 0; p < function.parameters.size(); ++p) {
        const Id parameter = function.parameters[p];
        const bool is_pointer = module_.value_type(parameter).kind == Type::Kind::pointer;
        Passing passing = Passing::value;
        const bool out = declared != nullptr && declared->parameters[p].direction != Direction::in;
        if (is_pointer && (facts.pointers_written.contains(parameter) || out)) {
            const bool in = declared != nullptr ? declared->parameters[p].direction == Direction::in
                                                : only_given(function.id, p);
            passing = in ? Passing::copied : Passing::pointer;
        }
        facts.passing.push_back(passing);
    }
}

}  // namespace gloam::shader::internal::wgsl
