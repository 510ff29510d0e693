// SPDX-License-Identifier: MIT
#include "shader/variant.hpp"

#include <stdexcept>

namespace gloam::shader {

std::vector<Variant> variants() {
    using Constants = Variant::Constants;
    return {
        {.name = "shipped", .description = "the SPIR-V that glslang makes"},
        {.name = "strict",
         .description = "every float operation NoContraction: no contraction, no reordering",
         .strict = true},
        {.name = "optimized",
         .description = "optimised for speed by SPIRV-Tools (-O)",
         .optimization = Optimization::performance},
        {.name = "small",
         .description = "optimised for size by SPIRV-Tools (-Os)",
         .optimization = Optimization::size},
        {.name = "round_trip",
         .description = "turned into GLSL by SPIRV-Cross and compiled again",
         .through = Variant::Through::glsl},
        {.name = "hlsl",
         .description = "turned into HLSL by SPIRV-Cross and compiled by glslang's HLSL front end",
         .through = Variant::Through::hlsl},
        {.name = "relaxed",
         .description = "every float result RelaxedPrecision (mediump), and NoContraction",
         .strict = true,
         .relaxed = true},
        {.name = "literals",
         .description = "a few inputs as literals, folded by the compiler (-O)",
         .optimization = Optimization::performance,
         .constants = Constants::literals},
        {.name = "specialization",
         .description = "a few inputs as specialization constants, folded by the driver",
         .constants = Constants::specialization},
    };
}

Variant variant(const std::string& name) {
    std::string names;
    for (Variant& known : variants()) {
        if (known.name == name) return std::move(known);
        names += (names.empty() ? "" : ", ") + known.name;
    }
    throw std::invalid_argument("unknown variant \"" + name + "\": expected " + names);
}

}  // namespace gloam::shader
