// SPDX-License-Identifier: MIT
#include "report/check_report.hpp"
#include "report/internal/answer_json.hpp"

namespace gloam::report {
namespace {

using internal::JsonReader;
using nlohmann::ordered_json;

constexpr auto replace = ordered_json::error_handler_t::replace;  // of bytes that are no UTF-8

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

DeviceSummary read_device(const JsonReader& json) {
    const JsonReader controls = json.member("float_controls");
    return {.name = json.member("name").name(),
            .driver = json.member("driver").name(),
            .type = json.member("type").name(),
            .api_version = json.member("api_version").name(),
            .preserves_signed_zero_inf_nan = controls.member("signed_zero_inf_nan_preserve").flag(),
            .preserves_denormals = controls.member("denorm_preserve").flag(),
            .flushes_denormals = controls.member("denorm_flush_to_zero").flag(),
            .rounds_to_even = controls.member("rounding_mode_rte").flag()};
}

CheckReport read_report(const JsonReader& json) {
    CheckReport report{.device = read_device(json.member("device")), .rows = {}};
    if (json.has("versions")) report.versions = json.member("versions").name();
    for (const JsonReader& row : json.member("results").elements()) {
        report.rows.push_back(internal::read_answer(row));
    }
    return report;
}

}  // namespace

std::string name_of(const DeviceSummary& device) {
    return device.driver.empty() ? device.name : device.name + " (" + device.driver + ")";
}

std::string api_of(const DeviceSummary& device) {
    const bool names_itself = device.type.starts_with("opengl") || device.type.starts_with("webg");
    return names_itself ? device.api_version : "Vulkan " + device.api_version;
}

std::string to_json(const DeviceSummary& device) {
    return device_json(device).dump(-1, ' ', false, replace);
}

DeviceSummary device_from_json(std::string_view text) {
    const ordered_json json = internal::parse_json(text);
    return read_device(JsonReader(json, ""));
}

std::string to_json(const std::vector<CheckReport>& reports) {
    ordered_json all = ordered_json::array();
    for (const CheckReport& report : reports) {
        ordered_json results = ordered_json::array();
        for (const check::Answer& row : report.rows) results.push_back(internal::answer_json(row));
        ordered_json object{{"device", device_json(report.device)}};
        if (!report.versions.empty()) object["versions"] = report.versions;
        object["results"] = std::move(results);
        all.push_back(std::move(object));
    }
    return (all.size() == 1 ? all.front() : all).dump(2, ' ', false, replace) + "\n";
}

std::vector<CheckReport> reports_from_json(std::string_view text) {
    const ordered_json json = internal::parse_json(text);
    const JsonReader all(json, "");
    if (!all.is_array()) return {read_report(all)};
    std::vector<CheckReport> reports;
    for (const JsonReader& report : all.elements()) reports.push_back(read_report(report));
    return reports;
}

}  // namespace gloam::report
