// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "module/spirv.hpp"

// What a SPIR-V module declares outside of its functions, for all that look into modules.
namespace gloam::module::spirv {

using Id = std::uint32_t;

// Whether an instruction has a result, and a type before it.
struct ResultShape {
    bool result = false;
    bool type = false;
};
[[nodiscard]] ResultShape result_shape(std::uint32_t opcode);

// The memory layout of a matrix.
struct MatrixLayout {
    std::uint32_t stride = 0;
    bool row_major = false;
};

// A member of a structure.
struct Member {
    Id type = 0;
    std::string name{};
    std::uint32_t offset = 0;  // bytes
    MatrixLayout matrix{};
    bool not_readable = false;
    bool not_writable = false;
};

struct Type {
    enum class Kind {
        void_,
        boolean,
        integer,
        real,
        vector,
        matrix,
        array,
        runtime_array,
        structure,
        pointer,
        image,
        sampler,
        sampled_image,
        function
    };
    Kind kind = Kind::void_;
    std::uint32_t width = 0;  // bits of a number
    bool is_signed = false;
    Id element = 0;  // of a vector, matrix (its column) or array; the pointee of a pointer; the image of a
                     // sampled image; what a texel holds; what a function returns
    std::uint32_t count = 0;         // of a vector, matrix
    Id length = 0;                   // of an array: a constant
    std::uint32_t array_stride = 0;  // bytes
    std::vector<Member> members{};
    std::uint32_t storage = 0;    // of a pointer: SpvStorageClass
    std::uint32_t dimension = 0;  // of an image: SpvDim
    bool depth = false;           // an image that is compared with a depth
    bool arrayed = false;         // an image with layers
    bool multisampled = false;    // an image with samples
    bool stored = false;          // an image without a sampler, for imageLoad() and imageStore()
    std::uint32_t format = 0;     // of an image: SpvImageFormat
};

// The GLSL name of a number that is not judged, "double" or "int64_t"; empty for every other type.
[[nodiscard]] std::string other_number(const Type& type);
// That of the first such type of a module.
[[nodiscard]] std::string other_number(const Spirv& module);
// "double is not judged: gloam judges float, float16_t, int, uint and bool"
[[nodiscard]] std::string not_judged(const std::string& number);

struct Decorations {
    bool no_contraction = false;
    bool relaxed = false;
    bool not_readable = false;
    bool not_writable = false;
    std::optional<std::uint32_t> spec_id{};
    std::optional<std::uint32_t> built_in{};
    std::uint32_t set = 0;
    std::uint32_t binding = 0;
};

class Declarations {
  public:
    // Reads an instruction outside of functions: a name, a decoration, an import or a type, which it returns;
    // null for all others. Instructions come in the order of the module.
    const Type* read(const Instruction& instruction);

    [[nodiscard]] Decorations decorations_of(Id id) const;
    // "blend" of "blend(f1;f1;", as the front end appends the types of parameters; empty: it has none.
    [[nodiscard]] std::string name_of(Id id) const;

    std::map<Id, std::string> names;  // as they stand in the module
    std::map<Id, Type> types;
    std::set<Id> extended_sets;  // GLSL.std.450

  private:
    void decorate(const Instruction& instruction);
    void decorate_member(const Instruction& instruction);

    std::map<Id, Decorations> decorations_;
    std::map<Id, std::uint32_t> strides_;
    std::map<std::pair<Id, std::uint32_t>, Member> members_;  // what precedes their structures
};

}  // namespace gloam::module::spirv
