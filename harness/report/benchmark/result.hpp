// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gloam::report {

// One thing that is measured. Two are the same when all members are.
struct Configuration {
    std::string scene;
    std::string method;
    std::string preset;         // empty: the method with its own settings
    std::uint32_t samples = 0;  // asked for, for each pixel in each frame
    bool temporal = false;      // over the frames of a moving camera; else single frames

    friend auto operator<=>(const Configuration&, const Configuration&) = default;
};

// "columns/gtao/16/single": the preset in place of the method where there is one. Names it among all others.
[[nodiscard]] std::string key_of(const Configuration& configuration);

// The same without the scene: what one would choose.
[[nodiscard]] std::string choice_of(const Configuration& configuration);

// What a frame took on the device, in milliseconds, and what a copy took at that moment.
struct Reading {
    std::vector<std::pair<std::string, double>> passes;  // in their order
    double copy_ms = 0.0;
};

// How near a configuration comes to the truth: means over the scored frames. NaN: not known.
struct Quality {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    double raw_geometry = unknown;  // RMSE of the estimate against (G), the geometry
    double raw_depth = unknown;     // against (D), the depth buffer
    double geometry = unknown;      // RMSE of what is shown, the filtered image
    double depth = unknown;
    double similarity = unknown;     // SSIM of what is shown and (G), in the last scored frame
    double flicker = unknown;        // mean change of what is shown from frame to frame; of temporal ones
    double samples = unknown;        // really taken, for each pixel with geometry
    std::uint64_t memory_bytes = 0;  // of the images and buffers that the passes use
};

// A median with the quartiles around it. NaN of nothing.
struct Spread {
    double median = std::numeric_limits<double>::quiet_NaN();
    double low = std::numeric_limits<double>::quiet_NaN();   // lower quartile
    double high = std::numeric_limits<double>::quiet_NaN();  // upper quartile
};

// What is known of a configuration.
struct Row {
    Configuration configuration;
    Quality quality;
    std::vector<std::pair<std::string, double>> passes;  // median of each, milliseconds
    Spread gather_ms;                                    // the passes that take samples
    Spread total_ms;                                     // all passes
    Spread gather_copies;                                // the same in copies
    Spread total_copies;
    std::size_t readings = 0;
};

// How a time grows with something: time ~ value^exponent.
struct Growth {
    std::string of;  // "pixels", "samples", ...
    std::string method;
    std::vector<std::pair<double, double>> points;               // value, milliseconds of all passes
    double exponent = std::numeric_limits<double>::quiet_NaN();  // least squares on logarithmic axes
    std::vector<double> open;  // part of the tiles found open at each point, in [0, 1]; empty: not counted
};

// A figure of the framework itself.
struct Figure {
    std::string name;
    std::string unit;
    double value = 0.0;
};

// A run of the benchmark: under which circumstances, and what it found.
struct Benchmark {
    std::string device;
    std::string driver;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    int frames = 0;  // of a temporal run
    int scored = 0;  // of them, the last ones
    int repeat = 0;  // rounds
    int rays = 0;    // of the truth, for each pixel
    Spread copy_ms;
    std::vector<Row> rows;
    std::vector<Growth> scaling;
    std::vector<Figure> framework;
    std::string versions{};  // of gloam and of the compilers; empty: not known
};

}  // namespace gloam::report
