// SPDX-License-Identifier: MIT
#include "report/benchmark/benchmark_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "report/internal/benchmark_fields.hpp"

namespace gloam::report {
namespace {

using internal::JsonReader;
using internal::number_json;
using nlohmann::ordered_json;

constexpr std::size_t version = 1;
constexpr std::size_t largest_setting = 1'000'000'000;  // pixels, frames, rounds, rays

ordered_json spread_json(const Spread& spread) {
    return {{"median", number_json(spread.median)},
            {"low", number_json(spread.low)},
            {"high", number_json(spread.high)}};
}

Spread spread_from(const JsonReader& json) {
    return {json.member("median").number(), json.member("low").number(), json.member("high").number()};
}

ordered_json row_json(const Row& row) {
    ordered_json json = internal::to_json(row.configuration);
    json["readings"] = row.readings;
    json["gather_ms"] = spread_json(row.gather_ms);
    json["total_ms"] = spread_json(row.total_ms);
    json["gather_copies"] = spread_json(row.gather_copies);
    json["total_copies"] = spread_json(row.total_copies);
    json["passes"] = internal::passes_json(row.passes);
    json["quality"] = internal::to_json(row.quality);
    return json;
}

Row row_from(const JsonReader& json) {
    return {.configuration = internal::configuration_from(json),
            .quality = internal::quality_from(json.member("quality")),
            .passes = internal::passes_from(json.member("passes")),
            .gather_ms = spread_from(json.member("gather_ms")),
            .total_ms = spread_from(json.member("total_ms")),
            .gather_copies = spread_from(json.member("gather_copies")),
            .total_copies = spread_from(json.member("total_copies")),
            .readings = json.member("readings").count()};
}

std::string cell(double value) {
    return std::isfinite(value) ? fmt::format(",{}", value) : std::string(",");
}

}  // namespace

std::string to_json(const Benchmark& benchmark) {
    ordered_json json{{"benchmark", version},
                      {"device", benchmark.device},
                      {"driver", benchmark.driver},
                      {"width", benchmark.width},
                      {"height", benchmark.height},
                      {"frames", benchmark.frames},
                      {"scored", benchmark.scored},
                      {"repeat", benchmark.repeat},
                      {"rays", benchmark.rays},
                      {"copy_ms", spread_json(benchmark.copy_ms)},
                      {"results", ordered_json::array()},
                      {"framework", ordered_json::array()}};
    if (!benchmark.versions.empty()) json["versions"] = benchmark.versions;
    for (const Row& row : benchmark.rows) json["results"].push_back(row_json(row));
    for (const Figure& figure : benchmark.framework) {
        json["framework"].push_back(
            {{"name", figure.name}, {"unit", figure.unit}, {"value", number_json(figure.value)}});
    }
    return json.dump(2) + "\n";
}

Benchmark benchmark_from_json(std::string_view text) {
    const ordered_json document = internal::parse_json(text);
    const JsonReader json(document, "");
    if (json.member("benchmark").count() != version) json.member("benchmark").expected("version 1");
    const auto whole = [&](const char* name) {
        return static_cast<int>(json.member(name).count_up_to(largest_setting));
    };
    Benchmark benchmark{.device = json.member("device").name(),
                        .driver = json.member("driver").name(),
                        .width = static_cast<std::uint32_t>(whole("width")),
                        .height = static_cast<std::uint32_t>(whole("height")),
                        .frames = whole("frames"),
                        .scored = whole("scored"),
                        .repeat = whole("repeat"),
                        .rays = whole("rays"),
                        .copy_ms = spread_from(json.member("copy_ms"))};
    if (json.has("versions")) benchmark.versions = json.member("versions").name();
    for (const JsonReader& row : json.member("results").elements()) benchmark.rows.push_back(row_from(row));
    for (const JsonReader& figure : json.member("framework").elements()) {
        benchmark.framework.push_back(
            {figure.member("name").name(), figure.member("unit").name(), figure.member("value").number()});
    }
    return benchmark;
}

std::string to_csv(const Benchmark& benchmark) {
    std::string text =
        "scene,method,preset,samples,mode,rmse_geometry,rmse_depth,rmse_raw_geometry,rmse_raw_depth,ssim,"
        "flicker,samples_taken,memory_bytes,gather_ms,total_ms,gather_copies,total_copies,readings\n";
    for (const Row& row : benchmark.rows) {
        const Configuration& c = row.configuration;
        const Quality& q = row.quality;
        text += fmt::format("{},{},{},{},{}", c.scene, c.method, c.preset, c.samples,
                            c.temporal ? "temporal" : "single");
        for (const double value : {q.geometry, q.depth, q.raw_geometry, q.raw_depth, q.similarity, q.flicker,
                                   q.samples, static_cast<double>(q.memory_bytes), row.gather_ms.median,
                                   row.total_ms.median, row.gather_copies.median, row.total_copies.median})
            text += cell(value);
        text += fmt::format(",{}\n", row.readings);
    }
    return text;
}

}  // namespace gloam::report
