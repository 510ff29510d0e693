// SPDX-License-Identifier: MIT
// Instructions as expressions and statements.
#include <GLSL.std.450.h>
#include <fmt/format.h>

#include <algorithm>

#include "shader/internal/wgsl/function_writer.hpp"
#include "shader/wgsl.hpp"

namespace gloam::shader::internal::wgsl {

std::vector<Expression> FunctionWriter::take_all(const Instruction& i) {
    std::vector<Expression> all;
    for (const Id id : operands(i)) all.push_back(take(id));
    return all;
}

void FunctionWriter::instruction(const Instruction& i, Statements& out) {
    if (shape_.idle.contains(i.at)) return;
    if (i.opcode == SpvOpPhi) {
        const Id result = i.word(2);
        const auto only = shape_.only_values.find(result);
        if (only != shape_.only_values.end()) {
            define(result, take(only->second), out);
        } else if (!shape_.fold_results.contains(result)) {
            values_[result] = {.text = mark(result), .reads = {result}};
        }
        return;
    }
    if (memory_access(i, out) || image_access(i, out) || atomic_access(i, out) ||
        subgroup_operation(i, out) || derivative(i, out))
        return;
    // The operands of a value that nobody uses stay where they are.
    if (result_of(i) != 0 && shape_.uses[result_of(i)] == 0) return;
    if (!value(i, out)) throw NotTranslated(fmt::format("the instruction {} of SPIR-V", i.opcode));
}

// The names that WGSL has for the members of results of more than one value.
static std::vector<std::string> names_of_members(const Instruction& i) {
    if (i.opcode == SpvOpIAddCarry || i.opcode == SpvOpISubBorrow || i.opcode == SpvOpUMulExtended)
        return {"x", "y"};
    if (i.opcode != SpvOpExtInst) return {};
    if (i.word(4) == GLSLstd450FrexpStruct) return {"fract", "exp"};
    if (i.word(4) == GLSLstd450ModfStruct) return {"fract", "whole"};
    return {};
}

bool FunctionWriter::value(const Instruction& i, Statements& out) {
    if (i.opcode == SpvOpCompositeExtract && member_names_.contains(i.word(3))) {
        const std::string member = member_names_.at(i.word(3)).at(i.word(4));
        Expression from = take(i.word(3));
        from.text = primary(from) + "." + member;
        define(i.word(2), from, out);
        return true;
    }
    if (i.opcode == SpvOpCompositeInsert || i.opcode == SpvOpVectorInsertDynamic) {
        insert(i, out);
        return true;
    }
    if (i.opcode == SpvOpExtInst && (i.word(4) == GLSLstd450Modf || i.word(4) == GLSLstd450Frexp)) {
        split_number(i, out);
        return true;
    }
    if (const auto names = names_of_members(i); !names.empty()) member_names_[i.word(2)] = names;
    Expression result;
    const std::vector<Expression> parts = take_all(i);
    const bool known = i.opcode == SpvOpExtInst ? extended_operation(text_, i, parts, result)
                                                : operation(text_, i, parts, result);
    if (!known) return false;
    for (const Expression& part : parts) result.reads.insert(part.reads.begin(), part.reads.end());
    define(i.word(2), result, out);
    return true;
}

// modf() and frexp(), which give their second value by a pointer.
void FunctionWriter::split_number(const Instruction& i, Statements& out) {
    const bool modf = i.word(4) == GLSLstd450Modf;
    const Id pair = copy_of(i.word(2));
    body_.wanted_names[pair] = "t";
    out.push_back({.kind = StatementKind::assign,
                   .target = pair,
                   .value = call(modf ? "modf" : "frexp", {take(i.word(5))}).text});
    store_value(i.word(6), {.text = mark(pair) + (modf ? ".whole" : ".exp")}, out);
    define(i.word(2), {.text = mark(pair) + ".fract"}, out);
}

// A copy of which one part is changed.
void FunctionWriter::insert(const Instruction& i, Statements& out) {
    const Id result = i.word(2);
    const bool dynamic = i.opcode == SpvOpVectorInsertDynamic;
    const Expression whole = take(i.word(dynamic ? 3 : 4));
    const Expression part = take(i.word(dynamic ? 4 : 3));
    keep(result, whole, out);
    body_.addressed.insert(result);
    std::string place = mark(result);
    Id type = i.word(1);
    if (dynamic) {
        place += "[" + take(i.word(5)).text + "]";
    } else {
        for (std::size_t w = 5; w < i.words.size(); ++w) {
            const Type& here = module_.type(type);
            const bool member = here.kind == Type::Kind::structure;
            place += member ? "." + text_.member_name(type, i.word(w)) : fmt::format("[{}]", i.word(w));
            type = member ? here.members.at(i.word(w)).type : here.element;
        }
    }
    out.push_back({.kind = StatementKind::assign, .text = place, .value = part.text});
}

bool FunctionWriter::memory_access(const Instruction& i, Statements& out) {
    switch (i.opcode) {
        case SpvOpAccessChain:
        case SpvOpInBoundsAccessChain: {
            const Expression place = chain(i, out);
            values_[i.word(2)] = place;
            chain_uses_[i.word(2)] = shape_.uses[i.word(2)];
            return true;
        }
        case SpvOpLoad:
            load(i, out);
            return true;
        case SpvOpStore:
            store(i, out);
            return true;
        case SpvOpCopyMemory: {
            const Expression value = pointer(i.word(2));
            const Expression place = pointer(i.word(1));
            before_change(facts_.base_of(i.word(1)), out);
            out.push_back({.kind = StatementKind::assign, .text = place.text, .value = value.text});
            return true;
        }
        case SpvOpArrayLength: {
            const Id structure = module_.pointee(i.word(3));
            Expression length = pointer(i.word(3));
            length.text =
                fmt::format("arrayLength(&{}.{})", length.text, text_.member_name(structure, i.word(4)));
            length.reads.clear();
            define(i.word(2), length, out);
            return true;
        }
        case SpvOpFunctionCall:
            call_function(i, out);
            return true;
        case SpvOpControlBarrier:
        case SpvOpMemoryBarrier:
            barrier(i, out);
            return true;
        default:
            return false;
    }
}

// The place that a pointer means.
Expression FunctionWriter::pointer(Id given) {
    const Id id = same(given);
    if (const auto chained = values_.find(id); chained != values_.end() && chain_uses_.contains(id)) {
        --chain_uses_[id];
        return chained->second;
    }
    if (text_.has_name(id)) {
        const std::uint32_t storage = module_.value_type(id).storage;
        const bool changes = storage != SpvStorageClassInput && storage != SpvStorageClassUniform;
        const bool constant = storage == SpvStorageClassPushConstant || !facts_.is_written(id);
        Expression result = plain(text_.name(id));
        if (changes && !constant) result.reads = {memory};
        return result;
    }
    const auto parameter = std::ranges::find(function_.parameters, id);
    if (parameter == function_.parameters.end()) {
        // What is set once and has been set does not change any more.
        const VariableUses& uses = facts_.uses_of(id);
        const bool choice = module_.name_of(id).empty() && uses.loads == 1 && !uses.changes_after_load;
        if (choice || set_once_.contains(id)) return {.text = mark(id)};
        return {.text = mark(id), .reads = {id}};
    }
    const auto p = static_cast<std::size_t>(parameter - function_.parameters.begin());
    switch (facts_.of(function_.id).passing.at(p)) {
        case Passing::value:
            return {.text = mark(id)};
        case Passing::copied:
            return {.text = mark(id), .reads = {id}};
        default:
            return {.text = "*" + mark(id), .level = Level::unary, .reads = {id}};
    }
}

Expression FunctionWriter::chain(const Instruction& i, Statements& out) {
    const Expression base = pointer(i.word(3));
    Expression result = plain(primary(base));
    result.reads = base.reads;
    std::set<Id> index_reads;
    Id type = module_.pointee(i.word(3));
    for (std::size_t w = 4; w < i.words.size(); ++w) {
        const Type& here = module_.type(type);
        const auto constant = module_.integer(i.word(w));
        if (here.kind == Type::Kind::structure) {
            result.text += "." + text_.member_name(type, constant.value_or(0));
            type = here.members.at(constant.value_or(0)).type;
            continue;
        }
        type = here.element;
        if (here.kind == Type::Kind::vector && constant) {
            result.text += std::string(".") + "xyzw"[*constant & 3U];
            result.component = true;
            continue;
        }
        Expression index = take(i.word(w));
        if (kept_indices_.contains(i.word(2)) && !index.reads.empty()) {
            keep(i.word(w), index, out);
            index = values_[i.word(w)];
        }
        result.text += "[" + index.text + "]";
        index_reads.insert(index.reads.begin(), index.reads.end());
    }
    const Id outer = i.word(3);
    if (const auto of_outer = chain_reads_.find(outer); of_outer != chain_reads_.end())
        index_reads.insert(of_outer->second.begin(), of_outer->second.end());
    result.reads.insert(index_reads.begin(), index_reads.end());
    chain_reads_[i.word(2)] = index_reads;
    return result;
}

void FunctionWriter::load(const Instruction& i, Statements& out) {
    const Id from = i.word(3);
    if (module_.is_opaque(i.word(1))) {
        values_[i.word(2)] = opaque(from);
        return;
    }
    if (shape_.fold_results.contains(from)) {
        define(i.word(2), take(from), out);
        return;
    }
    if (shape_.uses[i.word(2)] == 0) return;
    Expression place = pointer(from);
    if (facts_.is_atomic_pointer(from)) {
        const std::set<Id> reads = place.reads;
        place = call("atomicLoad", {plain("&" + place.text)});
        place.reads = reads;
    }
    define(i.word(2), place, out);
}

void FunctionWriter::store(const Instruction& i, Statements& out) {
    const Id to = same(i.word(1));
    if (shape_.fold_results.contains(to)) return;
    const Expression value = take(i.word(2));
    if (shape_.bound.contains(to)) {
        values_[to] = value;
        pending_.push_back(to);
        return;
    }
    store_value(to, value, out);
}

void FunctionWriter::store_value(Id given, const Expression& value, Statements& out) {
    const Id to = same(given);
    const Id base = facts_.base_of(to);
    const bool local = body_.types.contains(base) && !text_.has_name(base);
    if (local && base == to) return assign(to, value, out);
    const bool atomic = facts_.is_atomic_pointer(to);
    const Expression place = pointer(to);
    before_change(local || std::ranges::count(function_.parameters, base) > 0 ? base : memory, out);
    if (local) body_.addressed.insert(base);
    if (atomic) {
        out.push_back({.value = call("atomicStore", {plain("&" + place.text), value}).text});
    } else {
        out.push_back({.kind = StatementKind::assign, .text = place.text, .value = value.text});
    }
}

Expression FunctionWriter::argument_of(Id argument, Passing passing) {
    if (shape_.bound.contains(argument) || values_.contains(argument)) return take(argument);
    if (module_.constant(argument) != nullptr) return take(argument);
    if (passing != Passing::pointer) return pointer(argument);
    Expression place = pointer(argument);
    const Id variable = same(argument);
    if (text_.has_name(variable))
        throw NotTranslated("an out parameter that is given a variable of the module");
    body_.addressed.insert(variable);
    // *p of a pointer is the pointer itself.
    place.text = place.level == Level::unary ? place.text.substr(1) : "&" + place.text;
    return plain(place.text);
}

bool FunctionWriter::is_parameter(Id id) const {
    return std::ranges::find(function_.parameters, id) != function_.parameters.end();
}

// An image or a sampler, of the module or a parameter.
Expression FunctionWriter::opaque(Id variable) const {
    if (is_parameter(variable)) return plain(mark(variable));
    if (!text_.has_name(variable)) throw NotTranslated("an image or a sampler in an array");
    return plain(text_.name(variable));
}

Expression FunctionWriter::sampler_of(Id variable) const {
    return plain(is_parameter(variable) ? mark(sampler_parameter(variable)) : text_.sampler_of(variable));
}

void FunctionWriter::call_function(const Instruction& i, Statements& out) {
    const FunctionFacts& callee = facts_.of(i.word(3));
    const auto called = std::ranges::find(module_.functions, i.word(3), &Function::id);
    std::vector<Expression> arguments;
    std::vector<Id> changed;
    for (std::size_t p = 0; p < callee.passing.size(); ++p) {
        const Id argument = i.word(p + 4);
        const Id parameter = called->parameters.at(p);
        if (const Type& type = module_.value_type(parameter);
            type.kind == TypeKind::pointer && module_.is_opaque(type.element)) {
            arguments.push_back(opaque(argument));
            if (module_.type(type.element).kind == TypeKind::sampled_image && facts_.is_sampled(parameter))
                arguments.push_back(sampler_of(argument));
            continue;
        }
        arguments.push_back(argument_of(argument, callee.passing[p]));
        if (callee.passing[p] == Passing::pointer) changed.push_back(same(argument));
    }
    Expression result = call(text_.name(i.word(3)), arguments);
    if (callee.reads_memory) result.reads.insert(memory);
    const bool nothing = module_.type(i.word(1)).kind == Type::Kind::void_;
    if (!nothing && changed.empty() && !callee.changes_memory) return define(i.word(2), result, out);
    for (const Id variable : changed) before_change(variable, out);
    if (callee.changes_memory) before_change(memory, out);
    if (nothing) {
        out.push_back({.value = result.text});
    } else if (shape_.uses[i.word(2)] == 0) {
        out.push_back({.value = "_ = " + result.text});
    } else {
        keep(i.word(2), result, out);
    }
}

}  // namespace gloam::shader::internal::wgsl
