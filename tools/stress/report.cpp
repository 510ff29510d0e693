// SPDX-License-Identifier: MIT
#include "stress/report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace gloam::stress {
namespace {

using nlohmann::ordered_json;

ordered_json number(double value) {
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";
    return value;
}

constexpr const char* layout = "{:9} {:58} {:50} {:>11} {:>11} {}";

}  // namespace

std::string table_header() {
    return fmt::format(layout, "run", "varied", "measured", "value", "bound", "verdict");
}

std::string table_line(const Row& row) {
    const std::string bound = row.bound ? fmt::format("{:.4g}", *row.bound) : "-";
    const char* verdict = !row.bound ? "measured" : row.passed() ? "ok" : "BROKEN";
    return fmt::format(layout, row.run, row.varied, row.quantity, fmt::format("{:.4g}", row.measured), bound,
                       verdict);
}

std::string to_json(const gpu::DeviceInfo& device, const Rows& rows, const std::string& versions) {
    ordered_json all = ordered_json::array();
    for (const Row& row : rows) {
        all.push_back({{"run", row.run},
                       {"varied", row.varied},
                       {"quantity", row.quantity},
                       {"measured", number(row.measured)},
                       {"bound", row.bound ? number(*row.bound) : ordered_json(nullptr)},
                       {"passed", row.passed()}});
    }
    ordered_json document{{"device", {{"name", device.name}, {"driver", device.driver}}}};
    if (!versions.empty()) document["versions"] = versions;
    document["rows"] = std::move(all);
    return document.dump(2) + "\n";
}

}  // namespace gloam::stress
