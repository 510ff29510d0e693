// SPDX-License-Identifier: MIT
#include "module/metamorphic.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "module/internal/changes.hpp"

namespace gloam::shader {
namespace internal {
namespace {

constexpr std::uint32_t word_bits = 32;

// The scalar of a vector or scalar type.
Id scalar_of(const Editable& module, Id type) {
    const Op* op = module.global(type);
    return op != nullptr && op->opcode == SpvOpTypeVector ? op->operands()[0] : type;
}

// The type with the same shape as `type` and another scalar.
Id with_scalar(Editable& module, Id type, Id scalar) {
    const Op* op = module.global(type);
    if (op->opcode != SpvOpTypeVector) return scalar;
    const std::uint32_t size = op->operands()[1];
    return module.global_of(SpvOpTypeVector, 0, {scalar, size});
}

bool is_32_bits(const Editable& module, Id type, std::uint32_t opcode) {
    const Op* op = module.global(scalar_of(module, type));
    return op != nullptr && op->opcode == opcode && op->operands()[0] == word_bits;
}

// Operations whose results do not depend on the order of their operands, bit for bit.
bool commutes(std::uint32_t opcode) {
    constexpr std::array all{SpvOpIAdd,
                             SpvOpFAdd,
                             SpvOpIMul,
                             SpvOpFMul,
                             SpvOpBitwiseAnd,
                             SpvOpBitwiseOr,
                             SpvOpBitwiseXor,
                             SpvOpLogicalAnd,
                             SpvOpLogicalOr,
                             SpvOpLogicalEqual,
                             SpvOpLogicalNotEqual,
                             SpvOpIEqual,
                             SpvOpINotEqual,
                             SpvOpFOrdEqual,
                             SpvOpFUnordNotEqual};
    return std::ranges::find(all, opcode) != all.end();
}

bool can_commute(const Editable& module, const Spot& spot) {
    return commutes(at(module, spot).opcode);
}

bool commute(Editable& module, const Spot& spot, Chance&) {
    std::vector<std::uint32_t>& words = at(module, spot).words;
    std::swap(words[2], words[3]);
    return true;
}

std::uint32_t turned_round(std::uint32_t opcode) {
    constexpr std::array<std::array<SpvOp, 2>, 8> pairs{
        {{SpvOpFOrdLessThan, SpvOpFOrdGreaterThan},
         {SpvOpFOrdLessThanEqual, SpvOpFOrdGreaterThanEqual},
         {SpvOpFUnordLessThan, SpvOpFUnordGreaterThan},
         {SpvOpFUnordLessThanEqual, SpvOpFUnordGreaterThanEqual},
         {SpvOpSLessThan, SpvOpSGreaterThan},
         {SpvOpSLessThanEqual, SpvOpSGreaterThanEqual},
         {SpvOpULessThan, SpvOpUGreaterThan},
         {SpvOpULessThanEqual, SpvOpUGreaterThanEqual}}};
    for (const auto& [a, b] : pairs) {
        if (opcode == a) return b;
        if (opcode == b) return a;
    }
    return SpvOpNop;
}

bool can_turn(const Editable& module, const Spot& spot) {
    return turned_round(at(module, spot).opcode) != SpvOpNop;
}

bool turn_comparison(Editable& module, const Spot& spot, Chance&) {
    Op& op = at(module, spot);
    op.opcode = turned_round(op.opcode);
    std::swap(op.words[2], op.words[3]);
    return true;
}

// Operations of one component of each operand.
bool can_take_apart(const Editable& module, const Spot& spot) {
    const Op& op = at(module, spot);
    const bool by_component = (op.opcode >= SpvOpSNegate && op.opcode <= SpvOpFMod) ||
                              (op.opcode >= SpvOpShiftRightLogical && op.opcode <= SpvOpNot);
    const Op* type = op.type() == 0 ? nullptr : module.global(op.type());
    return by_component && type != nullptr && type->opcode == SpvOpTypeVector;
}

bool take_vector_apart(Editable& module, const Spot& spot, Chance&) {
    const Op op = at(module, spot);
    const std::map<Id, Id> types = module.types_of(spot);
    const std::uint32_t size = module.global(op.type())->operands()[1];
    std::vector<Op> made;
    Op whole{SpvOpCompositeConstruct, {op.type(), op.result()}};
    for (std::uint32_t c = 0; c < size; ++c) {
        Op part{op.opcode, {scalar_of(module, op.type()), module.fresh()}};
        for (const Id operand : op.operands()) {
            made.push_back(
                {SpvOpCompositeExtract, {scalar_of(module, types.at(operand)), module.fresh(), operand, c}});
            part.words.push_back(made.back().result());
        }
        module.share_decorations(op.result(), part.result(), c + 1 == size);
        whole.words.push_back(part.result());
        made.push_back(std::move(part));
    }
    at(module, spot) = std::move(whole);
    module.insert(spot, made);
    return true;
}

// Operations without memory, control and pointers.
bool is_pure(const Editable& module, const Spot& spot) {
    const Op& op = at(module, spot);
    if (!op.knows_ids() || op.type() == 0 || !module.is_of_numbers(op.type())) return false;
    const bool of_memory = op.opcode == SpvOpLoad || op.opcode == SpvOpFunctionCall;
    const bool of_derivatives = op.opcode >= SpvOpDPdx && op.opcode <= SpvOpFwidthCoarse;
    return !of_memory && !of_derivatives;
}

bool outline(Editable& module, const Spot& spot, Chance&) {
    Op inner = at(module, spot);
    const std::map<Id, Id> types = module.types_of(spot);
    FunctionBody made;
    std::vector<std::uint32_t> signature{inner.type()};
    Op call{SpvOpFunctionCall, {inner.type(), inner.result(), module.fresh()}};
    bool numbers = true;
    inner.visit_ids([&](std::uint32_t& id) {
        const Id type = types.at(id);
        numbers = numbers && module.is_of_numbers(type);
        call.words.push_back(id);
        signature.push_back(type);
        made.parameters.push_back({SpvOpFunctionParameter, {type, module.fresh()}});
        id = made.parameters.back().result();
    });
    if (!numbers) return false;
    const Id result = module.fresh();
    module.share_decorations(inner.result(), result, true);
    inner.set_result(result);
    made.header = {SpvOpFunction,
                   {inner.type(), call.operands()[0], SpvFunctionControlMaskNone,
                    module.global_of(SpvOpTypeFunction, 0, signature)}};
    made.blocks.push_back({{Op{SpvOpLabel, {module.fresh()}}, inner, Op{SpvOpReturnValue, {result}}}});
    at(module, spot) = std::move(call);
    module.functions.push_back(std::move(made));
    return true;
}

bool is_result(const Editable& module, const Spot& spot) {
    const Op& op = at(module, spot);
    return op.type() != 0 && op.result() != 0 && op.opcode != SpvOpPhi && op.opcode != SpvOpVariable &&
           module.is_of_numbers(op.type());
}

bool is_float_result(const Editable& module, const Spot& spot) {
    return is_result(module, spot) && is_32_bits(module, at(module, spot).type(), SpvOpTypeFloat);
}

bool is_integer_result(const Editable& module, const Spot& spot) {
    return is_result(module, spot) && is_32_bits(module, at(module, spot).type(), SpvOpTypeInt);
}

bool can_select(const Editable& module, const Spot& spot) {
    if (!is_result(module, spot)) return false;
    const Op* type = module.global(at(module, spot).type());
    return type->opcode != SpvOpTypeMatrix && (type->opcode != SpvOpTypeVector || module.selects_vectors());
}

// A result that something is done to: the operation gets another ID, and what is done gives the old one.
struct Result {
    Spot after;
    Id type = 0;
    Id id = 0;     // to give
    Id value = 0;  // to take
};

Result result_at(Editable& module, const Spot& spot) {
    Op& op = at(module, spot);
    Result result{{spot.function, spot.block, spot.op + 1}, op.type(), op.result(), module.fresh()};
    op.set_result(result.value);
    module.share_decorations(result.id, result.value, true);
    return result;
}

bool do_twice(Editable& module, const Spot& spot, std::uint32_t opcode) {
    const Result result = result_at(module, spot);
    const Id once = module.fresh();
    module.insert(result.after,
                  {{opcode, {result.type, once, result.value}}, {opcode, {result.type, result.id, once}}});
    return true;
}

bool negate_twice(Editable& module, const Spot& spot, Chance&) {
    return do_twice(module, spot, SpvOpFNegate);
}

bool invert_twice(Editable& module, const Spot& spot, Chance&) {
    return do_twice(module, spot, SpvOpNot);
}

bool reinterpret_twice(Editable& module, const Spot& spot, Chance&) {
    const Result result = result_at(module, spot);
    const Id bits = module.fresh();
    const Id bits_type = with_scalar(module, result.type, module.uint_type());
    module.insert(result.after, {{SpvOpBitcast, {bits_type, bits, result.value}},
                                 {SpvOpBitcast, {result.type, result.id, bits}}});
    return true;
}

bool select_it(Editable& module, const Spot& spot, Chance& chance) {
    const Result result = result_at(module, spot);
    Opaque no = opaque_false(module, chance);
    const Id other = module.global_of(SpvOpConstantNull, result.type, {});
    no.ops.push_back({SpvOpSelect, {result.type, result.id, no.id, other, result.value}});
    module.insert(result.after, no.ops);
    return true;
}

bool is_constant(const Editable& module, Id id) {
    const Op* op = module.global(id);
    return op != nullptr && (op->opcode == SpvOpConstant || op->opcode == SpvOpConstantComposite) &&
           (is_32_bits(module, op->type(), SpvOpTypeFloat) || is_32_bits(module, op->type(), SpvOpTypeInt));
}

bool can_hide_constant(const Editable& module, const Spot& spot) {
    const Op& op = at(module, spot);
    return is_pure(module, spot) && op.opcode != SpvOpExtInst && op.opcode != SpvOpCompositeExtract &&
           op.opcode != SpvOpVectorShuffle &&
           std::ranges::any_of(op.operands(), [&](Id id) { return is_constant(module, id); });
}

// c + 0, where only the device knows the 0.
bool hide_constant(Editable& module, const Spot& spot, Chance& chance) {
    Op changed = at(module, spot);
    std::size_t place = changed.words.size() - changed.operands().size();
    while (!is_constant(module, changed.words[place])) ++place;
    const Op constant = *module.global(changed.words[place]);
    const Id bits_type = with_scalar(module, constant.type(), module.uint_type());
    const Id one = module.uint_constant(1);
    Id ones = one;
    if (bits_type != module.uint_type())
        ones = module.global_of(SpvOpConstantComposite, bits_type,
                                std::vector<std::uint32_t>(module.global(bits_type)->operands()[1], one));
    Opaque no = opaque_false(module, chance);
    const Id zero = module.fresh();
    no.ops.push_back(
        {SpvOpSelect, {bits_type, zero, no.id, ones, module.global_of(SpvOpConstantNull, bits_type, {})}});
    const Id bits = module.fresh();
    const Id sum = module.fresh();
    const Id value = module.fresh();
    no.ops.push_back({SpvOpBitcast, {bits_type, bits, constant.result()}});
    no.ops.push_back({SpvOpIAdd, {bits_type, sum, bits, zero}});
    no.ops.push_back({SpvOpBitcast, {constant.type(), value, sum}});
    changed.words[place] = value;
    at(module, spot) = std::move(changed);
    module.insert(spot, no.ops);
    return true;
}

// A load or a store of a variable of one invocation.
bool is_private(const Editable& module, const Spot& spot, std::uint32_t opcode) {
    const Op& op = at(module, spot);
    if (op.opcode != opcode) return false;
    const Id pointer = opcode == SpvOpStore ? op.words[0] : op.operands()[0];
    const Op* type = module.global(module.types_of(spot).at(pointer));
    return type != nullptr && type->opcode == SpvOpTypePointer &&
           (type->operands()[0] == SpvStorageClassFunction || type->operands()[0] == SpvStorageClassPrivate);
}

bool is_private_load(const Editable& module, const Spot& spot) {
    return is_private(module, spot, SpvOpLoad);
}

bool is_private_store(const Editable& module, const Spot& spot) {
    return is_private(module, spot, SpvOpStore);
}

bool store_again(Editable& module, const Spot& spot, Chance&) {
    const Op& load = at(module, spot);
    module.insert({spot.function, spot.block, spot.op + 1},
                  {{SpvOpStore, {load.operands()[0], load.result()}}});
    return true;
}

bool store_before(Editable& module, const Spot& spot, Chance&) {
    const Op store = at(module, spot);
    const Id type = module.types_of(spot).at(store.words[1]);
    module.insert(spot, {{SpvOpStore, {store.words[0], module.global_of(SpvOpConstantNull, type, {})}}});
    return true;
}

}  // namespace

const std::vector<Change>& changes_of_values() {
    static const std::vector<Change> all{{"commuted operands", can_commute, commute},
                                         {"comparison turned round", can_turn, turn_comparison},
                                         {"vector taken apart", can_take_apart, take_vector_apart},
                                         {"operation outlined", is_pure, outline},
                                         {"negated twice", is_float_result, negate_twice},
                                         {"inverted twice", is_integer_result, invert_twice},
                                         {"reinterpreted twice", is_float_result, reinterpret_twice},
                                         {"selected", can_select, select_it},
                                         {"constant hidden", can_hide_constant, hide_constant},
                                         {"stored again", is_private_load, store_again},
                                         {"store before a store", is_private_store, store_before}};
    return all;
}

namespace {

bool is_made(const Change& change, Editable& module, Chance& chance) {
    std::vector<Spot> found;
    for (std::size_t f = 0; f < module.functions.size(); ++f)
        for (std::size_t b = 0; b < module.functions[f].blocks.size(); ++b)
            for (std::size_t i = 0; i < module.functions[f].blocks[b].ops.size(); ++i)
                if (change.accepts(module, {f, b, i})) found.push_back({f, b, i});
    return !found.empty() && change.make(module, chance.of(found), chance);
}

}  // namespace
}  // namespace internal

Metamorphism metamorphic(const Spirv& module, std::uint64_t seed, const std::vector<std::size_t>& positions) {
    internal::Editable editable(module);
    std::vector<internal::Change> all = internal::changes_of_values();
    all.insert(all.end(), internal::changes_of_flow().begin(), internal::changes_of_flow().end());
    Metamorphism made;
    for (const std::size_t position : positions) {
        // Each change has its own numbers, so that it is the same kind of change if others are left out.
        internal::Chance chance(seed * metamorphic_changes + position);
        const internal::Change& change = chance.of(all);
        if (internal::is_made(change, editable, chance)) made.changes.emplace_back(change.name);
    }
    made.module = editable.words();
    return made;
}

}  // namespace gloam::shader
