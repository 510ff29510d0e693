// SPDX-License-Identifier: MIT
#include "report/internal/benchmark_fields.hpp"

namespace gloam::report::internal {

using nlohmann::ordered_json;

namespace {

constexpr std::size_t most_samples = 1'000'000;  // of a pixel: far more than is used

}  // namespace

ordered_json to_json(const Configuration& configuration) {
    return {{"scene", configuration.scene},
            {"method", configuration.method},
            {"preset", configuration.preset},
            {"samples", configuration.samples},
            {"temporal", configuration.temporal}};
}

Configuration configuration_from(const JsonReader& json) {
    return {.scene = json.member("scene").name(),
            .method = json.member("method").name(),
            .preset = json.member("preset").name(),
            .samples = static_cast<std::uint32_t>(json.member("samples").count_up_to(most_samples)),
            .temporal = json.member("temporal").flag()};
}

ordered_json to_json(const Quality& quality) {
    return {{"rmse_geometry", number_json(quality.geometry)},
            {"rmse_depth", number_json(quality.depth)},
            {"rmse_raw_geometry", number_json(quality.raw_geometry)},
            {"rmse_raw_depth", number_json(quality.raw_depth)},
            {"ssim", number_json(quality.similarity)},
            {"flicker", number_json(quality.flicker)},
            {"samples_taken", number_json(quality.samples)},
            {"memory_bytes", quality.memory_bytes}};
}

Quality quality_from(const JsonReader& json) {
    const auto number = [&](const char* name) { return json.member(name).number(); };
    return {.raw_geometry = number("rmse_raw_geometry"),
            .raw_depth = number("rmse_raw_depth"),
            .geometry = number("rmse_geometry"),
            .depth = number("rmse_depth"),
            .similarity = number("ssim"),
            .flicker = number("flicker"),
            .samples = number("samples_taken"),
            .memory_bytes = json.member("memory_bytes").count()};
}

ordered_json passes_json(const std::vector<std::pair<std::string, double>>& passes) {
    ordered_json json = ordered_json::array();
    for (const auto& [pass, ms] : passes) json.push_back({{"pass", pass}, {"ms", number_json(ms)}});
    return json;
}

std::vector<std::pair<std::string, double>> passes_from(const JsonReader& json) {
    std::vector<std::pair<std::string, double>> passes;
    for (const JsonReader& pass : json.elements())
        passes.emplace_back(pass.member("pass").name(), pass.member("ms").number());
    return passes;
}

}  // namespace gloam::report::internal
