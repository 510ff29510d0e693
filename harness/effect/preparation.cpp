// SPDX-License-Identifier: MIT
#include "effect/preparation.hpp"

#include "effect/methods.hpp"

namespace gloam::effect {

std::optional<Preparation> preparation_of(const Settings& settings, gpu::Extent view) {
    const MethodInfo& method = method_named(settings.method);
    if (method.prepare == nullptr) return std::nullopt;
    return method.prepare(settings, view);
}

gpu::Format prepared_format(const std::string& method) {
    Settings settings;
    settings.method = method;
    return preparation_of(settings, {1, 1}).value_or(Preparation{}).format;
}

}  // namespace gloam::effect
