// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace gloam::effect {

// The passes of a frame.
enum class Passes {
    study,  // TSSAO as printed, around any method
    frame   // prepare, sweep, and filter or join (glsl/passes/frame): what engines take
};

// How much of a pixel's history counts if its neighbourhood has changed, but the pixel was not disoccluded
// (TSSAO-9, -SI).
enum class Invalidation {
    none,       // unchanged
    clamp,      // at most Settings::weight_small samples
    confidence  // times 1 / (1 + S change / radius)
};

// The texels of the previous frame from which a pixel takes its history.
enum class HistoryTaps {
    nearest,   // one
    bilinear,  // four, if the nearest passes the depth test
    validated  // those of four that pass the depth test
};

// The filter that smooths the estimate for display.
enum class Filter {
    none,
    convergence,  // weights by the neighbours' convergence (TSSAO-10)
    geometry,     // weights by normal and depth, the comparative study's (CS-BLUR)
    bilateral,    // weights by distance in the image and depth (ISSAO-7)
    sao           // every other pixel, by depth (McGuire et al. 2012)
};

// Format of the displayed occlusion. The history keeps its own precision.
enum class OutputFormat { r32f, r16f, r8 };

// What rotates the kernels of neighbouring pixels.
enum class Rotation {
    hash,    // McGuire's hash of the pixel (HASH-ROT)
    lattice  // its place on a lattice (LATTICE-ROT): a filter leaves less of the noise
};

// The size of the images that the passes run over.
enum class Resolution {
    full,  // the view's
    half,  // half of each side, rounded up; join.comp brings the result to the view's size by depth
    tiles  // half, and the view's in those tiles that mark.comp finds
};

// Taps to each side of the one slice at half size where tiles are swept in full.
constexpr std::uint32_t steps_before_tiles = 5;

// The most samples of a frame. llvmpipe ends a shader's loops after 65,535 iterations in all, without a
// message, and a sample of a high index takes up to 26 iterations (the digits of its Halton point). With more
// samples than this, some could be lost. Take more frames instead.
constexpr std::uint32_t most_samples = 2'048;

// A cap above every projected radius, in pixels: no cap.
constexpr float no_radius_cap = 1e18F;

// What single methods take beside what all of them take, in the layout of the passes' buffer.
struct MethodValues {
#define CHOICE(...)
#define FLAG(...)
#define METHOD(...)
#define NUMBER(...)
#define OWN(type, name, value, ...) type name = value;
#include "effect/setting_list.inc"
};

// All settings that affect a frame: effect/setting_list.inc says what each is.
struct Settings {
#define CHOICE(type, name, value, ...) type name = value;
#define FLAG(name, value, ...) bool name = value;
#define METHOD(name, value, ...) std::string name = value;
#define NUMBER(type, name, value, ...) type name = value;
#define OWN(...)
#include "effect/setting_list.inc"
    MethodValues own;
};

// Slices of a pixel of the frame, `steps` taps to both sides of each: as many as `samples` has whole, at
// least one.
[[nodiscard]] std::uint32_t slices_of(const Settings& settings);

// Whether a filter is applied to the estimate.
[[nodiscard]] bool filters(const Settings& settings);

// Whether the occlusion of a frame is all that its passes keep: without a history and without a filter.
[[nodiscard]] bool shows_alone(const Settings& settings);

// Whether the displayed values differ from the estimate: by a remap, or by an output format of fewer bits.
// The remap pass then writes them.
[[nodiscard]] bool remaps(const Settings& settings);

// The same settings for another radius: all lengths in world units are scaled with it.
[[nodiscard]] Settings with_radius(Settings settings, float radius);

// Throws std::invalid_argument that names the first setting outside its range, or that is not that of
// Settings{} though the passes do not read it.
void validate(const Settings& settings);

// The value of a setting: a switch, a number, or one of several names.
using SettingValue = std::variant<bool, double, std::string>;

// The range of a number.
struct SettingRange {
    double least = 0.0;
    double most = std::numeric_limits<double>::infinity();
    bool above_least = false;  // `least` itself is excluded
    bool whole = false;
};

// The passes that read a setting.
enum class ReadBy { study, frame, both };

// One parameter of the effect: a row of setting_list.inc, for all code that reads, writes, checks, lists or
// prints settings.
struct Setting {
    std::string name;  // of the member
    ReadBy read_by;
    std::string unit;     // "world units", "pixels", ...; empty: none. World units scale with the radius
    std::string meaning;  // in a few words
    SettingRange range;   // of a number
    std::vector<std::string> choices;  // names, if its value is a name
    std::function<SettingValue(const Settings&)> get;
    std::function<void(Settings&, const SettingValue&)> put;  // sets a value that check() accepts
};

// All settings, in the order of the list.
[[nodiscard]] const std::vector<Setting>& setting_table();

// Whether these passes read the setting. All others have the value of Settings{}.
[[nodiscard]] bool reads(const Settings& settings, const Setting& setting);

// The setting with this name. Throws std::invalid_argument that lists the names.
[[nodiscard]] const Setting& setting_named(std::string_view name);

// The allowed values as text: "1 to 2048", "on or off", "nearest, bilinear or validated".
[[nodiscard]] std::string expected_of(const Setting& setting);

// Throws std::invalid_argument that names the setting, the value and what was expected. NaN is outside every
// range.
void check(const Setting& setting, const SettingValue& value);

// The value as text that set() reads: "on", "off", a number or a name.
[[nodiscard]] std::string text_of(const SettingValue& value);

// Changes the setting with this name. Throws like setting_named() and check(), and for text that is not a
// value.
void set(Settings& settings, std::string_view name, std::string_view text);

}  // namespace gloam::effect
