// SPDX-License-Identifier: MIT
#include "effect/methods.hpp"

#include <stdexcept>

#include "effect/internal/named.hpp"

namespace gloam::effect {

const std::vector<MethodInfo>& methods() {
    using enum Measure;
    static const std::vector<MethodInfo> all{
        {"hemisphere", "occlusion by points in the half ball (TSSAO-3, TSSAO-14)", cosine, "linear"},
        {"disc", "how concave the surface is, by surface points under a disc (TSSAO-12, TSSAO-13)", shape,
         "none"},
    };
    return all;
}

const MethodInfo& method_named(std::string_view name) {
    return named(methods(), name, "method");
}

Settings with_method(Settings settings, std::string_view name) {
    const MethodInfo& info = method_named(name);
    settings.method = info.name;
    if (info.adapt != nullptr) info.adapt(settings);
    return settings;
}

std::string to_string(Measure measure) {
    switch (measure) {
        case Measure::cosine:
            return "cosine-weighted";
        case Measure::uniform:
            return "uniform";
        case Measure::volume:
            return "volume";
        case Measure::shape:
            return "shape";
    }
    throw std::invalid_argument("a measure without a name");
}

}  // namespace gloam::effect
