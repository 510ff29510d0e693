// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <algorithm>
#include <stdexcept>

#include "pass/internal/work.hpp"

namespace gloam::pass::internal {
namespace {

using module::Binding;
using module::BindingType;
using module::LaidOut;

constexpr std::uint32_t most_bindings = 64;

[[noreturn]] void refuse(const std::string& pass, const std::string& name, const std::string& why) {
    throw std::invalid_argument(fmt::format("{}: \"{}\" {}", pass, name, why));
}

module::Scalar scalar_of(const std::string& type) {
    if (type == "float") return module::Scalar::float_;
    if (type == "bool") return module::Scalar::bool_;
    return type == "int" ? module::Scalar::int_ : module::Scalar::uint_;
}

module::Type vector_type(const std::string& scalar, unsigned rows) {
    return {.scalar = scalar_of(scalar), .rows = static_cast<int>(rows)};
}

// "sampler2D", "usampler3D".
std::string sampler_name(const Binding& binding) {
    const std::string prefix = binding.texel == "float" ? "" : binding.texel.substr(0, 1);
    return prefix + "sampler" + binding.shape;
}

void require_supported(const PassInterface& all, std::size_t index) {
    const std::string& pass = all.name;
    const Binding& binding = all.declared.bindings[index];
    if (binding.set != 0 || binding.number >= most_bindings)
        refuse(pass, binding.name,
               fmt::format("has set {} and binding {}, expected set 0 and a binding below {}", binding.set,
                           binding.number, most_bindings));
    switch (binding.type) {
        case BindingType::storage_image:
            if (binding.shape != "2D" || !format_named(binding.format))
                refuse(
                    pass, binding.name,
                    fmt::format("is an image{} of format \"{}\", expected image2D of a format like rgba32f",
                                binding.shape, binding.format));
            break;
        case BindingType::sampled_image:
            if (!source::is_sampler_type(sampler_name(binding)))
                refuse(pass, binding.name,
                       fmt::format("is a {}, expected a sampler like sampler2D, sampler2DArray, sampler3D, "
                                   "samplerCube or sampler2DShadow, not an array",
                                   sampler_name(binding)));
            break;
        case BindingType::texture:
        case BindingType::sampler:
            refuse(pass, binding.name,
                   fmt::format("is a separate {}, expected a combined one like sampler2D",
                               to_string(binding.type)));
        default:
            break;
    }
    if (index > 0 && all.declared.bindings[index - 1].number == binding.number)
        refuse(pass, binding.name,
               fmt::format("has binding {}, which \"{}\" has", binding.number,
                           all.declared.bindings[index - 1].name));
}

// The type of a member of a block. bool is uint there.
module::Type type_of_member(const LaidOut& member) {
    module::Type type;
    if (member.members.empty()) {
        type = vector_type(member.type, member.rows);
        type.columns = static_cast<int>(member.columns);
    } else {
        type = {.scalar = module::Scalar::structure, .name = member.type};
        for (const LaidOut& part : member.members) type.members.push_back({part.name, type_of_member(part)});
    }
    type.sizes.assign(member.sizes.begin(), member.sizes.end());
    return type;
}

void add_members(const module::BlockLayout& block, PassSlot::Kind kind, std::size_t index,
                 std::vector<PassSlot>& slots) {
    for (const LaidOut& member : block.members) {
        const module::Type type = type_of_member(member);
        slots.push_back(
            {kind, member.name, block.name + "." + member.name, module::name_of(type), type, index, member});
    }
}

PassSlot image_slot(const Binding& binding, std::size_t index) {
    const bool sampled = binding.type == BindingType::sampled_image;
    const module::Type pixel = vector_type(
        binding.texel,
        sampled ? 4U : static_cast<unsigned>(backend::vulkan::channels(*format_named(binding.format))));
    return {.name = binding.name,
            .says = sampled ? sampler_name(binding) : "image of " + module::name_of(pixel),
            .type = pixel,
            .index = index};
}

PassSlot constant_slot(const module::SpecializationConstant& constant, std::size_t index) {
    const std::string number = std::to_string(constant.id);
    return {.kind = PassSlot::Kind::constant,
            .name = constant.name.empty() ? number : constant.name,
            .other_name = number,
            .says = constant.type,
            .type = {.scalar = scalar_of(constant.type)},
            .index = index};
}

// Members that have their name alone in the pass go by it, others by that of their block as well.
void tell_apart(std::vector<PassSlot>& slots) {
    std::vector<PassSlot*> ambiguous;
    for (PassSlot& slot : slots)
        if (!slot.member.name.empty() && std::ranges::count(slots, slot.name, &PassSlot::name) > 1)
            ambiguous.push_back(&slot);
    for (PassSlot* slot : ambiguous) slot->name = slot->other_name;
}

// Appends the places of the scalars of a member whose first byte is at `at`. `depth`: of the array.
void append_places(const LaidOut& member, std::size_t at, std::size_t depth, std::size_t stride,
                   std::size_t elements, std::vector<std::size_t>& places) {
    if (depth < member.sizes.size()) {
        const std::size_t count = member.sizes[depth] == 0 ? elements : member.sizes[depth];
        const std::size_t inner = depth + 1 < member.sizes.size() ? stride / member.sizes[depth + 1] : stride;
        for (std::size_t i = 0; i < count; ++i)
            append_places(member, at + i * stride, depth + 1, inner, elements, places);
        return;
    }
    for (const LaidOut& part : member.members)
        append_places(part, at + part.offset, 0, part.stride, elements, places);
    if (!member.members.empty()) return;
    const unsigned lines = member.row_major ? member.rows : member.columns;
    // A matrix fills an element of its array.
    const std::size_t line = member.columns == 1 ? 0 : (member.sizes.empty() ? member.size : stride) / lines;
    for (std::size_t column = 0; column < member.columns; ++column)
        for (std::size_t row = 0; row < member.rows; ++row)
            places.push_back(at + (member.row_major ? row * line + column * 4 : column * line + row * 4));
}

}  // namespace

std::optional<backend::vulkan::Format> format_named(const std::string& name) {
    return name.ends_with("32i") ? std::nullopt
                                 : backend::vulkan::format_from(name);  // signed ones: of functions alone
}

std::vector<std::size_t> places_of(const LaidOut& member, std::size_t elements) {
    std::vector<std::size_t> places;
    append_places(member, member.offset, 0, member.stride, elements, places);
    return places;
}

PassInterface interface_of(std::string name, module::Spirv module, std::string text) {
    PassInterface all{.name = std::move(name),
                      .module = std::move(module),
                      .declared = {},
                      .slots = {},
                      .text = std::move(text)};
    try {
        all.declared = module::reflect(all.module);
    } catch (const std::runtime_error& error) {
        throw std::invalid_argument(all.name + ": " + error.what());
    }
    for (std::size_t i = 0; i < all.declared.bindings.size(); ++i) {
        const Binding& binding = all.declared.bindings[i];
        require_supported(all, i);
        if (binding.block)
            add_members(*binding.block, PassSlot::Kind::buffer_member, i, all.slots);
        else
            all.slots.push_back(image_slot(binding, i));
    }
    if (all.declared.push_constants)
        add_members(*all.declared.push_constants, PassSlot::Kind::push_constant, 0, all.slots);
    for (std::size_t i = 0; i < all.declared.constants.size(); ++i)
        all.slots.push_back(constant_slot(all.declared.constants[i], i));
    tell_apart(all.slots);
    return all;
}

}  // namespace gloam::pass::internal
