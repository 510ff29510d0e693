// SPDX-License-Identifier: MIT
// The implementation of stb's single-header library.
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb_truetype.h>
