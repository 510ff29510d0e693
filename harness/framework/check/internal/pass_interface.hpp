// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "backend/vulkan/resources.hpp"
#include "shader/reflection.hpp"

namespace gloam::check::internal {

// A name of a pass, and what stands behind it.
struct PassSlot {
    enum class Kind { image, buffer_member, push_constant, constant, attribute };

    Kind kind = Kind::image;
    std::string name;        // as users give it
    std::string other_name;  // a second one: "Block.member", the number of a constant
    std::string says;        // what is expected: "int", "image of vec4", "sampler2D"
    shader::Type type;       // of a value, or of a pixel
    std::size_t index = 0;   // of the binding, constant or attribute in its list
    shader::LaidOut member;  // of a block
};

// One shader, or two, as modules.
struct PassModules {
    std::string name;       // for messages: "blur.comp", "quad.vert and tone.frag"
    shader::Spirv compute;  // or
    shader::Spirv vertex;
    shader::Spirv fragment;
};

struct PassInterface {
    std::string name;
    std::vector<shader::Binding> bindings;
    std::size_t push_constant_bytes = 0;
    std::vector<shader::SpecializationConstant> constants;
    std::array<std::uint32_t, 3> local_size{};
    std::array<std::optional<std::uint32_t>, 3> local_size_ids{};
    std::vector<shader::StageVariable> attributes;  // by location
    std::vector<shader::StageVariable> colors;
    std::vector<PassSlot> slots;

    // The slot that users call so; null: there is none.
    [[nodiscard]] const PassSlot* find(const std::string& given) const;
};

// Throws std::invalid_argument, with the pass and the name, for what a pass cannot have.
[[nodiscard]] PassInterface interface_of(const PassModules& modules);

// The type of a member of a block. bool is uint there.
[[nodiscard]] shader::Type type_of_member(const shader::LaidOut& member);

// The place in bytes of each scalar of a member, in the order of a C++ value's words. `elements`: of an
// unbounded array.
[[nodiscard]] std::vector<std::size_t> places_of(const shader::LaidOut& member, std::size_t elements);

// The type of a pixel of a storage image of this format.
[[nodiscard]] shader::Type pixel_type(gpu::Format format, const std::string& texel);

}  // namespace gloam::check::internal
