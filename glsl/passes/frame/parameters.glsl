// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_FRAME_PARAMETERS_GLSL
#define GLOAM_PASSES_FRAME_PARAMETERS_GLSL

// A structure that all invocations share, as `parameters`: push constants of Vulkan, a uniform of OpenGL, or there with
// GLOAM_PARAMETER_BLOCK a block, whose binding is 0 unless the program says another.
#ifdef GLOAM_ONE_PASS  // a variable
#define FRAME_PARAMETERS(type) type parameters;
#elif defined(VULKAN)
#define FRAME_PARAMETERS(type) layout(push_constant) uniform Push { type parameters; };
#elif defined(GLOAM_PARAMETER_BLOCK)
#define FRAME_PARAMETERS(type) layout(std140) uniform Parameters { type parameters; };
#else
#define FRAME_PARAMETERS(type) uniform type parameters;
#endif

// Orthographic cameras, and those that may zoom to less than 30 degrees: depth has 32 bits in levels and texels.
layout(constant_id = 9) const bool deep = false;

// Part of its depth at which a usual camera, of 60 degrees, sees as many pixels in a radius: what tells one surface
// from another scales with it. 1 unless deep; less where the view is narrow; orthographic, it falls with depth. usual:
// the part or, orthographic, that depth; and for each unit of depth the least part, by what is rounded where depth is
// stored.
float usual_share(float depth, vec2 usual, bool orthographic) {
    return deep ? max(usual.x, usual.y * depth) * (orthographic ? 1.0 / depth : 1.0) : 1.0;
}

#endif
