// SPDX-License-Identifier: MIT
#include "check/internal/pass_interface.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <stdexcept>

namespace gloam::check::internal {
namespace {

using shader::Binding;
using shader::BindingType;
using shader::LaidOut;
using shader::StageVariable;

constexpr std::uint32_t most_bindings = 64;

[[noreturn]] void refuse(const std::string& pass, const std::string& name, const std::string& why) {
    throw std::invalid_argument(fmt::format("{}: \"{}\" {}", pass, name, why));
}

shader::Scalar scalar_of(const std::string& type) {
    if (type == "float") return shader::Scalar::float_;
    return type == "int" ? shader::Scalar::int_ : shader::Scalar::uint_;
}

shader::Type vector_type(const std::string& scalar, unsigned rows) {
    return {.scalar = scalar_of(scalar), .rows = static_cast<int>(rows)};
}

// "sampler2D", "usampler3D".
std::string sampler_name(const Binding& binding) {
    const std::string prefix = binding.texel == "float" ? "" : binding.texel.substr(0, 1);
    return prefix + "sampler" + binding.shape;
}

void require_supported(const std::string& pass, const Binding& binding) {
    if (binding.set != 0 || binding.number >= most_bindings)
        refuse(pass, binding.name,
               fmt::format("has set {} and binding {}, expected set 0 and a binding below {}", binding.set,
                           binding.number, most_bindings));
    switch (binding.type) {
        case BindingType::storage_image:
            if (binding.shape != "2D" || !gpu::format_from(binding.format))
                refuse(
                    pass, binding.name,
                    fmt::format("is an image{} of format \"{}\", expected image2D of a format like rgba32f",
                                binding.shape, binding.format));
            return;
        case BindingType::sampled_image:
            if (!shader::is_sampler_type(sampler_name(binding)))
                refuse(pass, binding.name,
                       fmt::format("is a {}, expected a sampler like sampler2D, sampler2DArray, sampler3D, "
                                   "samplerCube or sampler2DShadow, not an array",
                                   sampler_name(binding)));
            return;
        case BindingType::texture:
        case BindingType::sampler:
            refuse(pass, binding.name,
                   fmt::format("is a separate {}, expected a combined one like sampler2D",
                               to_string(binding.type)));
        default:
            return;
    }
}

class Collector {
  public:
    explicit Collector(const PassModules& modules) { all_.name = modules.name; }

    void add(const shader::Spirv& module, shader::Stage stage) {
        const shader::ModuleInterface found = reflected(module);
        for (const Binding& binding : found.bindings) add(binding);
        if (found.push_constants) {
            all_.push_constant_bytes = std::max(all_.push_constant_bytes, found.push_constants->size);
            add_members(*found.push_constants, PassSlot::Kind::push_constant, 0);
        }
        for (const shader::SpecializationConstant& constant : found.constants) add(constant);
        if (stage == shader::Stage::compute) {
            all_.local_size = found.local_size;
            all_.local_size_ids = found.local_size_ids;
        }
        if (stage == shader::Stage::vertex) add_attributes(found.inputs);
        if (stage == shader::Stage::fragment) {
            require_floats(found.outputs, "colour output");
            all_.colors = found.outputs;
        }
    }

    PassInterface take() {
        for (PassSlot& slot : all_.slots) {
            const auto same = [&](const PassSlot& other) { return other.name == slot.name; };
            ambiguous_.push_back(std::ranges::count_if(all_.slots, same) > 1 && !slot.member.name.empty());
        }
        for (std::size_t i = 0; i < all_.slots.size(); ++i)
            if (ambiguous_[i]) all_.slots[i].name = all_.slots[i].other_name;
        return std::move(all_);
    }

  private:
    shader::ModuleInterface reflected(const shader::Spirv& module) const {
        try {
            return shader::reflect(module);
        } catch (const std::runtime_error& error) {
            throw std::invalid_argument(all_.name + ": " + error.what());
        }
    }

    // A stage may have what the other has; then it is the same.
    bool is_new(const PassSlot& slot) const {
        return std::ranges::none_of(all_.slots, [&](const PassSlot& other) {
            return other.kind == slot.kind && other.name == slot.name && other.other_name == slot.other_name;
        });
    }

    void add(PassSlot slot) {
        if (is_new(slot)) all_.slots.push_back(std::move(slot));
    }

    void add(const Binding& binding) {
        require_supported(all_.name, binding);
        const auto same = std::ranges::find(all_.bindings, binding.number, &Binding::number);
        if (same != all_.bindings.end() && (same->type != binding.type || same->name != binding.name))
            refuse(all_.name, binding.name,
                   fmt::format("has binding {}, which \"{}\" has", binding.number, same->name));
        const auto index = static_cast<std::size_t>(same - all_.bindings.begin());
        if (same == all_.bindings.end()) all_.bindings.push_back(binding);
        if (binding.block) return add_members(*binding.block, PassSlot::Kind::buffer_member, index);
        const bool sampled = binding.type == BindingType::sampled_image;
        const shader::Type pixel = sampled ? vector_type(binding.texel, 4)
                                           : pixel_type(*gpu::format_from(binding.format), binding.texel);
        add(PassSlot{.kind = PassSlot::Kind::image,
                     .name = binding.name,
                     .says = sampled ? sampler_name(binding) : "image of " + shader::name_of(pixel),
                     .type = pixel,
                     .index = index});
    }

    void add(const shader::SpecializationConstant& constant) {
        using shader::SpecializationConstant;
        if (std::ranges::count(all_.constants, constant.id, &SpecializationConstant::id) > 0) return;
        shader::Type type{.scalar =
                              constant.type == "bool" ? shader::Scalar::bool_ : scalar_of(constant.type)};
        const std::string number = std::to_string(constant.id);
        add(PassSlot{.kind = PassSlot::Kind::constant,
                     .name = constant.name.empty() ? number : constant.name,
                     .other_name = number,
                     .says = constant.type,
                     .type = std::move(type),
                     .index = all_.constants.size()});
        all_.constants.push_back(constant);
    }

    void add_members(const shader::BlockLayout& block, PassSlot::Kind kind, std::size_t index) {
        for (const LaidOut& member : block.members) {
            const shader::Type type = type_of_member(member);
            add(PassSlot{.kind = kind,
                         .name = member.name,
                         .other_name = block.name + "." + member.name,
                         .says = shader::name_of(type),
                         .type = type,
                         .index = index,
                         .member = member});
        }
    }

    void require_floats(const std::vector<StageVariable>& variables, const char* what) const {
        for (std::size_t i = 0; i < variables.size(); ++i)
            if (variables[i].location != i || variables[i].type != "float")
                refuse(all_.name, variables[i].name,
                       fmt::format("is a {} of {} at location {}, expected floats at location {}", what,
                                   variables[i].type, variables[i].location, i));
    }

    void add_attributes(const std::vector<StageVariable>& inputs) {
        require_floats(inputs, "vertex attribute");
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            shader::Type type = vector_type("float", inputs[i].rows);
            type.sizes = {0};  // as many as there are vertices
            add(PassSlot{.kind = PassSlot::Kind::attribute,
                         .name = inputs[i].name,
                         .says = shader::name_of(type),
                         .type = type,
                         .index = i});
        }
        all_.attributes = inputs;
    }

    PassInterface all_;
    std::vector<bool> ambiguous_;
};

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

const PassSlot* PassInterface::find(const std::string& given) const {
    for (const PassSlot& slot : slots)
        if (slot.name == given || (slot.other_name == given && !given.empty())) return &slot;
    return nullptr;
}

shader::Type type_of_member(const LaidOut& member) {
    shader::Type type;
    if (member.members.empty()) {
        type = vector_type(member.type, member.rows);
        type.columns = static_cast<int>(member.columns);
    } else {
        type = {.scalar = shader::Scalar::structure, .name = member.type};
        for (const LaidOut& part : member.members) type.members.push_back({part.name, type_of_member(part)});
    }
    type.sizes.assign(member.sizes.begin(), member.sizes.end());
    return type;
}

std::vector<std::size_t> places_of(const LaidOut& member, std::size_t elements) {
    std::vector<std::size_t> places;
    append_places(member, member.offset, 0, member.stride, elements, places);
    return places;
}

shader::Type pixel_type(gpu::Format format, const std::string& texel) {
    return vector_type(texel, static_cast<unsigned>(gpu::channels(format)));
}

PassInterface interface_of(const PassModules& modules) {
    Collector all(modules);
    if (!modules.compute.empty()) all.add(modules.compute, shader::Stage::compute);
    if (!modules.vertex.empty()) all.add(modules.vertex, shader::Stage::vertex);
    if (!modules.fragment.empty()) all.add(modules.fragment, shader::Stage::fragment);
    return all.take();
}

}  // namespace gloam::check::internal
