// SPDX-License-Identifier: MIT
#include "scene/falloff.hpp"

namespace gloam::scene {

double falloff_weight(Falloff falloff, double distance, double radius) {
    if (!(distance <= radius)) return 0.0;
    const double x = distance / radius;
    switch (falloff) {
        case Falloff::linear:
            return 1.0 - x;
        case Falloff::quadratic:
            return 1.0 - x * x;
        case Falloff::step:
            return 1.0;
    }
    return 0.0;
}

const char* name_of(Falloff falloff) {
    switch (falloff) {
        case Falloff::linear:
            return "linear";
        case Falloff::quadratic:
            return "quadratic";
        case Falloff::step:
            return "step";
    }
    return "";
}

std::optional<Falloff> falloff_named(std::string_view name) {
    for (const Falloff falloff : {Falloff::linear, Falloff::quadratic, Falloff::step}) {
        if (name == name_of(falloff)) return falloff;
    }
    return std::nullopt;
}

}  // namespace gloam::scene
