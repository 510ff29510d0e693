// SPDX-License-Identifier: MIT
#include "cli/bench/views_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "cli/versions.hpp"

namespace gloam::cli {
namespace {

using nlohmann::ordered_json;
using scene::ViewHalf;

using Value = std::function<double(const ViewRow&)>;

// The mean over a half's views; nullopt without any.
std::optional<double> mean_over(const ViewsReport& report, ViewHalf half, const Value& value) {
    double sum = 0.0;
    int count = 0;
    for (const ViewRow& row : report.rows) {
        if (row.view.half != half) continue;
        sum += value(row);
        ++count;
    }
    if (count == 0) return std::nullopt;
    return sum / count;
}

Value error_of(std::size_t candidate) {
    return [candidate](const ViewRow& row) { return row.cells.at(candidate).quality.geometry; };
}

// The geometric mean of the times over all views, in copies; nullopt if nothing was timed.
std::optional<double> copies_of(const ViewsReport& report, std::size_t candidate) {
    double sum = 0.0;
    for (const ViewRow& row : report.rows) {
        if (!row.cells.at(candidate).copies) return std::nullopt;
        sum += std::log(*row.cells.at(candidate).copies);
    }
    return std::exp(sum / static_cast<double>(report.rows.size()));
}

std::optional<double> mean_flicker(const ViewsReport& report, std::size_t candidate) {
    double sum = 0.0;
    for (const ViewRow& row : report.rows) {
        if (!row.cells.at(candidate).quality.flicker) return std::nullopt;
        sum += *row.cells.at(candidate).quality.flicker;
    }
    return sum / static_cast<double>(report.rows.size());
}

std::string text_or_dash(const std::optional<double>& value, int digits) {
    return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

std::string ratio_text(const std::optional<double>& value, const std::optional<double>& of) {
    return value && of ? fmt::format("{:.2f}", *value / *of) : "-";
}

// A row of the table of means.
std::string mean_row(const ViewsReport& report, const std::string& name, const Value& value,
                     const std::string& copies, const std::string& flicker) {
    const auto tuning = mean_over(report, ViewHalf::tuning, value);
    const auto unseen = mean_over(report, ViewHalf::unseen, value);
    return fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", name, text_or_dash(tuning, 4),
                       text_or_dash(unseen, 4),
                       ratio_text(tuning, mean_over(report, ViewHalf::tuning, error_of(0))),
                       ratio_text(unseen, mean_over(report, ViewHalf::unseen, error_of(0))), copies, flicker);
}

std::string means_text(const ViewsReport& report) {
    std::string text = fmt::format(
        "| mean RMSE (G) | tuning half | unseen half | of {0}: tuning | unseen | copies | flicker |\n"
        "|---|--:|--:|--:|--:|--:|--:|\n",
        report.candidates.front().name);
    for (std::size_t i = 0; i < report.candidates.size(); ++i)
        text += mean_row(report, report.candidates[i].name, error_of(i),
                         text_or_dash(copies_of(report, i), 1), text_or_dash(mean_flicker(report, i), 4));
    if (!report.rows.empty() && !report.rows.front().depth_truth) return text;
    return text + mean_row(
                      report, "the depth buffer's truth (D)",
                      [](const ViewRow& row) { return row.depth_truth.value(); }, "-", "-");
}

// The head of a table with a column for each candidate after some others.
std::string head_text(const ViewsReport& report, std::string head, std::string rule) {
    for (const ViewCandidate& candidate : report.candidates) {
        head += fmt::format(" {} |", candidate.name);
        rule += "--:|";
    }
    return head + "\n" + rule + "\n";
}

// The means of each kind of view, over the views of both halves that were measured.
std::string kinds_text(const ViewsReport& report) {
    std::vector<std::string> kinds;
    for (const ViewRow& row : report.rows)
        if (std::ranges::count(kinds, row.view.kind) == 0) kinds.push_back(row.view.kind);
    std::string text = head_text(report, "| kind | views |", "|---|--:|");
    for (const std::string& kind : kinds) {
        const auto count =
            std::ranges::count_if(report.rows, [&](const ViewRow& row) { return row.view.kind == kind; });
        text += fmt::format("| {} | {} |", kind, count);
        for (std::size_t i = 0; i < report.candidates.size(); ++i) {
            double sum = 0.0;
            for (const ViewRow& row : report.rows)
                if (row.view.kind == kind) sum += row.cells[i].quality.geometry;
            text += fmt::format(" {:.4f} |", sum / static_cast<double>(count));
        }
        text += "\n";
    }
    return text;
}

std::string rows_text(const ViewsReport& report) {
    std::string text = head_text(report, "| view | kind | half | (D) |", "|---|---|---|--:|");
    for (const ViewRow& row : report.rows) {
        text += fmt::format("| {} | {} | {} | {} |", row.view.name, row.view.kind,
                            scene::name_of(row.view.half), text_or_dash(row.depth_truth, 4));
        for (const ViewCell& cell : row.cells) text += fmt::format(" {:.4f} |", cell.quality.geometry);
        text += "\n";
    }
    return text;
}

ordered_json json_of(const std::optional<double>& value) {
    return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json json_of_row(const ViewsReport& report, const ViewRow& row) {
    ordered_json json{{"view", row.view.name},
                      {"kind", row.view.kind},
                      {"half", scene::name_of(row.view.half)},
                      {"rmse_depth_truth", json_of(row.depth_truth)},
                      {"results", ordered_json::array()}};
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
        const ViewCell& cell = row.cells[i];
        json["results"].push_back({{"candidate", report.candidates[i].name},
                                   {"rmse_geometry", cell.quality.geometry},
                                   {"rmse_geometry_raw", cell.quality.raw_geometry},
                                   {"rmse_depth", cell.quality.depth},
                                   {"bias", cell.quality.bias},
                                   {"flicker", json_of(cell.quality.flicker)},
                                   {"samples", cell.quality.samples},
                                   {"copies", json_of(cell.copies)}});
    }
    return json;
}

}  // namespace

std::string to_text(const ViewsReport& report, const BenchViewsOptions& options) {
    return fmt::format(
               "{} views on {} ({}), {} x {} pixels, the last {} of {} frames, the truth of {} rays a "
               "pixel.\n\n",
               report.rows.size(), report.device.name, report.device.driver, report.extent.width,
               report.extent.height, options.scored, options.frames, options.rays) +
           means_text(report) + "\n" + kinds_text(report) + "\n" + rows_text(report);
}

std::string to_json(const ViewsReport& report, const BenchViewsOptions& options) {
    ordered_json document{{"versions", versions()},         {"device", report.device.name},
                          {"driver", report.device.driver}, {"width", report.extent.width},
                          {"height", report.extent.height}, {"frames", options.frames},
                          {"scored", options.scored},       {"rays", options.rays},
                          {"rounds", options.rounds},       {"views", ordered_json::array()}};
    for (const ViewRow& row : report.rows) document["views"].push_back(json_of_row(report, row));
    return document.dump(2) + "\n";
}

}  // namespace gloam::cli
