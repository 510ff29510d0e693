// SPDX-License-Identifier: MIT
#include "cli/check/task.hpp"

#include "report/json.hpp"

namespace gloam::cli {
namespace {

using nlohmann::json;

constexpr auto replace = json::error_handler_t::replace;  // of bytes that are no UTF-8

}  // namespace

std::string to_line(const CheckTask& task) {
    const json object{{"equation", task.equation}, {"variant", task.variant},   {"inputs", task.inputs},
                      {"seed", task.seed},         {"coverage", task.coverage}, {"file", task.file},
                      {"ranges", task.ranges},     {"includes", task.includes}};
    return object.dump(-1, ' ', false, replace);
}

CheckTask task_from(std::string_view line) {
    const nlohmann::ordered_json object = report::parse_json(line);
    const report::JsonReader task(object, "");
    return {.equation = task.member("equation").text(),
            .variant = task.member("variant").text(),
            .inputs = task.member("inputs").count(),
            .seed = task.member("seed").count(),
            .coverage = task.member("coverage").flag(),
            .file = task.member("file").text(),
            .ranges = task.member("ranges").texts(),
            .includes = task.member("includes").texts()};
}

std::string to_line(const Greeting& greeting) {
    const json object{{"device", report::to_json(greeting.device)},
                      {"devices", greeting.devices},
                      {"error", greeting.error}};
    return object.dump(-1, ' ', false, replace);
}

Greeting greeting_from(std::string_view line) {
    const nlohmann::ordered_json object = report::parse_json(line);
    const report::JsonReader greeting(object, "");
    return {.device = report::device_from_json(greeting.member("device").text()),
            .devices = greeting.member("devices").count(),
            .error = greeting.member("error").text()};
}

}  // namespace gloam::cli
