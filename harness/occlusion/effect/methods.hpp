// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "backend/vulkan/resources.hpp"
#include "effect/settings.hpp"

namespace gloam::effect {

// A pass that runs before ambient_occlusion.comp and writes a part of the prepared image.
struct PreparationPass {
    std::string name;             // for its time; unique among the passes of the frame
    std::string file;             // in glsl/passes/study/preparation
    backend::Extent invocations;  // in groups of 8 x 8
    int level = 0;                // passed to the shader as a constant
};

// What a method needs before it samples: passes in order, and the image that they write.
struct Preparation {
    backend::Extent image;
    backend::vulkan::Format format = backend::vulkan::Format::rgba32f;  // or r32f
    std::vector<PreparationPass> passes;
    // Largest distance of a result's samples from the pixel's surface: in pixels, and in world units.
    int spread = 0;
    float reach = 0.0F;
};

// The preparation of the method of the settings for views of that size, guard band included; none for a
// method that needs none.
[[nodiscard]] std::optional<Preparation> preparation_of(const Settings& settings, backend::Extent view);

// Settings of a source by name, each with the symbol or the words that it has there.
using Printed = std::vector<std::pair<std::string, std::string>>;

// Settings that belong together; lengths are for a radius of 1. Error and time are what `gloam bench presets`
// prints.
struct Preset {
    std::string name;
    std::string description;
    Settings settings;
    Printed printed{};      // the settings that its source has; all others are ours
    bool published = true;  // by its source, which its name or description gives; else gloam's own
    double error = 0.0;     // RMSE of sequences on unseen views, against ray-traced truth
    double time = 0.0;      // of a frame on llvmpipe, in that of the preset `fast`
    double tiles = 1.0;     // with Resolution::tiles: the share of unseen views' tiles that is swept in full
};

// gloam's own, each with less error and more time than the one before, then the published ones.
[[nodiscard]] const std::vector<Preset>& presets();

// The preset that every command takes if none is named.
inline constexpr const char* default_preset = "balanced";

// Where a preset has a setting from: the symbol of its source, or "ours" where print is silent. Of gloam's
// own presets the symbol that TSSAO has for the setting; empty without one.
[[nodiscard]] std::string origin_of(const Preset& preset, const std::string& setting);

// The preset with this name. Throws std::invalid_argument that lists the names.
[[nodiscard]] Preset preset_named(std::string_view name);

// What a method's results estimate, before the remap.
enum class Measure {
    cosine,   // cosine-weighted occlusion (TSSAO-1, CS-2.5)
    uniform,  // the same, but every direction of the hemisphere has the same weight
    volume,   // solid part of a volume around the point
    shape     // how concave the surface is
};

// The unit in which a method takes its samples.
enum class SampleUnit {
    one,
    pair,   // an odd number is rounded up to an even one
    cross,  // of four taps: two slices of one frame, or a pair at two radii
    ray,    // of MethodValues::steps taps
    slice   // of MethodValues::steps taps to both sides
};

// A member of the GLSL struct of a method's settings.
struct MethodMember {
    std::string name;
    std::string setting{};   // member of MethodValues that it is set to; empty: the one of the same name
    std::string constant{};  // GLSL constant that it is set to instead
};

// A method: everything about it that the effect, the command line, the tests and the benchmark use.
struct MethodInfo {
    std::string name;    // of the GLSL function gloam_NAME
    std::string family;  // its file is glsl/gloam/methods/FAMILY.glsl; empty: NAME.glsl
    std::string description;
    Measure measure = Measure::cosine;
    std::string falloff;                // with the distance of the blocker: "linear", "none", ...
    std::string own_settings;           // GLSL struct; none: the function takes no settings of its own
    std::vector<MethodMember> members;  // of the struct, in its order
    SampleUnit unit = SampleUnit::one;
    double on_a_plane = 0.0;     // its result on a bare plane
    bool reads_normals = false;  // of the surfaces under its samples, not of the pixel's own alone
    void (*adapt)(Settings&) =
        nullptr;  // what it needs beside a preset's settings; lengths for a radius of 1
    Preparation (*prepare)(const Settings&, backend::Extent view) = nullptr;  // none: no preparation
    std::vector<Preset> (*presets)(const MethodInfo&) = nullptr;              // as published and compared
};

// All methods; the first is the default.
[[nodiscard]] const std::vector<MethodInfo>& methods();

// The method with this name. Throws std::invalid_argument that lists the names.
[[nodiscard]] const MethodInfo& method_named(std::string_view name);

// The settings, changed to use another method, with its own default values; lengths are for a radius of 1.
// Those of the frame, which has one method, become Settings{}.
// Throws like method_named().
[[nodiscard]] Settings with_method(Settings settings, std::string_view name);

// Number of samples in one unit of the method. steps: MethodValues::steps.
[[nodiscard]] std::uint32_t unit_of(const MethodInfo& method, std::uint32_t steps);

// Samples that the method takes if `count` are asked for: whole units, at least one; 0 for 0.
[[nodiscard]] std::uint32_t samples_taken(const MethodInfo& method, std::uint32_t count, std::uint32_t steps);

// File of the method's function, as shaders include it: "gloam/methods/hbao.glsl".
[[nodiscard]] std::string file_of(const MethodInfo& method);

// Member of MethodValues that a member of the method's struct is set to; empty: a constant.
[[nodiscard]] std::string setting_of(const MethodMember& member);

// Whether the method's struct has a member that is set to this member of MethodValues.
[[nodiscard]] bool reads(const MethodInfo& method, std::string_view setting);

// GLSL call of the method's function, with the variables `position`, `normal`, `camera`, `kernel`, and
// `values` of type MethodValues (passes/study/method_values.glsl).
[[nodiscard]] std::string call_of(const MethodInfo& method);

[[nodiscard]] std::string to_string(Measure measure);

}  // namespace gloam::effect
