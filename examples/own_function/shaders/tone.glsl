// SPDX-License-Identifier: MIT
#ifndef TONE_GLSL
#define TONE_GLSL

float tone_reinhard(float x) {
    return x / (1.0 + x);
}

#endif
