// SPDX-License-Identifier: MIT
#include "cli/render_settings.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

#include "cli/preset_file.hpp"
#include "effect/methods.hpp"
#include "effect/setting_table.hpp"

namespace gloam::cli {
namespace {

// Applies NAME=VALUE. The method and the radius also change other settings, so --method and --radius apply
// them.
void apply(effect::Settings& settings, const std::string& assignment) {
    const std::size_t sign = assignment.find('=');
    if (sign == std::string::npos) {
        throw std::invalid_argument(
            fmt::format("--set {}: expected NAME=VALUE (gloam list settings)", assignment));
    }
    const std::string name = assignment.substr(0, sign);
    if (name == "method" || name == "radius")
        throw std::invalid_argument(fmt::format("--set {}: expected --{} instead", assignment, name));
    effect::set(settings, name, assignment.substr(sign + 1));
}

}  // namespace

effect::Settings settings_for(const RenderOptions& options, const std::optional<double>& view_radius) {
    effect::Settings settings = preset_settings(options.preset);
    if (!options.method.empty() && options.method != settings.method)
        settings = with_method(settings, options.method);
    if (!options.radius && !view_radius) {
        throw std::invalid_argument("no radius: the G-buffer has no ao_radius, so give --radius");
    }
    settings = with_radius(settings, options.radius.value_or(static_cast<float>(view_radius.value_or(1.0))));
    if (options.samples) settings.samples = *options.samples;
    if (options.no_filter) settings.filter = effect::Filter::none;
    if (options.bias) settings.bias = *options.bias;
    if (options.guard) settings.guard = *options.guard;
    for (const std::string& assignment : options.set) apply(settings, assignment);
    validate(settings);
    return settings;
}

}  // namespace gloam::cli
