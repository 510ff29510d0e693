// SPDX-License-Identifier: MIT
#pragma once

// The numbers of SPIR-V.
#include <GLSL.std.450.h>
#include <spirv.h>
