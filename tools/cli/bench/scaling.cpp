// SPDX-License-Identifier: MIT
#include "cli/bench/scaling.hpp"

#include "cli/bench/image_size.hpp"
#include "cli/progress.hpp"
#include "effect/methods.hpp"
#include "effect/study/scaling_study.hpp"
#include "report/benchmark/growth.hpp"

namespace gloam::cli {

std::vector<report::Growth> measured_scaling(const BenchmarkOptions& options, const gpu::Device& device,
                                             const scene::PassLibrary& passes) {
    std::vector<std::string> methods = options.methods;
    if (methods.empty()) methods.push_back(effect::methods().front().name);
    std::vector<report::Growth> all;
    for (const std::string& method : methods) {
        effect::ScalingOptions asked{.method = method, .repeat = options.repeat};
        asked.sizes.clear();
        for (const std::string& size : options.scaling_sizes) asked.sizes.push_back(image_size(size));
        asked.progress = progress_bar(method + ", scaling");
        for (effect::ScalingRun& run : effect::study_scaling(device, passes, asked)) {
            const double exponent = report::exponent_of(run.points);
            all.push_back({run.of, method, std::move(run.points), exponent, std::move(run.open)});
        }
    }
    return all;
}

void check_scaling(const BenchmarkOptions& options) {
    for (const std::string& size : options.scaling_sizes) (void)image_size(size);
}

}  // namespace gloam::cli
