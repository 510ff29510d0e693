// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/version.hpp"
#include "experiment/internal/quantities.hpp"

namespace gloam::experiment {
namespace {

using internal::Quantity;
using internal::value_of;
using nlohmann::ordered_json;

// For a quoted field of CSV.
std::string quoted(std::string text) {
    for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2) text.insert(at, 1, '"');
    return text;
}

ordered_json json_of(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json json_of(const Cell& cell, const std::string& candidate) {
    ordered_json json{{"candidate", candidate}};
    for (const Quantity& quantity : internal::untimed()) json[quantity.name] = json_of(quantity.of(cell));
    if (cell.quality) json["memory_bytes"] = cell.quality->memory_bytes;
    json["ms"] = json_of(value_of(cell, "ms", "median", {}));
    json["passes"] = ordered_json::array();
    for (const std::string& pass : passes_of(cell))
        json["passes"].push_back({{"pass", pass},
                                  {"ms", json_of(value_of(cell, "ms", "median", {.name = pass}))},
                                  {"least_ms", json_of(value_of(cell, "ms", "least", {.name = pass}))}});
    ordered_json rounds = ordered_json::array();
    for (const std::vector<FrameReading>& round : cell.rounds)
        if (!round.empty()) rounds.push_back(internal::median_of_round(round, {}));
    json["rounds_ms"] = rounds;
    return json;
}

ordered_json json_of(const Experiment& experiment, const CaseResult& one) {
    ordered_json json{{"case", one.shown.name}};
    for (const auto& [name, text] :
         {std::pair("what", &one.shown.what), {"kind", &one.shown.kind}, {"half", &one.shown.half}})
        if (!text->empty()) json[name] = *text;
    if (one.shown.target > 0.0) json["target"] = one.shown.target;
    json["results"] = ordered_json::array();
    for (std::size_t i = 0; i < one.cells.size(); ++i)
        if (one.cells[i]) json["results"].push_back(json_of(*one.cells[i], experiment.candidates[i].name));
    return json;
}

}  // namespace

std::string to_json(const Experiment& experiment, const std::vector<SizeResult>& results,
                    const Record& record, const std::string& versions) {
    ordered_json document{{"gloam", base::version()}, {"versions", versions}};
    document.update(ordered_json::parse(record.heading()));
    document["sizes"] = ordered_json::array();
    for (const SizeResult& result : results) {
        ordered_json size{{"width", result.extent.width},
                          {"height", result.extent.height},
                          {"cases", ordered_json::array()}};
        for (const CaseResult& one : result.cases) size["cases"].push_back(json_of(experiment, one));
        document["sizes"].push_back(std::move(size));
    }
    document["visits"] = ordered_json::array();
    for (const Visit& visit : record.visits())
        document["visits"].push_back(ordered_json::parse(line_of(visit)));
    return document.dump(1) + "\n";
}

std::string to_csv(const Experiment& experiment, const std::vector<SizeResult>& results) {
    std::string text = fmt::format("width,height,case,what,candidate,{}\n", fmt::join(quantities(), ","));
    for (const SizeResult& result : results) {
        for (const CaseResult& one : result.cases) {
            for (std::size_t i = 0; i < one.cells.size(); ++i) {
                if (!one.cells[i]) continue;
                text += fmt::format("{},{},\"{}\",\"{}\",\"{}\"", result.extent.width, result.extent.height,
                                    quoted(one.shown.name), quoted(one.shown.what),
                                    quoted(experiment.candidates[i].name));
                for (const std::string& quantity : quantities()) {
                    const auto value = value_of(*one.cells[i], quantity, "median", {});
                    text += value && std::isfinite(*value) ? fmt::format(",{}", *value) : ",";
                }
                text += "\n";
            }
        }
    }
    return text;
}

}  // namespace gloam::experiment
