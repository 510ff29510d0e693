// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "module/compile.hpp"

namespace gloam::module {

// A member of a block with its memory layout. A reference to a buffer is its address, a uvec2.
struct LaidOut {
    std::string name;
    std::string type;      // of its components: "float", "int", "uint", "bool"; of a structure its name
    unsigned rows = 1;     // of a vector or a column
    unsigned columns = 1;  // of a matrix
    std::vector<unsigned> sizes;   // of an array, outermost first; 0: as many as the buffer holds
    std::size_t offset = 0;        // bytes, in the block or structure
    std::size_t size = 0;          // bytes; of one element for an unbounded array
    std::size_t stride = 0;        // bytes from one element of an array to the next
    bool row_major = false;        // of a matrix
    std::vector<LaidOut> members;  // of a structure
};

struct BlockLayout {
    std::string name;
    std::size_t size = 0;  // bytes, without an unbounded array at the end
    std::vector<LaidOut> members;
};

enum class BindingType { storage_image, sampled_image, texture, sampler, storage_buffer, uniform_buffer };

struct Binding {
    std::uint32_t set = 0;
    std::uint32_t number = 0;
    std::uint32_t count = 1;  // of an array
    std::string name;         // of the variable; for an unnamed variable that of its block
    BindingType type = BindingType::storage_image;
    std::string format;  // of a storage image, as GLSL has it: "rgba32f"; empty: none is said
    std::string texel;   // of an image: what the shader reads: "float", "int", "uint"; else empty
    std::string shape;   // of an image: "2D", "2DArray", "3D", "Cube"; "2D[]" of an array of images
    bool reads = true;   // may be read: not declared writeonly
    bool writes = false;
    std::optional<BlockLayout> block;  // of a buffer
};

struct SpecializationConstant {
    std::uint32_t id = 0;
    std::string name;
    std::string type;        // "bool", "int", "uint", "float"
    std::uint32_t bits = 0;  // default value
};

// The interface of a module.
struct ModuleInterface {
    std::vector<Binding> bindings;  // by set and number
    std::optional<BlockLayout> push_constants;
    std::vector<SpecializationConstant> constants;  // by number
    std::array<std::uint32_t, 3> local_size{};
    // The constants that replace them, by axis; empty: none does.
    std::array<std::optional<std::uint32_t>, 3> local_size_ids{};
};

// The interface of a module. Throws std::runtime_error for words that are not a module, for a binding of
// another type, and for an array in one whose size is an expression on specialization constants.
[[nodiscard]] ModuleInterface reflect(const Spirv& module);

// "storage image", "storage buffer" ...
[[nodiscard]] std::string to_string(BindingType type);

}  // namespace gloam::module
