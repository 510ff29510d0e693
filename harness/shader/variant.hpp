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
    hoisting,  // performance, with loop invariants computed before their loops: not every driver does this
    unrolling  // hoisting, and drivers are asked to unroll loops: with long bodies not every driver does
};

// One way to make a module from a shader. The default is glslang's unchanged module.
struct Variant {
    // How a kernel gets its inputs: from memory, or as constants that the compiler (literals) or the driver
    // (specialization constants) may fold. compile() ignores it, because the text already contains the inputs
    // or does not.
    enum class Constants { none, literals, specialization };

    // A language into which SPIRV-Cross translates the module. glslang compiles the text again.
    enum class Through { none, glsl, hlsl };

    std::string name;
    std::string description;
    Optimization optimization = Optimization::none;
    bool strict = false;   // every float operation has NoContraction, as if all were `precise`
    bool relaxed = false;  // every float result has RelaxedPrecision, as if all were `mediump`
    Through through = Through::none;
    Constants constants = Constants::none;

    // Whether a module of it may differ from that of the front end as it is.
    [[nodiscard]] bool changes_the_module() const {
        return optimization != Optimization::none || strict || relaxed || through != Through::none ||
               constants != Constants::none;
    }
};

// All variants: shipped, strict, optimized, small, round_trip, hlsl, relaxed, literals, specialization.
[[nodiscard]] std::vector<Variant> variants();

// The variant with this name. Throws std::invalid_argument that lists the names.
[[nodiscard]] Variant variant(const std::string& name);

}  // namespace gloam::shader
