// SPDX-License-Identifier: MIT
#include <cmath>
#include <nlohmann/json.hpp>

#include "check/describe.hpp"
#include "report/check_report.hpp"

namespace gloam::report {
namespace {

using nlohmann::ordered_json;

// JSON has no infinity and no NaN.
ordered_json number(double value) {
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";
    return value;
}

ordered_json numbers(const std::vector<double>& values) {
    ordered_json array = ordered_json::array();
    for (const double value : values) array.push_back(number(value));
    return array;
}

ordered_json device_json(const DeviceSummary& device) {
    return {{"name", device.name},
            {"driver", device.driver},
            {"type", device.type},
            {"api_version", device.api_version},
            {"float_controls",
             {{"signed_zero_inf_nan_preserve", device.preserves_signed_zero_inf_nan},
              {"denorm_preserve", device.preserves_denormals},
              {"denorm_flush_to_zero", device.flushes_denormals},
              {"rounding_mode_rte", device.rounds_to_even}}}};
}

ordered_json worst_json(const check::Result& result) {
    if (!result.census.worst) return nullptr;
    const check::Sample& worst = *result.census.worst;
    return {
        {"input", worst.index},         {"class", check::name_of(worst.input_class)},
        {"images", worst.scenario},     {"values", check::describe_inputs(result.signature, worst.inputs)},
        {"input_words", worst.inputs},  {"got_words", worst.got},
        {"want", numbers(worst.want)},  {"ulp", number(worst.ulp)},
        {"abs", number(worst.absolute)}};
}

ordered_json classes_json(const check::Census& census) {
    ordered_json classes = ordered_json::object();
    for (std::size_t i = 0; i < check::input_class_count; ++i) {
        const check::ClassCount& count = census.classes[i];
        if (count.inputs == 0) continue;
        classes[std::string(check::name_of(static_cast<check::InputClass>(i)))] = {
            {"inputs", count.inputs}, {"outside", count.outside}, {"recorded", count.recorded}};
    }
    return classes;
}

ordered_json row_json(const CheckRow& row) {
    const check::Census& census = row.result.census;
    ordered_json json{{"equation", row.equation},
                      {"function", row.result.function},
                      {"file", row.result.file},
                      {"variant", row.variant},
                      {"inputs", census.inputs()},
                      {"outside", census.outside()},
                      {"recorded", census.recorded()},
                      {"max_ulp", number(census.max_ulp)},
                      {"max_abs", number(census.max_absolute)},
                      {"width_fraction", number(census.fraction)},
                      {"budget",
                       {{"ulp", row.result.budget.ulp},
                        {"abs", row.result.budget.absolute},
                        {"backward_ulp", row.result.budget.backward_ulp},
                        {"text", check::to_text(row.result.budget)}}},
                      {"classes", classes_json(census)},
                      {"worst", worst_json(row.result)}};
    if (row.result.fault) json["fault"] = check::to_text(*row.result.fault);
    if (!row.error.empty()) json["error"] = row.error;
    return json;
}

}  // namespace

std::string to_json(const std::vector<CheckReport>& reports) {
    ordered_json all = ordered_json::array();
    for (const CheckReport& report : reports) {
        ordered_json results = ordered_json::array();
        for (const CheckRow& row : report.rows) results.push_back(row_json(row));
        all.push_back({{"device", device_json(report.device)}, {"results", results}});
    }
    return (all.size() == 1 ? all.front() : all).dump(2) + "\n";
}

}  // namespace gloam::report
