// SPDX-License-Identifier: MIT
#include "shader/type.hpp"

#include <algorithm>

namespace gloam::shader {
namespace {

std::string scalar_name(Scalar scalar) {
    switch (scalar) {
        case Scalar::void_:
            return "void";
        case Scalar::bool_:
            return "bool";
        case Scalar::int_:
            return "int";
        case Scalar::uint_:
            return "uint";
        case Scalar::float_:
            return "float";
        case Scalar::structure:
        case Scalar::unsupported:
            break;
    }
    return {};
}

std::string vector_prefix(Scalar scalar) {
    return scalar == Scalar::float_ ? std::string() : scalar_name(scalar).substr(0, 1);
}

// Structures by name, everything else in full.
std::string short_name(const Type& type) {
    return type.scalar == Scalar::structure ? type.name : to_glsl(type);
}

std::string text_of(const Parameter& parameter) {
    std::string text;
    if (parameter.direction == Direction::out) text = "out ";
    if (parameter.direction == Direction::inout) text = "inout ";
    text += short_name(parameter.type);
    if (!parameter.name.empty()) text += " " + parameter.name;
    return text;
}

}  // namespace

bool operator==(const Type& a, const Type& b) {
    if (a.scalar != b.scalar || a.columns != b.columns || a.rows != b.rows) return false;
    if (a.scalar == Scalar::unsupported) return a.name == b.name;
    return std::equal(a.members.begin(), a.members.end(), b.members.begin(), b.members.end(),
                      [](const Member& x, const Member& y) { return x.type == y.type; });
}

bool is_supported(const Type& type) {
    return type.scalar != Scalar::unsupported &&
           std::all_of(type.members.begin(), type.members.end(),
                       [](const Member& member) { return is_supported(member.type); });
}

std::string to_glsl(const Type& type) {
    if (type.scalar == Scalar::unsupported) return type.name;
    if (type.scalar == Scalar::structure) {
        std::string text = type.name + " {";
        for (const Member& member : type.members)
            text.append(" ").append(short_name(member.type)).append(" ").append(member.name).append(";");
        return text + " }";
    }
    const std::string rows = std::to_string(type.rows);
    if (type.columns > 1) {
        std::string text = "mat" + std::to_string(type.columns);
        return type.columns == type.rows ? text : text.append("x").append(rows);
    }
    return type.rows > 1 ? vector_prefix(type.scalar) + "vec" + rows : scalar_name(type.scalar);
}

std::string to_glsl(const Function& function) {
    std::string text = short_name(function.result) + " " + function.name + "(";
    for (std::size_t i = 0; i < function.parameters.size(); ++i)
        text += (i == 0 ? "" : ", ") + text_of(function.parameters[i]);
    return text + ")";
}

}  // namespace gloam::shader
