// SPDX-License-Identifier: MIT
#pragma once

#include "module/compile.hpp"
#include "module/spirv.hpp"
#include "support/files.hpp"

namespace gloam::module {

// Files that texts of tests include: names and texts.
inline constexpr std::pair<const char*, const char*> fixture_texts[] = {
    {"cycle/a.glsl", "#include \"cycle/b.glsl\"\n"},
    {"cycle/b.glsl", "#include \"cycle/a.glsl\"\n"},
    {"cycle/self.glsl", "#include \"self.glsl\"\n"},
    {"broken/missing.glsl", "#include \"math/square.glsl\"\n#include \"broken/nowhere.glsl\"\n"},
    {"broken/outer.glsl", "#include \"math/square.glsl\"\n#include \"broken/inner.glsl\"\n"},
    {"broken/inner.glsl", R"(/* A comment
   of three
   lines. */
float fx_inner(float x) {
    return x + not_declared;
}
)"},
    {"math/square.glsl", R"(// SPDX-License-Identifier: MIT
#ifndef FX_MATH_SQUARE_GLSL
#define FX_MATH_SQUARE_GLSL

// x squared.
float fx_square(float x) {
    return x * x;
}

#endif
)"},
    {"math/hypot.glsl", R"(// SPDX-License-Identifier: MIT
#ifndef FX_MATH_HYPOT_GLSL
#define FX_MATH_HYPOT_GLSL

#include "math/square.glsl"

// Length of (x, y).
float fx_hypot(float x, float y) {
    return sqrt(fx_square(x) + fx_square(y));
}

#endif  // FX_MATH_HYPOT_GLSL
)"},
    {"math/neighbour.glsl", R"(#ifndef FX_MATH_NEIGHBOUR_GLSL
#define FX_MATH_NEIGHBOUR_GLSL
#include "square.glsl"
float fx_cube(float x) {
    return x * fx_square(x);
}
#endif
)"},
    {"pack/conditional.glsl", R"(#ifdef FX_FAST
#include "math/square.glsl"
#endif
)"},
    {"pack/odd.glsl", R"(// SPDX-License-Identifier: MIT
#version 310 es
#extension GL_GOOGLE_include_directive : require
/* This comment stays,
#include "pack/conditional.glsl"
   and so does its second half. */ #ifndef FX_PACK_ODD_GLSL
#define FX_PACK_ODD_GLSL  // the guard

// Before the include.
const float FX_HALF = 0.5;
  #  include "math/hypot.glsl"  /* trailing */
#ifdef FX_NEVER
#define FX_SCALE 3.0
#else
#define FX_SCALE 2.0
#endif

// Uses all of it.
float fx_odd(float x) {
    return FX_SCALE * fx_hypot(x, FX_HALF);
}
#endif  // FX_PACK_ODD_GLSL
)"},
    {"types.glsl", R"(struct FxInner { vec2 uv; uint seed; };
struct FxOuter { FxInner inner; mat3x2 map; bvec4 flags; };
void fx_nothing() {}
bool fx_scalars(bool a, int b, uint c, float d) { return a; }
ivec3 fx_vectors(bvec2 a, ivec3 b, uvec4 c, vec2 d) { return b; }
mat4x3 fx_matrices(mat2 a, mat3 b, mat4 c, mat2x4 d) { return mat4x3(1.0); }
FxOuter fx_structures(FxInner inner, const in float scale, out FxInner result, inout uvec2 state, float) {
    result = inner;
    return FxOuter(inner, mat3x2(scale), bvec4(true));
}
float fx_overload(float x) { return x; }
float fx_overload(vec2 x) { return x.x; }
)"},
    {"fetch.glsl", R"(#include "math/square.glsl"

// Defined by the includer.
float fx_fetch_depth(ivec2 pixel);
void fx_fetch_pair(const in ivec2 pixel, out float depth, inout vec3 normal);
float fx_never_called(float x);

// Calls the first prototype.
float fx_twice(ivec2 pixel) {
    return 2.0 * fx_fetch_depth(pixel);
}

// Calls both, one of them again.
float fx_gather(ivec2 pixel, inout vec3 normal) {
    float depth;
    fx_fetch_pair(pixel, depth, normal);
    return fx_twice(pixel) + fx_square(depth) + fx_fetch_depth(pixel + ivec2(1, 0));
}
)"}};

// The folder of this process in which they are.
inline const std::filesystem::path& fixtures() {
    static const TemporaryDirectory folder;
    static const std::filesystem::path path = [] {
        for (const auto& [name, text] : fixture_texts) (void)folder.write(name, text);
        return folder.path();
    }();
    return path;
}

inline std::filesystem::path fixture(std::string_view name) {
    return fixtures() / name;
}

inline CompileOptions with_fixtures(Optimization optimization = Optimization::none) {
    return {.include_roots = {fixtures()}, .variant = {.optimization = optimization}};
}

// The message of the exception that `action` throws; "" when it throws none of that type.
template <class Error, class Action>
std::string message_of(Action&& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

// A compute shader that stores `expression`, behind `head`.
inline source::Source kernel(std::string_view head, std::string_view expression) {
    std::string text = "#version 450\n";
    text.append(head).append("\nlayout(local_size_x = 1) in;\n");
    text.append("layout(std430, binding = 0) buffer Out { float result[]; };\n");
    text.append("void main() { result[gl_GlobalInvocationID.x] = ").append(expression).append("; }\n");
    return {"kernel", text};
}

// Functions as GLSL has them; "? " stands before those without a body.
inline std::vector<std::string> prototypes(const std::vector<Function>& functions) {
    std::vector<std::string> texts;
    for (const Function& function : functions)
        texts.push_back((function.defined ? "" : "? ") + to_glsl(function));
    return texts;
}

// What a test asks of a module, as its disassembly has it.
class Disassembly {
  public:
    explicit Disassembly(const Spirv& module) {
        std::istringstream lines(disassemble(module));
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words(line);
            rows_.emplace_back(std::istream_iterator<std::string>(words),
                               std::istream_iterator<std::string>());
            rows_.back().resize(std::max<std::size_t>(rows_.back().size(), 4));
        }
    }

    // The result IDs of every instruction of that kind: "OpFAdd".
    [[nodiscard]] std::set<std::string> results(const std::string& opcode) const {
        return of<std::set<std::string>>(0,
                                         [&](const Row& row) { return row[1] == "=" && row[2] == opcode; });
    }
    // Every ID that carries the decoration, how often.
    [[nodiscard]] std::multiset<std::string> decorated(const std::string& decoration) const {
        return of<std::multiset<std::string>>(
            1, [&](const Row& row) { return row[0] == "OpDecorate" && row[2] == decoration; });
    }
    // The result IDs with a type of that name: "%float", "%v3float".
    [[nodiscard]] std::set<std::string> of_type(const std::string& type) const {
        return of<std::set<std::string>>(0, [&](const Row& row) {
            return row[1] == "=" && row[3] == type && !row[2].starts_with("OpType");
        });
    }

  private:
    using Row = std::vector<std::string>;
    template <class Ids, class Predicate>
    [[nodiscard]] Ids of(std::size_t column, Predicate predicate) const {
        Ids ids;
        for (const Row& row : rows_)
            if (predicate(row)) ids.insert(row[column]);
        return ids;
    }
    std::vector<Row> rows_;
};

}  // namespace gloam::module
