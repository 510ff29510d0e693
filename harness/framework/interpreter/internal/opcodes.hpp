// SPDX-License-Identifier: MIT
#pragma once

// The numbers of SPIR-V, with its table of which instructions have results.
#define SPV_ENABLE_UTILITY_CODE
#include <GLSL.std.450.h>
#include <spirv.h>
