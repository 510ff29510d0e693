// SPDX-License-Identifier: MIT
#include "report/benchmark/result.hpp"

#include <fmt/format.h>

namespace gloam::report {

std::string choice_of(const Configuration& configuration) {
    return fmt::format("{}/{}/{}", configuration.preset.empty() ? configuration.method : configuration.preset,
                       configuration.samples, configuration.temporal ? "temporal" : "single");
}

std::string key_of(const Configuration& configuration) {
    return configuration.scene + "/" + choice_of(configuration);
}

}  // namespace gloam::report
