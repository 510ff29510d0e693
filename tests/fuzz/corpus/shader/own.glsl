// SPDX-License-Identifier: MIT
#version 450
#ifndef A
#define A
#extension GL_EXT_x : require
#include "b.glsl"
#if 1 /* x
*/ \
float f() { return 1.0; }
#else
#endif
#endif
