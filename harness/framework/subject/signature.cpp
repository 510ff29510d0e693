// SPDX-License-Identifier: MIT
#include "subject/signature.hpp"

namespace gloam::check {

using shader::Direction;
using shader::Scalar;

std::vector<Scalar> Signature::input_scalars() const {
    std::vector<Scalar> scalars;
    for (const shader::Parameter& p : parameters) {
        if (p.direction != Direction::out) append_scalars(p.type, scalars);
    }
    return scalars;
}

std::vector<Scalar> Signature::output_scalars() const {
    std::vector<Scalar> scalars = scalars_of(result);
    for (const shader::Parameter& p : parameters) {
        if (p.direction != Direction::in) append_scalars(p.type, scalars);
    }
    return scalars;
}

std::size_t Signature::input_words() const {
    return input_scalars().size();
}

std::size_t Signature::output_words() const {
    return output_scalars().size();
}

namespace {

void append_values(const shader::Type& type, std::vector<std::size_t>& values) {
    if (!type.sizes.empty()) {
        const shader::Type element = shader::element_of(type);
        for (std::uint32_t i = 0; i < type.sizes.front(); ++i) append_values(element, values);
    } else if (type.scalar == Scalar::structure) {
        for (const shader::Member& member : type.members) append_values(member.type, values);
    } else if (type.scalar != Scalar::void_) {
        values.push_back(scalars_of(type).size());
    }
}

}  // namespace

std::vector<std::size_t> Signature::output_values() const {
    std::vector<std::size_t> values;
    append_values(result, values);
    for (const shader::Parameter& p : parameters) {
        if (p.direction != Direction::in) append_values(p.type, values);
    }
    return values;
}

shader::Function with_globals(shader::Function function, const shader::Excerpt& excerpt) {
    const auto& globals = excerpt.globals;
    for (const shader::Parameter& variable : function.globals)
        if (const auto found = globals.find(variable.name); found != globals.end()) {
            function.parameters.push_back(variable);
            function.parameters.back().uniform = found->second == shader::Access::uniform;
        }
    for (const shader::BoundVariable& one : excerpt.bound)
        if (!one.format.empty())
            function.parameters.push_back({.name = one.name,
                                           .type = pixels_of(one.format),
                                           .direction = one.written ? Direction::inout : Direction::in,
                                           .global = true,
                                           .image = one.format});
    // The kernel sets it, and not the function.
    if (globals.contains(shader::discarded))
        function.parameters.push_back({.name = shader::discarded,
                                       .type = {.scalar = Scalar::bool_},
                                       .direction = Direction::out,
                                       .global = true});
    return function;
}

shader::Type pixels_of(std::string_view format) {
    const std::size_t channels = format.find('3');  // "rg32f"
    return {.scalar = format.ends_with("ui")  ? Scalar::uint_
                      : format.ends_with('i') ? Scalar::int_
                                              : Scalar::float_,
            .rows = static_cast<int>(channels),
            .sizes = {image_sides[1], image_sides[0]}};
}

bool is_of_each(const shader::Parameter& parameter) {
    return !parameter.uniform && parameter.type.scalar != Scalar::sampler;
}

shader::Function together(shader::Function function, const backend::Team& team) {
    if (team.kind == backend::Team::Kind::alone) return function;
    const auto make_array = [&team](shader::Type& type) {
        type.sizes.insert(type.sizes.begin(), team.count());
    };
    if (function.result.scalar != Scalar::void_) make_array(function.result);
    for (shader::Parameter& p : function.parameters)
        if (is_of_each(p)) make_array(p.type);
    return function;
}

std::string to_glsl(const Signature& signature, const std::string& name) {
    return to_glsl_with_layouts(
        {.name = name, .result = signature.result, .parameters = signature.parameters, .defined = true});
}

std::string to_glsl_with_layouts(shader::Function function) {
    const auto spell_out = [](shader::Type& type) {
        if (type.scalar != Scalar::structure) return;
        shader::Type one = type;
        one.sizes.clear();
        type.name = shader::to_glsl(one);
    };
    spell_out(function.result);
    for (shader::Parameter& p : function.parameters) spell_out(p.type);
    return shader::to_glsl(function);
}

}  // namespace gloam::check
