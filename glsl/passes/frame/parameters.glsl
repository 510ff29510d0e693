// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_FRAME_PARAMETERS_GLSL
#define GLOAM_PASSES_FRAME_PARAMETERS_GLSL

// A structure that all invocations share, as `parameters`: push constants of Vulkan, a uniform of OpenGL, or there with
// GLOAM_PARAMETER_BLOCK a block, whose binding is 0 unless the program says another.
#ifdef VULKAN
#define FRAME_PARAMETERS(type) layout(push_constant) uniform Push { type parameters; };
#elif defined(GLOAM_PARAMETER_BLOCK)
#define FRAME_PARAMETERS(type) layout(std140) uniform Parameters { type parameters; };
#else
#define FRAME_PARAMETERS(type) uniform type parameters;
#endif

#endif
