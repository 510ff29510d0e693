// SPDX-License-Identifier: MIT
#include "module/metamorphic.hpp"

#include <spirv.h>
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "module/internal/changes.hpp"

namespace gloam::shader {
namespace internal {
namespace {

constexpr std::uint32_t word_bits = 32;

Op& at(Editable& module, const Spot& spot) {
    return module.functions[spot.function].blocks[spot.block].ops[spot.op];
}

void insert(Editable& module, const Spot& spot, const std::vector<Op>& ops) {
    std::vector<Op>& all = module.functions[spot.function].blocks[spot.block].ops;
    all.insert(all.begin() + static_cast<std::ptrdiff_t>(spot.op), ops.begin(), ops.end());
}

std::optional<Spot> some(Chance& chance, const std::vector<Spot>& all) {
    return all.empty() ? std::nullopt : std::optional(chance.of(all));
}

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

bool commute(Editable& module, Chance& chance) {
    const auto spot = some(chance, spots(module, [](const Op& op) { return commutes(op.opcode); }));
    if (!spot) return false;
    std::vector<std::uint32_t>& words = at(module, *spot).words;
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

bool turn_comparison(Editable& module, Chance& chance) {
    const auto spot =
        some(chance, spots(module, [](const Op& op) { return turned_round(op.opcode) != SpvOpNop; }));
    if (!spot) return false;
    Op& op = at(module, *spot);
    op.opcode = turned_round(op.opcode);
    std::swap(op.words[2], op.words[3]);
    return true;
}

// Operations of one component of each operand.
bool is_by_component(std::uint32_t opcode) {
    return (opcode >= SpvOpSNegate && opcode <= SpvOpFMod) ||
           (opcode >= SpvOpShiftRightLogical && opcode <= SpvOpNot);
}

bool take_vector_apart(Editable& module, Chance& chance) {
    const auto accepts = [&](const Op& op) {
        const Op* type = op.type() == 0 ? nullptr : module.global(op.type());
        return is_by_component(op.opcode) && type != nullptr && type->opcode == SpvOpTypeVector;
    };
    const auto spot = some(chance, spots(module, accepts));
    if (!spot) return false;
    const Op op = at(module, *spot);
    const std::map<Id, Id> types = module.types_of(module.functions[spot->function]);
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
    at(module, *spot) = std::move(whole);
    insert(module, *spot, made);
    return true;
}

// Operations without memory, control and pointers.
bool is_pure(const Editable& module, const Op& op) {
    Op known = op;
    const bool has_ids = known.visit_ids([](std::uint32_t&) {});
    if (!has_ids || op.type() == 0 || !is_of_numbers(module, op.type())) return false;
    const bool of_memory = op.opcode == SpvOpLoad || op.opcode == SpvOpFunctionCall;
    const bool of_derivatives = op.opcode >= SpvOpDPdx && op.opcode <= SpvOpFwidthCoarse;
    return !of_memory && !of_derivatives;
}

bool outline(Editable& module, Chance& chance) {
    const auto spot = some(chance, spots(module, [&](const Op& op) { return is_pure(module, op); }));
    if (!spot) return false;
    Op inner = at(module, *spot);
    const std::map<Id, Id> types = module.types_of(module.functions[spot->function]);
    FunctionBody made;
    std::vector<std::uint32_t> signature{inner.type()};
    Op call{SpvOpFunctionCall, {inner.type(), inner.result(), module.fresh()}};
    bool numbers = true;
    inner.visit_ids([&](std::uint32_t& id) {
        const Id type = types.at(id);
        numbers = numbers && is_of_numbers(module, type);
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
    at(module, *spot) = std::move(call);
    module.functions.push_back(std::move(made));
    return true;
}

// A result that something is done to: the operation gets another ID, and what is done gives the old one.
struct Result {
    Spot after;
    Id type = 0;
    Id id = 0;     // to give
    Id value = 0;  // to take
};

template <class Accepts>
std::optional<Result> some_result(Editable& module, Chance& chance, const Accepts& accepts) {
    const auto spot = some(chance, spots(module, [&](const Op& op) {
                               const bool is_value = op.type() != 0 && op.result() != 0 &&
                                                     op.opcode != SpvOpPhi && op.opcode != SpvOpVariable;
                               return is_value && is_of_numbers(module, op.type()) && accepts(op);
                           }));
    if (!spot) return std::nullopt;
    Op& op = at(module, *spot);
    Result result{{spot->function, spot->block, spot->op + 1}, op.type(), op.result(), module.fresh()};
    op.set_result(result.value);
    module.share_decorations(result.id, result.value, true);
    return result;
}

bool do_twice(Editable& module, Chance& chance, std::uint32_t scalar, std::uint32_t opcode) {
    const auto result =
        some_result(module, chance, [&](const Op& op) { return is_32_bits(module, op.type(), scalar); });
    if (!result) return false;
    const Id once = module.fresh();
    insert(module, result->after,
           {{opcode, {result->type, once, result->value}}, {opcode, {result->type, result->id, once}}});
    return true;
}

bool negate_twice(Editable& module, Chance& chance) {
    return do_twice(module, chance, SpvOpTypeFloat, SpvOpFNegate);
}

bool invert_twice(Editable& module, Chance& chance) {
    return do_twice(module, chance, SpvOpTypeInt, SpvOpNot);
}

bool reinterpret_twice(Editable& module, Chance& chance) {
    const auto result = some_result(
        module, chance, [&](const Op& op) { return is_32_bits(module, op.type(), SpvOpTypeFloat); });
    if (!result) return false;
    const Id bits = module.fresh();
    const Id bits_type = with_scalar(module, result->type, module.uint_type());
    insert(
        module, result->after,
        {{SpvOpBitcast, {bits_type, bits, result->value}}, {SpvOpBitcast, {result->type, result->id, bits}}});
    return true;
}

bool select_it(Editable& module, Chance& chance) {
    const auto result = some_result(module, chance, [&](const Op& op) {
        const Op* type = module.global(op.type());
        return type->opcode != SpvOpTypeMatrix &&
               (type->opcode != SpvOpTypeVector || module.selects_vectors());
    });
    if (!result) return false;
    Opaque no = opaque_false(module, chance);
    const Id other = module.global_of(SpvOpConstantNull, result->type, {});
    no.ops.push_back({SpvOpSelect, {result->type, result->id, no.id, other, result->value}});
    insert(module, result->after, no.ops);
    return true;
}

// c + 0, where only the device knows the 0.
bool hide_constant(Editable& module, Chance& chance) {
    const auto is_constant = [&](Id id) {
        const Op* op = module.global(id);
        return op != nullptr && (op->opcode == SpvOpConstant || op->opcode == SpvOpConstantComposite) &&
               (is_32_bits(module, op->type(), SpvOpTypeFloat) ||
                is_32_bits(module, op->type(), SpvOpTypeInt));
    };
    const auto spot = some(chance, spots(module, [&](const Op& op) {
                               return is_pure(module, op) && op.opcode != SpvOpExtInst &&
                                      op.opcode != SpvOpCompositeExtract && op.opcode != SpvOpVectorShuffle &&
                                      std::ranges::any_of(op.operands(), is_constant);
                           }));
    if (!spot) return false;
    Op changed = at(module, *spot);
    const std::size_t first = changed.words.size() - changed.operands().size();
    std::size_t place = first;
    while (!is_constant(changed.words[place])) ++place;
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
    at(module, *spot) = std::move(changed);
    insert(module, *spot, no.ops);
    return true;
}

// Pointers to variables of one invocation.
bool is_private(const Editable& module, Id pointer_type) {
    const Op* op = module.global(pointer_type);
    return op != nullptr && op->opcode == SpvOpTypePointer &&
           (op->operands()[0] == SpvStorageClassFunction || op->operands()[0] == SpvStorageClassPrivate);
}

bool store_again(Editable& module, Chance& chance) {
    std::vector<Spot> found;
    for (const Spot& spot : spots(module, [](const Op& op) { return op.opcode == SpvOpLoad; })) {
        const std::map<Id, Id> types = module.types_of(module.functions[spot.function]);
        if (is_private(module, types.at(at(module, spot).operands()[0]))) found.push_back(spot);
    }
    const auto spot = some(chance, found);
    if (!spot) return false;
    const Op& load = at(module, *spot);
    insert(module, {spot->function, spot->block, spot->op + 1},
           {{SpvOpStore, {load.operands()[0], load.result()}}});
    return true;
}

bool store_before(Editable& module, Chance& chance) {
    struct Store {
        Spot spot;
        Id type;
    };
    std::vector<Store> found;
    for (const Spot& spot : spots(module, [](const Op& op) { return op.opcode == SpvOpStore; })) {
        const std::map<Id, Id> types = module.types_of(module.functions[spot.function]);
        const Op& op = at(module, spot);
        if (is_private(module, types.at(op.words[0]))) found.push_back({spot, types.at(op.words[1])});
    }
    if (found.empty()) return false;
    const Store store = chance.of(found);
    const Id pointer = at(module, store.spot).words[0];
    insert(module, store.spot,
           {{SpvOpStore, {pointer, module.global_of(SpvOpConstantNull, store.type, {})}}});
    return true;
}

}  // namespace

bool is_of_numbers(const Editable& module, Id type) {
    const Op* op = module.global(type);
    if (op == nullptr) return false;
    if (op->opcode == SpvOpTypeVector || op->opcode == SpvOpTypeMatrix)
        return is_of_numbers(module, op->operands()[0]);
    return op->opcode == SpvOpTypeBool || op->opcode == SpvOpTypeInt || op->opcode == SpvOpTypeFloat;
}

const std::vector<Change>& changes_of_values() {
    static const std::vector<Change> all{{"commuted operands", commute},
                                         {"comparison turned round", turn_comparison},
                                         {"vector taken apart", take_vector_apart},
                                         {"operation outlined", outline},
                                         {"negated twice", negate_twice},
                                         {"inverted twice", invert_twice},
                                         {"reinterpreted twice", reinterpret_twice},
                                         {"selected", select_it},
                                         {"constant hidden", hide_constant},
                                         {"stored again", store_again},
                                         {"store before a store", store_before}};
    return all;
}

}  // namespace internal

Metamorphism metamorphic(const Spirv& module, std::uint64_t seed, const std::vector<std::size_t>& positions) {
    using internal::Change;
    internal::Editable editable(module);
    std::vector<Change> all = internal::changes_of_values();
    all.insert(all.end(), internal::changes_of_flow().begin(), internal::changes_of_flow().end());
    Metamorphism made;
    for (const std::size_t position : positions) {
        // Each change has its own numbers, so that it is the same kind of change if others are left out.
        internal::Chance chance(seed * metamorphic_changes + position);
        const Change& change = chance.of(all);
        if (change.make(editable, chance)) made.changes.emplace_back(change.name);
    }
    made.module = editable.words();
    return made;
}

}  // namespace gloam::shader
