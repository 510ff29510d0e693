// SPDX-License-Identifier: MIT
#ifndef GLOAM_NUMERIC_PRECISE_GLSL
#define GLOAM_NUMERIC_PRECISE_GLSL

// Keeps the order of operations where a language has the word. Vulkan else lets a driver add up what an expression
// subtracts one after the other, which undoes a reduction of an argument.
#if (defined(GL_ES) && __VERSION__ >= 320) || (!defined(GL_ES) && __VERSION__ >= 400)
#define GLOAM_PRECISE precise
#else
#define GLOAM_PRECISE
#endif

#endif
