// SPDX-License-Identifier: MIT
#pragma once

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

}  // namespace gloam::module
