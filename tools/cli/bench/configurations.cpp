// SPDX-License-Identifier: MIT
#include "cli/bench/configurations.hpp"

#include <algorithm>
#include <stdexcept>

#include "effect/methods.hpp"
#include "effect/presets.hpp"
#include "experiment/configuration_study.hpp"
#include "scene/scene.hpp"

namespace gloam::cli {
namespace {

// The methods with sample counts or presets that are measured in each scene and mode.
std::vector<std::string> methods_asked(const BenchmarkOptions& options) {
    const bool all = std::ranges::find(options.methods, "all") != options.methods.end();
    if (!options.methods.empty() && !all) {
        for (const std::string& name : options.methods) (void)effect::method_named(name);
        return options.methods;
    }
    std::vector<std::string> names;
    for (const effect::MethodInfo& method : effect::methods()) names.push_back(method.name);
    return names;
}

std::vector<effect::Preset> presets_asked(const BenchmarkOptions& options) {
    if (std::ranges::find(options.presets, "all") != options.presets.end()) return effect::presets();
    std::vector<effect::Preset> presets;
    for (const std::string& name : options.presets) presets.push_back(effect::preset_named(name));
    return presets;
}

void append_scene(std::vector<MeasuredConfiguration>& all, const std::string& scene, bool temporal,
                  const BenchmarkOptions& options) {
    // Only presets were named: only they are measured.
    if (options.presets.empty() || !options.methods.empty()) {
        for (const std::string& method : methods_asked(options)) {
            for (const std::uint32_t samples : options.samples) {
                all.push_back({{.scene = scene, .method = method, .samples = samples, .temporal = temporal},
                               experiment::measured_settings(method, samples, temporal)});
            }
        }
    }
    for (const effect::Preset& preset : presets_asked(options)) {
        all.push_back({{.scene = scene,
                        .method = preset.settings.method,
                        .preset = preset.name,
                        .samples = preset.settings.samples,
                        .temporal = temporal},
                       preset.settings});
    }
}

}  // namespace

std::vector<MeasuredConfiguration> configurations_of(const BenchmarkOptions& options) {
    std::vector<MeasuredConfiguration> all;
    for (const std::string& scene : options.scenes) {
        (void)scene::make_scene(scene);
        if (!options.temporal_only) append_scene(all, scene, false, options);
        if (!options.single_only) append_scene(all, scene, true, options);
    }
    std::vector<report::Configuration> names;
    for (const MeasuredConfiguration& one : all) names.push_back(one.configuration);
    std::ranges::sort(names);
    const auto twice = std::ranges::adjacent_find(names);
    if (twice != names.end())
        throw std::invalid_argument(report::key_of(*twice) + ": asked for twice, expected once");
    if (all.empty())
        throw std::invalid_argument("nothing to measure: expected a scene and a method or preset");
    return all;
}

}  // namespace gloam::cli
