// SPDX-License-Identifier: MIT
#include "shader/resources.hpp"

#include <spirv.h>

#include <map>
#include <set>

#include "shader/instructions.hpp"

namespace gloam::shader {
namespace {

using Id = std::uint32_t;

const char* kind_of(std::uint32_t storage) {
    switch (storage) {
        case SpvStorageClassUniformConstant:
            return "image or sampler";
        case SpvStorageClassUniform:
            return "uniform buffer";
        case SpvStorageClassStorageBuffer:
            return "storage buffer";
        case SpvStorageClassPushConstant:
            return "push constants";
        default:
            return nullptr;
    }
}

bool takes_pointers(std::uint32_t opcode) {
    switch (opcode) {
        case SpvOpLoad:
        case SpvOpStore:
        case SpvOpCopyMemory:
        case SpvOpAccessChain:
        case SpvOpInBoundsAccessChain:
        case SpvOpPtrAccessChain:
        case SpvOpArrayLength:
        case SpvOpImageTexelPointer:
        case SpvOpFunctionCall:
            return true;
        default:
            return false;
    }
}

struct Module {
    std::map<Id, std::string> names;
    std::map<Id, Id> inside;  // of a pointer or an array, what it is of
    std::vector<Instruction> variables;
    std::set<Id> used;

    void add(const Instruction& instruction, bool in_function) {
        switch (instruction.opcode) {
            case SpvOpName:
                names[instruction.word(1)] = literal_string(instruction, 2);
                break;
            case SpvOpTypePointer:
                inside[instruction.word(1)] = instruction.word(3);
                break;
            case SpvOpTypeArray:
            case SpvOpTypeRuntimeArray:
                inside[instruction.word(1)] = instruction.word(2);
                break;
            case SpvOpVariable:
                if (!in_function) variables.push_back(instruction);
                break;
            default:
                break;
        }
        if (!in_function || !takes_pointers(instruction.opcode)) return;
        for (std::size_t i = 1; i < instruction.words.size(); ++i) used.insert(instruction.words[i]);
    }

    [[nodiscard]] std::string name_of(Id id) const {
        const auto found = names.find(id);
        return found == names.end() ? "" : found->second;
    }

    [[nodiscard]] std::string block_of(Id type) const {
        for (auto next = inside.find(type); next != inside.end(); next = inside.find(type))
            type = next->second;
        return name_of(type);
    }
};

}  // namespace

std::vector<Resource> used_resources(const Spirv& module) {
    Module all;
    bool in_function = false;
    for (const Instruction& instruction : instructions(module)) {
        if (instruction.opcode == SpvOpFunction) in_function = true;
        all.add(instruction, in_function);
        if (instruction.opcode == SpvOpFunctionEnd) in_function = false;
    }
    std::vector<Resource> resources;
    for (const Instruction& variable : all.variables) {
        const char* kind = kind_of(variable.word(3));
        const Id id = variable.word(2);
        if (kind == nullptr || !all.used.contains(id)) continue;
        resources.push_back({kind, all.name_of(id), all.block_of(variable.word(1))});
    }
    return resources;
}

}  // namespace gloam::shader
