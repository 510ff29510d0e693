// SPDX-License-Identifier: MIT
#include "stress/run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/version.hpp"
#include "stress/long_run.hpp"

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
    ordered_json document{{"gloam", base::version()},
                          {"device", {{"name", device.name}, {"driver", device.driver}}}};
    if (!versions.empty()) document["versions"] = versions;
    document["rows"] = std::move(all);
    return document.dump(2) + "\n";
}

}  // namespace gloam::stress
