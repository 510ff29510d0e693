// SPDX-License-Identifier: MIT
#pragma once

#define SPV_ENABLE_UTILITY_CODE  // which instructions have results
#include <spirv.h>

#include <array>
#include <cstdint>
#include <list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "shader/instructions.hpp"
#include "shader/wgsl.hpp"

namespace gloam::shader::internal::wgsl {

using Id = std::uint32_t;

// The entry of a map. Throws NotTranslated, with `what` it is about, where there is none.
template <class Map>
[[nodiscard]] const typename Map::mapped_type& entry_of(const Map& map, const typename Map::key_type& key,
                                                        const char* what) {
    const auto found = map.find(key);
    if (found == map.end()) throw NotTranslated(what);
    return found->second;
}

struct Member {
    Id type = 0;
    std::string name;
    std::uint32_t offset = 0;
    bool row_major = false;
};

struct Type {
    enum class Kind {
        void_,
        bool_,
        int_,
        uint_,
        float_,
        vector,
        matrix,
        array,
        runtime_array,
        structure,
        pointer,
        image,
        sampled_image,
        sampler,
        function
    };
    Kind kind = Kind::void_;
    Id element = 0;           // of a vector, matrix (its column), array, pointer, image
    std::uint32_t count = 0;  // of a vector, matrix
    Id length = 0;            // of an array
    std::uint32_t stride = 0;
    std::vector<Member> members;
    std::uint32_t storage = 0;  // of a pointer
    std::uint32_t bits = 32;    // of a float
    std::uint32_t dimension = 0;
    bool depth = false;         // an image that is compared with a depth
    bool arrayed = false;       // an image with layers
    bool multisampled = false;  // an image with samples
    bool stored = false;        // an image without a sampler, for imageLoad() and imageStore()
    std::uint32_t format = 0;   // of a storage image
};

using TypeKind = Type::Kind;

struct Decorations {
    std::optional<std::uint32_t> spec_id;
    std::optional<std::uint32_t> built_in;
    std::uint32_t set = 0;
    std::uint32_t binding = 0;
};

struct Variable {
    Id id = 0;
    Id type = 0;  // of what it holds
    std::uint32_t storage = 0;
    Id initial = 0;
};

struct Block {
    Id label = 0;
    std::vector<Instruction> body;     // without variables, merge and terminator
    std::optional<Instruction> merge;  // OpSelectionMerge, OpLoopMerge
    Instruction end;
};

struct Function {
    Id id = 0;
    Id result = 0;
    std::vector<Id> parameters;
    std::vector<Variable> variables;
    std::map<Id, Block> blocks;
    std::vector<Id> order;  // of the blocks
    [[nodiscard]] Id first() const { return order.front(); }
    [[nodiscard]] const Block& block(Id label) const {
        return entry_of(blocks, label, "a branch to a block of another function");
    }
};

// What a module declares.
class Module {
  public:
    // The words must outlive it.
    explicit Module(const Spirv& words);

    [[nodiscard]] const Type& type(Id id) const;
    // The type of a value or of a parameter.
    [[nodiscard]] Id type_of(Id value) const;
    // The image type of an image or a combined sampler.
    [[nodiscard]] const Type& image_type(Id type) const;
    [[nodiscard]] const Type& value_type(Id value) const { return type(type_of(value)); }
    // Of a pointer: the type of what it points to.
    [[nodiscard]] Id pointee(Id pointer) const { return value_type(pointer).element; }
    [[nodiscard]] Decorations decorations_of(Id id) const;
    [[nodiscard]] std::string name_of(Id id) const;  // empty where it has none
    [[nodiscard]] const Instruction* constant(Id id) const;
    [[nodiscard]] std::optional<std::uint32_t> integer(Id id) const;  // of an OpConstant
    // Whether it is an image, a sampler or both.
    [[nodiscard]] bool is_opaque(Id type) const;
    [[nodiscard]] bool is_float(Id type) const;  // or a vector of them
    [[nodiscard]] bool is_half(Id type) const;   // is_float(), of 16 bits
    [[nodiscard]] bool is_signed(Id type) const;
    [[nodiscard]] bool is_bool(Id type) const;
    [[nodiscard]] std::uint32_t components(Id type) const;  // 1 for a scalar

    std::map<Id, Type> types;
    std::vector<Id> type_order;
    std::map<Id, Instruction> constants;  // all OpConstant..., OpSpecConstant..., OpUndef
    std::vector<Id> constant_order;
    std::vector<Variable> variables;
    std::vector<Function> functions;
    std::map<std::uint32_t, Id> entry_points;  // by SPIR-V's execution model
    std::vector<std::uint32_t> local_size{1, 1, 1};
    std::set<Id> extended;

  private:
    void read(const Instruction& instruction);
    void read_type(const Instruction& instruction);
    bool read_scalar_type(const Instruction& instruction, Type& type);
    bool read_composite_type(const Instruction& instruction, Type& type);
    bool read_opaque_type(const Instruction& instruction, Type& type);
    void read_decoration(const Instruction& instruction);
    void read_member_decoration(const Instruction& instruction);
    void read_in_function(const Instruction& instruction);
    void drop_dead_blocks(Function& function);

    std::map<Id, Id> value_types_;
    std::map<Id, std::string> names_;
    std::map<Id, std::map<std::uint32_t, std::string>> member_names_;
    std::map<Id, std::map<std::uint32_t, Member>> member_decorations_;
    std::map<Id, Decorations> decorations_;
    std::map<Id, std::uint32_t> strides_;
    std::list<std::array<std::uint32_t, 2>> branches_;  // words of instructions made here
    bool in_function_ = false;
    Id block_ = 0;
};

}  // namespace gloam::shader::internal::wgsl
