// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "numeric/numbers.hpp"

namespace gloam::report {

// A measured configuration. Two are equal if all members are.
struct Configuration {
    std::string scene;
    std::string method;
    std::string preset;         // empty: the method with its own settings
    std::uint32_t samples = 0;  // asked for, for each pixel in each frame
    bool temporal = false;      // over the frames of a moving camera; otherwise single frames

    friend auto operator<=>(const Configuration&, const Configuration&) = default;
};

// "columns/gtao/16/single"; a preset replaces the method. Unique among all configurations.
[[nodiscard]] std::string key_of(const Configuration& configuration);

// The same without the scene.
[[nodiscard]] std::string choice_of(const Configuration& configuration);

// Times on the device at the same moment, in milliseconds: of a frame, and of a copy.
struct Reading {
    std::vector<std::pair<std::string, double>> passes;  // in their order
    double copy_ms = 0.0;
};

// The quality of a configuration: means over the scored frames. NaN: unknown.
struct Quality {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    double raw_geometry = unknown;  // RMSE of the estimate against (G), the geometry
    double raw_depth = unknown;     // RMSE of the estimate against (D), the depth buffer
    double geometry = unknown;      // RMSE of the displayed, filtered image
    double depth = unknown;
    double similarity = unknown;     // SSIM of the displayed image and (G), in the last scored frame
    double flicker = unknown;        // mean change of the displayed image between frames; temporal only
    double samples = unknown;        // taken for each pixel with geometry, mean
    std::uint64_t memory_bytes = 0;  // of the images and buffers that the passes use
};

using numeric::Spread;
using numeric::spread_of;

// All results of a configuration.
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

// A figure of the framework itself.
struct Figure {
    std::string name;
    std::string unit;
    double value = 0.0;
};

// A run of the benchmark: its conditions and its results.
struct Benchmark {
    std::string device;
    std::string driver;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    int frames = 0;  // of a temporal run
    int scored = 0;  // the last ones of these
    int repeat = 0;  // rounds
    int rays = 0;    // of the truth, for each pixel
    Spread copy_ms;
    std::vector<Row> rows;
    std::vector<Figure> framework;
    std::string versions{};  // of gloam and of the compilers; empty: unknown
};

}  // namespace gloam::report
