// SPDX-License-Identifier: MIT
#include "report/benchmark/journal.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "report/benchmark/summary.hpp"
#include "report/internal/benchmark_fields.hpp"

namespace gloam::report {
namespace {

namespace fs = std::filesystem;
using internal::JsonReader;
using nlohmann::ordered_json;

constexpr std::size_t most_rounds = 1'000'000;

ordered_json setup_json(const JournalSetup& setup) {
    return {{"benchmark_journal", 1}, {"device", setup.device}, {"driver", setup.driver},
            {"width", setup.width},   {"height", setup.height}, {"frames", setup.frames},
            {"scored", setup.scored}, {"rays", setup.rays}};
}

std::string line_of(const Visit& visit) {
    ordered_json json{{"configuration", internal::to_json(visit.configuration)},
                      {"round", visit.round},
                      {"quality", visit.quality ? internal::to_json(*visit.quality) : ordered_json(nullptr)},
                      {"readings", ordered_json::array()}};
    for (const Reading& reading : visit.readings) {
        json["readings"].push_back({{"copy_ms", internal::number_json(reading.copy_ms)},
                                    {"passes", internal::passes_json(reading.passes)}});
    }
    return json.dump();
}

Visit visit_of(const std::string& line, const std::string& where) {
    const ordered_json document = internal::parse_json(line);
    const JsonReader json(document, where);
    Visit visit{.configuration = internal::configuration_from(json.member("configuration")),
                .round = static_cast<int>(json.member("round").count_up_to(most_rounds))};
    if (!json.member("quality").is_null()) visit.quality = internal::quality_from(json.member("quality"));
    for (const JsonReader& reading : json.member("readings").elements()) {
        visit.readings.push_back({.passes = internal::passes_from(reading.member("passes")),
                                  .copy_ms = reading.member("copy_ms").number()});
    }
    return visit;
}

}  // namespace

Journal::Journal(fs::path path, const JournalSetup& setup, bool resume)
    : file_(std::move(path), setup_json(setup).dump(), resume) {
    std::size_t number = 1;
    for (const std::string& line : file_.lines()) {
        ++number;
        try {
            Visit visit = visit_of(line, "");
            visits_[visit.configuration][visit.round] = std::move(visit);
        } catch (const std::runtime_error& error) {
            throw std::runtime_error(
                fmt::format("{}, line {}: {}", file_.path().string(), number, error.what()));
        }
    }
}

bool Journal::has(const Configuration& configuration, int round) const {
    const auto found = visits_.find(configuration);
    return found != visits_.end() && found->second.contains(round);
}

void Journal::add(Visit visit) {
    file_.add(line_of(visit));
    visits_[visit.configuration][visit.round] = std::move(visit);
}

Row Journal::row_of(const Configuration& configuration) const {
    std::optional<Quality> quality;
    std::vector<Reading> readings;
    const auto found = visits_.find(configuration);
    if (found != visits_.end()) {
        for (const auto& [round, visit] : found->second) {
            if (!quality) quality = visit.quality;
            readings.insert(readings.end(), visit.readings.begin(), visit.readings.end());
        }
    }
    return report::row_of(configuration, quality.value_or(Quality{}), readings);
}

Spread Journal::copies() const {
    std::vector<double> times;
    for (const auto& [configuration, visits] : visits_) {
        for (const auto& [round, visit] : visits)
            for (const Reading& reading : visit.readings) times.push_back(reading.copy_ms);
    }
    return spread_of(times);
}

}  // namespace gloam::report
