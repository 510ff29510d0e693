// SPDX-License-Identifier: MIT
#include "cli/bench/front_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/versions.hpp"

namespace gloam::cli {
namespace {

using nlohmann::ordered_json;

std::string size_text(const FrontSize& size) {
    return fmt::format("{} x {}", size.extent.width, size.extent.height);
}

std::string means_text(const FrontReport& report) {
    std::string text = "| run |";
    std::string rule = "\n|---|";
    for (const FrontSize& size : report.sizes) {
        text += fmt::format(" {}: RMSE (G) | of the first | copies | flicker |", size_text(size));
        rule += "--:|--:|--:|--:|";
    }
    text += rule + "\n";
    for (std::size_t run = 0; run < report.runs.size(); ++run) {
        text += fmt::format("| {} |", report.runs[run].name);
        for (const FrontSize& size : report.sizes) {
            const FrontCell mean = mean_of(size, run);
            const char* mark = on_front(size, run) ? "**" : "";
            text += fmt::format(" {0}{1:.4f}{0} | {2:.2f} | {0}{3:.1f}{0} | {4} |", mark, mean.rmse,
                                mean.rmse / mean_of(size, 0).rmse, mean.copies,
                                mean.flicker ? fmt::format("{:.4f}", *mean.flicker) : "-");
        }
        text += "\n";
    }
    return text;
}

// The views of one kind.
FrontSize of_kind(const FrontSize& size, const std::string& kind) {
    FrontSize part{.extent = size.extent, .rows = size.rows};
    std::erase_if(part.rows, [&](const FrontRow& row) { return row.view.kind != kind; });
    return part;
}

std::vector<std::string> kinds_of(const FrontSize& size) {
    std::vector<std::string> kinds;
    for (const FrontRow& row : size.rows)
        if (std::ranges::count(kinds, row.view.kind) == 0) kinds.push_back(row.view.kind);
    return kinds;
}

std::string kinds_text(const FrontReport& report, const FrontSize& size) {
    std::string text = fmt::format("| RMSE (G), {} |", size_text(size));
    std::string rule = "\n|---|";
    std::vector<FrontSize> parts;
    for (const std::string& kind : kinds_of(size)) {
        parts.push_back(of_kind(size, kind));
        text += fmt::format(" {} ({}) |", kind, parts.back().rows.size());
        rule += "--:|";
    }
    text += rule + "\n";
    for (std::size_t run = 0; run < report.runs.size(); ++run) {
        text += fmt::format("| {} |", report.runs[run].name);
        for (const FrontSize& part : parts) text += fmt::format(" {:.4f} |", mean_of(part, run).rmse);
        text += "\n";
    }
    return text;
}

ordered_json json_of(const FrontReport& report, const FrontRow& row) {
    ordered_json json{{"view", row.view.name}, {"kind", row.view.kind}, {"runs", ordered_json::array()}};
    for (std::size_t run = 0; run < report.runs.size(); ++run) {
        const FrontCell& cell = row.cells[run];
        json["runs"].push_back(
            {{"run", report.runs[run].name},
             {"rmse_geometry", cell.rmse},
             {"copies", cell.copies},
             {"flicker", cell.flicker ? ordered_json(*cell.flicker) : ordered_json(nullptr)}});
    }
    return json;
}

}  // namespace

FrontCell mean_of(const FrontSize& size, std::size_t run) {
    FrontCell mean{.rmse = 0.0, .copies = 0.0, .flicker = 0.0};
    for (const FrontRow& row : size.rows) {
        const FrontCell& cell = row.cells.at(run);
        mean.rmse += cell.rmse;
        mean.copies += std::log(cell.copies);
        mean.flicker =
            mean.flicker && cell.flicker ? std::optional(*mean.flicker + *cell.flicker) : std::nullopt;
    }
    const auto views = static_cast<double>(size.rows.size());
    mean.rmse /= views;
    mean.copies = std::exp(mean.copies / views);
    if (mean.flicker) *mean.flicker /= views;
    return mean;
}

bool on_front(const FrontSize& size, std::size_t run) {
    const FrontCell own = mean_of(size, run);
    for (std::size_t other = 0; other < size.rows.front().cells.size(); ++other) {
        const FrontCell mean = mean_of(size, other);
        if (mean.rmse < own.rmse && mean.copies < own.copies) return false;
    }
    return true;
}

std::string to_text(const FrontReport& report) {
    std::string text = fmt::format(
        "{} views on {} ({}),\nthe last {} of {} frames, the truth of {} rays a pixel.\n"
        "In bold: what no other run beats in both error and time.\n\n",
        report.sizes.front().rows.size(), report.device.name, report.device.driver, report.scored,
        report.frames, report.rays);
    text += means_text(report);
    for (const FrontSize& size : report.sizes) text += "\n" + kinds_text(report, size);
    return text;
}

std::string to_json(const FrontReport& report) {
    ordered_json document{{"versions", versions()},         {"device", report.device.name},
                          {"driver", report.device.driver}, {"frames", report.frames},
                          {"scored", report.scored},        {"rays", report.rays},
                          {"sizes", ordered_json::array()}};
    for (const FrontSize& size : report.sizes) {
        ordered_json json{
            {"width", size.extent.width}, {"height", size.extent.height}, {"views", ordered_json::array()}};
        for (const FrontRow& row : size.rows) json["views"].push_back(json_of(report, row));
        document["sizes"].push_back(json);
    }
    return document.dump(2) + "\n";
}

}  // namespace gloam::cli
