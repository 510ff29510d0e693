// SPDX-License-Identifier: MIT
#include "shader/internal/wgsl/facts.hpp"

#include <algorithm>

namespace gloam::shader::internal::wgsl {
namespace {

// Words of an instruction, counted from its first one.
struct Range {
    std::size_t first;
    std::size_t end;
};

// Where the IDs stand that an instruction uses; the rest are literals.
Range ids_of(const Instruction& i, std::size_t first) {
    const std::size_t end = i.words.size();
    switch (i.opcode) {
        case SpvOpCompositeExtract:
        case SpvOpLoad:
        case SpvOpArrayLength:
            return {first, first + 1};
        case SpvOpCompositeInsert:
        case SpvOpVectorShuffle:
        case SpvOpStore:
            return {first, first + 2};
        case SpvOpSwitch:
            return {1, 2};
        case SpvOpBranchConditional:
            return {1, 2};
        case SpvOpBranch:
            return {0, 0};
        default:
            return {first, end};
    }
}

// The word that says which further operands an access to an image has.
std::size_t mask_of_image_operands(std::uint32_t opcode) {
    switch (opcode) {
        case SpvOpImageSampleDrefImplicitLod:
        case SpvOpImageSampleDrefExplicitLod:
        case SpvOpImageSampleProjDrefImplicitLod:
        case SpvOpImageSampleProjDrefExplicitLod:
        case SpvOpImageGather:
        case SpvOpImageDrefGather:
            return 6;
        default:
            return 5;
    }
}

}  // namespace

Id result_of(const Instruction& i) {
    bool has_result = false;
    bool has_type = false;
    SpvHasResultAndType(static_cast<SpvOp>(i.opcode), &has_result, &has_type);
    if (!has_result) return 0;
    return i.word(has_type ? 2 : 1);
}

std::vector<Id> operands(const Instruction& i) {
    if (i.opcode == SpvOpExtInst) return {i.words.begin() + 5, i.words.end()};
    if (i.opcode == SpvOpImageWrite) return {i.word(1), i.word(2), i.word(3)};
    if (i.opcode == SpvOpImageRead || i.opcode == SpvOpImageFetch ||
        (i.opcode >= SpvOpImageSampleImplicitLod && i.opcode <= SpvOpImageDrefGather)) {
        const std::size_t mask = mask_of_image_operands(i.opcode);
        std::vector<Id> ids;
        for (std::size_t w = 3; w < i.words.size(); ++w)
            if (w != mask) ids.push_back(i.word(w));
        return ids;
    }
    if (is_subgroup_operation(i.opcode)) {
        const bool sum = i.opcode >= SpvOpGroupNonUniformIAdd && i.opcode <= SpvOpGroupNonUniformLogicalXor;
        const bool count = i.opcode == SpvOpGroupNonUniformBallotBitCount;
        const std::size_t first = std::min<std::size_t>(sum || count ? 5 : 4, i.words.size());
        return {i.words.begin() + static_cast<std::ptrdiff_t>(first), i.words.end()};
    }
    bool has_result = false;
    bool has_type = false;
    SpvHasResultAndType(static_cast<SpvOp>(i.opcode), &has_result, &has_type);
    const Range range = ids_of(i, 1U + (has_result ? 1 : 0) + (has_type ? 1 : 0));
    std::vector<Id> ids;
    for (std::size_t w = range.first; w < range.end && w < i.words.size(); ++w) {
        const bool block_of_phi = i.opcode == SpvOpPhi && (w - range.first) % 2 == 1;
        if (!block_of_phi) ids.push_back(i.word(w));
    }
    return ids;
}

}  // namespace gloam::shader::internal::wgsl
