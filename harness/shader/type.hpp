// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace gloam::shader {

// `unsupported`: an array, a sampler, a double ...; Type::name then holds its GLSL text.
enum class Scalar { void_, bool_, int_, uint_, float_, structure, unsupported };

struct Member;

// A GLSL type: scalar, vector (columns 1, rows 2..4), matrix (columns and rows 2..4; columns x rows as in
// matCxR) or structure.
struct Type {
    Scalar scalar = Scalar::void_;
    int columns = 1;
    int rows = 1;
    std::vector<Member> members;  // of a structure only
    std::string name;  // of a structure (not compared), or the text of an unsupported type (compared)

    // Equal layout: same scalar, columns, rows, and members of equal types; member names are not compared.
    friend bool operator==(const Type& a, const Type& b);
};

struct Member {
    std::string name;
    Type type;
};

enum class Direction { in, out, inout };

struct Parameter {
    std::string name;
    Type type;
    Direction direction = Direction::in;
};

// A function as the compiler sees it: defined, or only declared (a prototype for another to define; its
// parameters then have no names).
struct Function {
    std::string name;
    Type result;
    std::vector<Parameter> parameters;
    bool defined = false;
};

// Whether no part of the type is unsupported.
[[nodiscard]] bool is_supported(const Type& type);

// "vec3", "mat4x3", "float", "Name { float a; vec2 b; }".
[[nodiscard]] std::string to_glsl(const Type& type);
// "float f(vec2 uv, out float depth)"; a structure by its name only, an unnamed parameter by its type only.
[[nodiscard]] std::string to_glsl(const Function& function);

}  // namespace gloam::shader
