// SPDX-License-Identifier: MIT
#pragma once

#include "report/benchmark/result.hpp"
#include "report/internal/json_fields.hpp"

namespace gloam::report::internal {

// The common parts of a benchmark's journal and result file, as JSON and back. Reading throws like
// JsonReader.
[[nodiscard]] nlohmann::ordered_json to_json(const Configuration& configuration);
[[nodiscard]] Configuration configuration_from(const JsonReader& json);
[[nodiscard]] nlohmann::ordered_json to_json(const Quality& quality);
[[nodiscard]] Quality quality_from(const JsonReader& json);
[[nodiscard]] nlohmann::ordered_json passes_json(const std::vector<std::pair<std::string, double>>& passes);
[[nodiscard]] std::vector<std::pair<std::string, double>> passes_from(const JsonReader& json);

}  // namespace gloam::report::internal
