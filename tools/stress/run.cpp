// SPDX-License-Identifier: MIT
#include "stress/run.hpp"

#include <stdexcept>

#include "stress/far_away.hpp"
#include "stress/long_run.hpp"
#include "stress/poison.hpp"
#include "stress/shapes.hpp"
#include "stress/worst_inputs.hpp"

namespace gloam::stress {

std::vector<effect::MethodInfo> methods_of(const Context& context) {
    if (context.methods.empty()) return effect::methods();
    std::vector<effect::MethodInfo> methods;
    for (const std::string& name : context.methods) methods.push_back(effect::method_named(name));
    return methods;
}

std::vector<Run> all_runs() {
    return {{"worst-inputs", "the input of each equation with the largest error, searched for", worst_inputs},
            {"long-run", "the history over very many frames, in float32 and float16", long_run},
            {"far-away", "scene and camera moved far from the origin together", far_away},
            {"poison", "NaN, infinities and other bad values in every buffer", poison},
            {"shapes", "image sizes, radii and sample counts at their ends", shapes}};
}

std::vector<Run> select_runs(const std::string& name) {
    if (name.empty()) return all_runs();
    std::string names;
    for (const Run& run : all_runs()) {
        if (run.name == name) return {run};
        names += (names.empty() ? "" : ", ") + run.name;
    }
    throw std::invalid_argument("unknown stress run \"" + name + "\": expected " + names);
}

}  // namespace gloam::stress
