// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_FRAME_PARAMETERS_GLSL
#define GLOAM_PASSES_FRAME_PARAMETERS_GLSL

// A structure that all invocations share, as `parameters`: push constants of Vulkan, a uniform of OpenGL.
#ifdef VULKAN
#define FRAME_PARAMETERS(type) layout(push_constant) uniform Push { type parameters; };
#else
#define FRAME_PARAMETERS(type) uniform type parameters;
#endif

#endif
