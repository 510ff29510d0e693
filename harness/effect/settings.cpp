// SPDX-License-Identifier: MIT
#include "effect/settings.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace gloam::effect {
namespace {

constexpr float largest = 1e18F;  // squares stay finite
constexpr float exact_integers = 8'388'608.0F;
constexpr std::uint32_t largest_half_count = 2048;  // integers up to it are exact in float16

// Written so that NaN fails.
void require(bool holds, const char* name, double value, const char* expected) {
    if (!holds) throw std::invalid_argument(fmt::format("{} {:g}: expected {}", name, value, expected));
}

void require_length(float value, const char* name) {
    require(value > 1e-18F && value <= largest, name, value, "a length from 1e-18 to 1e18");
}

}  // namespace

Settings with_radius(Settings settings, float radius) {
    require_length(radius, "radius");
    const float scale = radius / settings.radius;
    settings.radius = radius;
    settings.bias *= scale;
    settings.range *= scale;
    settings.epsilon *= scale;
    settings.thickness *= scale;
    settings.change_tolerance *= scale;
    return settings;
}

bool remaps(const Settings& settings) {
    return settings.remap_a != 0.0F || settings.remap_b != 1.0F || settings.remap_c != 1.0F;
}

void validate(const Settings& s) {
    require_length(s.radius, "radius");
    require_length(s.range, "range");
    require_length(s.epsilon, "epsilon");
    require_length(s.thickness, "thickness");
    require(s.bias >= 0.0F && s.bias <= largest, "bias", s.bias, "a length from 0 to 1e18");
    require(s.samples >= 1 && s.samples <= most_samples, "samples", s.samples, "1 to 2048");
    require(s.samples_converged >= 1 && s.samples_converged <= most_samples, "samples when converged",
            s.samples_converged, "1 to 2048");
    require(s.c_spatial >= 0.0F, "c_spatial", s.c_spatial, "0 or more");
    require(s.depth_tolerance > 0.0F, "depth tolerance", s.depth_tolerance, "more than 0");
    require_length(s.change_tolerance, "change tolerance");
    require(s.weight_small >= 0.0F, "small weight", s.weight_small, "0 or more");
    require(s.confidence_factor >= 0.0F && s.confidence_factor <= largest, "confidence factor",
            s.confidence_factor, "0 to 1e18");
    const bool half = s.precision == HistoryPrecision::float16;
    require(!half || s.table_size <= largest_half_count, "table size", s.table_size,
            "at most 2048 with a history in float16");
    require(!half || s.weight_max <= static_cast<float>(largest_half_count), "largest weight", s.weight_max,
            "at most 2048 with a history in float16");
    require(s.table_size >= 1 && s.table_size <= 1U << 24U, "table size", s.table_size, "1 to 16777216");
    require(s.weight_max >= 1.0F && s.weight_max <= exact_integers, "largest weight", s.weight_max,
            "1 to 8388608");
    require(s.c_rot >= 0.0F, "c_rot", s.c_rot, "0 or more");
    require(s.c_adaptive >= 0.0F, "c_adaptive", s.c_adaptive, "0 or more");
    require(s.filter_half_width >= 0 && s.filter_half_width <= 64, "filter half width", s.filter_half_width,
            "0 to 64");
    require(s.intensity >= 0.0F && s.intensity <= largest, "intensity", s.intensity, "0 to 1e18");
    require(s.angle_bias >= 0.0F && s.angle_bias <= 1.5707964F, "angle bias", s.angle_bias, "0 to pi / 2");
    require(s.mip_distance >= 0.0F, "mip distance", s.mip_distance, "0 or more");
    require(s.steps >= 1 && s.steps <= 64, "steps", s.steps, "1 to 64");
    require(s.remap_a >= -1.0F && s.remap_a <= 1.0F, "remap a", s.remap_a, "-1 to 1");
    require(s.remap_b >= 0.0F && s.remap_b <= largest, "remap b", s.remap_b, "0 to 1e18");
    require(s.remap_c >= 0.0F && s.remap_c <= largest, "remap c", s.remap_c, "0 to 1e18");
    require(s.guard >= 0.0F && s.guard <= 0.5F, "guard", s.guard, "0 to 0.5");
    require(s.least_radius >= 0.0F, "least radius", s.least_radius, "0 or more");
}

}  // namespace gloam::effect
