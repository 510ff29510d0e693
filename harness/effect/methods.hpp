// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "effect/settings.hpp"

namespace gloam::effect {

// What a method's results estimate, before the remap.
enum class Measure {
    cosine,   // cosine-weighted occlusion (TSSAO-1, CS-2.5)
    uniform,  // the same with every direction of the hemisphere alike
    volume,   // share of a volume around the point that is solid
    shape     // how concave the surface is
};

// Where a sample that meets nothing higher than the bias above the tangent plane counts and adds exactly 0.
enum class OpenProof {
    none,   // not so, or not known
    taps,   // surfaces under the disc of the radius
    points  // points of the half ball of the radius, each compared with the surface at its pixel
};

struct MethodInfo {
    std::string name;  // glsl/passes/methods/NAME.glsl
    std::string description;
    Measure measure = Measure::cosine;
    std::string falloff;  // with the distance of the blocker: "linear", "none", ...
    void (*adapt)(Settings&) =
        nullptr;  // what it needs beside a preset's settings; lengths for a radius of 1
    OpenProof open_proof = OpenProof::none;
    bool reads_normals = false;  // of the surfaces under its samples, not of the pixel's own alone
    std::string samples = {};    // what its samples share: glsl/passes/samples/NAME.glsl; none: nothing
};

// All methods; the first is the default.
[[nodiscard]] const std::vector<MethodInfo>& methods();

// By name. Throws std::invalid_argument that lists the names.
[[nodiscard]] const MethodInfo& method_named(std::string_view name);

// The settings, whose lengths are for a radius of 1, for another method. Throws like method_named().
[[nodiscard]] Settings with_method(Settings settings, std::string_view name);

[[nodiscard]] std::string to_string(Measure measure);

}  // namespace gloam::effect
