// SPDX-License-Identifier: MIT
#include <spirv.h>

#include <algorithm>

#include "shader/internal/editable.hpp"
#include "shader/spirv.hpp"

namespace gloam::shader {
namespace {

using internal::Block;
using internal::Editable;
using internal::FunctionBody;
using internal::Id;
using internal::Op;

// Changes the indices of a module's access chains into arrays of samplers.
class Indices {
  public:
    explicit Indices(Editable& module) : module_(module) {}

    // Whether there are any that are not constant.
    bool limit() {
        bool found = false;
        for (FunctionBody& function : module_.functions) {
            const std::map<Id, Id> types = module_.types_of(function);
            for (Block& block : function.blocks)
                for (std::size_t i = 0; i < block.ops.size(); ++i)
                    if (is_chain(block.ops[i]) && is_opaque(types.at(block.ops[i].result())))
                        found = limit(block, i, types) || found;
        }
        return found;
    }

    // Whatever comes from an array may differ between invocations, also behind the parameter of a function.
    void decorate() {
        for (const FunctionBody& function : module_.functions)
            for (const Block& block : function.blocks)
                for (const Op& op : block.ops)
                    if (op.type() != 0 && is_opaque(op.type()))
                        module_.decorate(op.result(), SpvDecorationNonUniform);
        module_.require(SpvCapabilitySampledImageArrayNonUniformIndexing, "SPV_EXT_descriptor_indexing");
    }

  private:
    static bool is_chain(const Op& op) {
        return op.opcode == SpvOpAccessChain || op.opcode == SpvOpInBoundsAccessChain;
    }

    // An image, a sampler, both together, or a pointer to one.
    [[nodiscard]] bool is_opaque(Id type) const {
        const Op* op = module_.global(type);
        if (op->opcode == SpvOpTypePointer) return op->operands()[0] == SpvStorageClassUniformConstant;
        return op->opcode == SpvOpTypeSampledImage || op->opcode == SpvOpTypeImage ||
               op->opcode == SpvOpTypeSampler;
    }

    // Those of the chain at this position, which moves behind what is put before it.
    bool limit(Block& block, std::size_t& at, const std::map<Id, Id>& types) {
        Op chain = block.ops[at];
        std::vector<Op> before;
        Id array = module_.global(types.at(chain.words[2]))->operands()[1];
        for (std::size_t w = 3; w < chain.words.size(); ++w) {
            const std::vector<std::uint32_t> shape(module_.global(array)->operands().begin(),
                                                   module_.global(array)->operands().end());
            array = shape[0];
            const Op* constant = module_.global(chain.words[w]);
            const bool is_constant = constant != nullptr && constant->opcode == SpvOpConstant;
            if (is_constant || shape.size() < 2) continue;  // or an array of any length
            const Id type = types.at(chain.words[w]);
            const std::uint32_t length = module_.global(shape[1])->operands()[0];
            const auto number = [&](std::uint32_t value) {
                std::vector<std::uint32_t> words(module_.global(type)->operands()[0] > 32 ? 2 : 1);
                words[0] = value;
                return module_.global_of(SpvOpConstant, type, words);
            };
            const Id inside = module_.fresh();
            const Id index = module_.fresh();
            before.push_back({SpvOpULessThan, {module_.bool_type(), inside, chain.words[w], number(length)}});
            before.push_back({SpvOpSelect, {type, index, inside, chain.words[w], number(length - 1)}});
            chain.words[w] = index;
        }
        if (before.empty()) return false;
        block.ops[at] = chain;
        block.ops.insert(block.ops.begin() + static_cast<std::ptrdiff_t>(at), before.begin(), before.end());
        at += before.size();
        return true;
    }

    Editable& module_;
};

}  // namespace

std::optional<Spirv> for_any_sampler_index(const Spirv& module) {
    const auto has_samplers = [](const Instruction& one) { return one.opcode == SpvOpTypeSampledImage; };
    if (std::ranges::none_of(instructions(module), has_samplers)) return std::nullopt;
    Editable changed(module);
    Indices indices(changed);
    if (!indices.limit()) return std::nullopt;
    indices.decorate();
    return changed.words();
}

}  // namespace gloam::shader
