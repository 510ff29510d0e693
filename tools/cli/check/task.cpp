// SPDX-License-Identifier: MIT
#include "cli/check/task.hpp"

#include "base/text.hpp"
#include "report/json.hpp"

namespace gloam::cli {
namespace {

using nlohmann::json;

constexpr auto replace = json::error_handler_t::replace;  // of bytes that are no UTF-8

}  // namespace

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CheckTask, equation, variant, inputs, seed, coverage, file, ranges,
                                   includes)

std::string to_line(const CheckTask& task) {
    return json(task).dump(-1, ' ', false, replace);
}

CheckTask task_from(std::string_view line) {
    base::require_bounded_json(line);
    return json::parse(line).get<CheckTask>();
}

std::string to_line(const Greeting& greeting) {
    json object{{"devices", json::array()}, {"error", greeting.error}};
    for (const report::DeviceSummary& device : greeting.devices)
        object["devices"].push_back(report::to_json(device));
    return object.dump(-1, ' ', false, replace);
}

Greeting greeting_from(std::string_view line) {
    const nlohmann::ordered_json object = report::parse_json(line);
    const report::JsonReader all(object, "");
    Greeting greeting{.devices = {}, .error = all.member("error").text()};
    for (const std::string& device : all.member("devices").texts())
        greeting.devices.push_back(report::device_from_json(device));
    return greeting;
}

}  // namespace gloam::cli
