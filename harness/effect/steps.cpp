// SPDX-License-Identifier: MIT
#include "effect/internal/steps.hpp"

#include "effect/internal/work.hpp"
#include "gpu/commands.hpp"

namespace gloam::effect {

std::vector<PassTime> run(const gpu::Device& device, std::span<const Step> passes,
                          const std::array<std::uint32_t, 3>& groups, int repeat) {
    std::vector<std::vector<double>> times(passes.size());
    for (int i = 0; i < repeat; ++i) {
        gpu::Commands commands(device);
        commands.timestamp();
        for (const Step& pass : passes) {
            commands.dispatch(*pass.pipeline, pass.resources, groups, pass.parameters);
            commands.timestamp();
        }
        commands.submit();
        const std::vector<double> readings = commands.times_ms();
        for (std::size_t p = 0; p < passes.size(); ++p) times[p].push_back(readings[p + 1] - readings[p]);
    }
    std::vector<PassTime> medians;
    for (std::size_t p = 0; p < passes.size(); ++p) medians.push_back({passes[p].name, median(times[p])});
    return medians;
}

}  // namespace gloam::effect
