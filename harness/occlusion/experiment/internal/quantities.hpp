// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/results.hpp"
#include "experiment/table.hpp"

namespace gloam::experiment::internal {

// A quantity that is no time.
struct Quantity {
    std::string name;
    std::function<std::optional<double>(const Cell&)> of;
};
[[nodiscard]] const std::vector<Quantity>& untimed();

// Any quantity of a cell. nullopt where it was not measured.
[[nodiscard]] std::optional<double> value_of(const Cell& cell, std::string_view quantity,
                                             std::string_view statistic, const Part& part);

[[nodiscard]] double median_of_round(const std::vector<FrameReading>& round, const Part& part);

}  // namespace gloam::experiment::internal
