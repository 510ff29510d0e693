// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace gloam::shader {

// Optimisation by SPIRV-Tools after the front end.
enum class Optimization {
    none,
    performance,
    size,
    hoisting  // performance, and what a loop does not change is computed before it: not every driver moves it
};

// One way to make a module of a shader. The default is the way that glslang makes it.
struct Variant {
    // How a kernel gets the inputs that it is called with: from memory, or as constants that the compiler
    // (literals) or the driver (specialization constants) may fold. compile() does not look at it: the text
    // has them, or has them not.
    enum class Constants { none, literals, specialization };

    std::string name;
    std::string description;
    Optimization optimization = Optimization::none;
    bool strict = false;      // every float operation NoContraction, as if all were `precise`
    bool relaxed = false;     // every float result RelaxedPrecision, as if all were `mediump`
    bool round_trip = false;  // to GLSL by SPIRV-Cross, and compiled again
    Constants constants = Constants::none;
};

// All variants: shipped, strict, optimized, small, round_trip, relaxed, literals, specialization.
[[nodiscard]] std::vector<Variant> variants();

// The variant of that name. Throws std::invalid_argument that lists the names.
[[nodiscard]] Variant variant(const std::string& name);

}  // namespace gloam::shader
