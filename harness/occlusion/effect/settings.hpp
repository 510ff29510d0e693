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
    half   // half of each side, rounded up; join.comp brings the result to the view's size by depth
};

// The smallest projected radius worth sampling: below it all samples fall on the pixel itself.
constexpr float one_pixel = 1.0F;

// The most samples of a frame. llvmpipe ends a shader's loops after 65,535 iterations in all, without a
// message, and a sample of a high index takes up to 26 iterations (the digits of its Halton point). With more
// samples than this, some could be lost. Take more frames instead.
constexpr std::uint32_t most_samples = 2'048;

// A cap above every projected radius, in pixels: no cap.
constexpr float no_radius_cap = 1e18F;

// What single methods take beside what all of them take, in the layout of MethodValues in the passes' buffer
// (passes/study/method_values.glsl). The descriptor of a method names those that it reads
// (MethodInfo::reads).
struct MethodValues {
    float range =
        2.0F;  // hemisphere: blockers further in front than this are other objects; world units, > 0
    float epsilon = 0.5F;       // disc: distance at which a patch counts fully, world units, > 0
    float intensity = 1.0F;     // factor of the estimate, >= 0
    float thickness = 0.5F;     // bitmask: how far behind its front a surface blocks, world units, > 0
    float angle_bias = 0.0F;    // horizons: radians above the tangent plane, 0 to pi / 2
    float mip_distance = 0.0F;  // taps: pixels from which level 1 of the depth chain is read; 0: never
    std::uint32_t steps = 4;    // horizons: taps along each half of a slice; mssao: resolutions; 1 to 64
    float disagreement = 0.1F;  // dual resolution: of neighbours at half the resolution, in occlusion, beyond
                                // which a pixel is sampled in full; 0 to 1
    float feature_thickness = 1.0F;  // sweep: of what stands in front of the rest, in its own widths, >= 0;
                                     // 1e18: solid behind every surface
    std::int32_t layers = 1;  // hemisphere, ssdo, dual resolution: of depth that samples see, 1 to 4; the
                              // view must have as many
};

// All settings that affect a frame. Unless its comment says otherwise, a default is that of the preset
// `tssao-paper` for a radius of 1. Each setting has a line in setting_table(), with its range.
struct Settings {
    Passes passes = Passes::study;
    std::string method = "hemisphere";  // estimator of the occlusion: a name of methods()
    float radius = 1.0F;                // of influence, world units, > 0
    float bias = 0.001F;      // world units, >= 0: differences below it count as rounding, not as occlusion
    float bias_depth = 0.0F;  // the bias is at least this share of the depth, 0 to 1: for depths that are
                              // rounded coarsely, 0.002 for those from halves
    MethodValues own;         // the method's own
    std::uint32_t samples =
        32;  // k_1, for each pixel that has not converged, in each frame, 1 to most_samples
    std::uint32_t samples_converged = 16;  // k_2, for each pixel that has, 1 to most_samples
    float samples_distance = 0.0F;  // CS-N, of the far plane, world units: k / (1 + k depth / distance)
                                    // samples; 0: k everywhere
    float samples_radius =
        0.0F;  // ISSAO-LOD, pixels: fewer than k where the projected radius is smaller; 0: k everywhere
    std::uint32_t samples_least = 4;  // least number of those two, or k if less; 0 to most_samples
    float radius_cap =
        no_radius_cap;  // pixels: the radius shrinks where its projection would be larger (CS-G), > 0
    bool reject_taps =
        false;  // points, taps, slices: those further in front than `range` are skipped (CS-REJ)
    float smoothing =
        0.0F;  // share of each frame in an exponential mean (CS-G), 0 to 1; 0: the mean of all (eq. 5)
    float c_spatial = 0.3F;             // convergence from which a pixel takes k_2; above 1: never
    std::uint32_t table_size = 65'536;  // samples after which the sequence starts over, 1 to 2^24
    float weight_max = 500.0F;          // largest number of samples in the mean, 1 to 2^23
    float c_rot = 0.5F;  // kernels are rotated by pixel below this convergence; 0: never, above 1: always
    Rotation rotation = Rotation::hash;
    float c_adaptive = 0.2F;        // the filter does not change pixels of at least this convergence
    float depth_tolerance = 0.02F;  // relative: another surface beyond it (TSSAO-8), > 0; infinity: no test
    bool history = true;            // off: each frame is independent, with the first samples of the sequence
    HistoryTaps taps = HistoryTaps::validated;
    Invalidation invalidation = Invalidation::confidence;
    float change_tolerance = 0.005F;  // changes of distance up to this count as rounding, world units, > 0
    float weight_small = 48.0F;       // clamp: samples, >= 0
    float confidence_factor = 30.0F;  // confidence: S, per radius of change, >= 0
    float history_range = 0.0F;       // of the frame: how far the mean may be from that of the last frames
    float history_sharpness = 0.0F;   // of the frame: part of the neighbours' weights that a long mean leaves
                                      // out of a new frame
    Filter filter = Filter::convergence;
    float filter_cap = 1e18F;   // neighbours weigh at most this many times the pixel's own convergence; 1e18:
                                // any number of times, as eq. 10 has it
    int filter_half_width = 2;  // taps on each side: 2 is 5 x 5; bilateral at most 16, sao at most 4, 2
                                // pixels apart
    float filter_sigma = 0.25F;  // convergence, bilateral: standard deviation of the Gaussian, of the whole
                                 // window's width, > 0
    float filter_depth = 0.1F;   // geometry, bilateral, sao: difference of depth that sets a neighbour apart,
                                 // world units, > 0
    float remap_a = 0.0F;        // displayed: (b (v + a))^c of the visibility v (CS-REMAP); -1 to 1
    float remap_b = 1.0F;        // 0 to 1e18
    float remap_c = 1.0F;        // 0 to 1e18
    OutputFormat output = OutputFormat::r32f;  // of the displayed occlusion
    Resolution resolution = Resolution::full;  // of the frame
    float least_radius =
        one_pixel;       // pixels: below this projected radius the occlusion is 0 without a sample; 0: never
    float guard = 0.0F;  // guard band of the view, part of the frame on each side, 0 to 0.5 (TSSAO-BORDER)
    bool guard_history = true;  // the band is sampled too: surfaces that enter from it have a history
};

// Whether these passes read the setting. All others have the value of Settings{}.
[[nodiscard]] bool reads(const Settings& settings, std::string_view setting);

// Slices of a pixel of the frame, `steps` taps to both sides of each: as many as `samples` has whole, at
// least one.
[[nodiscard]] std::uint32_t slices_of(const Settings& settings);

// Whether a filter is applied to the estimate.
[[nodiscard]] bool filters(const Settings& settings);

// Whether the occlusion of a frame is all that its passes keep: without a history and without a filter.
[[nodiscard]] bool shows_alone(const Settings& settings);

// Whether the displayed values are another function of the estimate than the estimate itself.
[[nodiscard]] bool maps(const Settings& settings);

// Whether the displayed values differ from the estimate: by a remap, or by an output format of fewer bits.
// The remap pass then writes them.
[[nodiscard]] bool remaps(const Settings& settings);

// The same settings for another radius: all lengths in world units are scaled with it.
[[nodiscard]] Settings with_radius(Settings settings, float radius);

// Throws std::invalid_argument that names the first setting outside its range in setting_table(), or that is
// not that of Settings{} though the passes do not read it.
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

// One parameter of the effect. All code that reads, writes, checks, lists or prints settings uses the table
// of them. A new member of Settings therefore needs one line in the table.
struct Setting {
    std::string name;     // of the member
    std::string unit;     // "world units", "pixels", ...; empty: none. World units scale with the radius
    std::string meaning;  // in a few words
    SettingRange range;   // of a number
    std::vector<std::string> choices;                           // names, if its value is a name
    std::vector<std::pair<std::string, std::string>> synonyms;  // that set() reads, and the choice they mean
    std::function<SettingValue(const Settings&)> get;
    std::function<void(Settings&, const SettingValue&)> put;  // sets a value that check() accepts
};

// Every member of Settings, in its order.
[[nodiscard]] const std::vector<Setting>& setting_table();

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
