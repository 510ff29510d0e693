// SPDX-License-Identifier: MIT
#include "cli/bench/files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "base/text.hpp"
#include "cli/arguments.hpp"
#include "experiment/table.hpp"
#include "report/image.hpp"
#include "report/plot.hpp"

namespace gloam::cli {
namespace {

namespace fs = std::filesystem;
using experiment::CaseResult;
using experiment::Experiment;
using experiment::FrontPoint;
using experiment::SizeResult;

using NamedPlots = std::vector<std::pair<std::string, report::Plot>>;  // by the files' names without suffix

// A part of a page that a command generates: the text between the lines "<!-- begin NAME -->" and "<!-- end
// NAME -->".
struct PageBlock {
    std::string name;
    std::string text;  // whole lines
};

// The position of a line that must occur exactly once.
std::size_t line_in(const std::string& page, const std::string& line) {
    const std::size_t at = page.find(line);
    if (at == std::string::npos || page.find(line, at + 1) != std::string::npos)
        throw std::invalid_argument(fmt::format("the page: expected one line \"{}\"", line));
    return at;
}

// The page with its blocks replaced. Throws std::invalid_argument with the block's name unless the page
// contains its two lines, in this order, exactly once.
std::string with_blocks(std::string page, const std::vector<PageBlock>& blocks) {
    for (const PageBlock& block : blocks) {
        const std::string begin = fmt::format("<!-- begin {} -->\n", block.name);
        const std::string end = fmt::format("<!-- end {} -->", block.name);
        const std::size_t first = line_in(page, begin) + begin.size();
        const std::size_t last = line_in(page, end);
        if (last < first)
            throw std::invalid_argument(fmt::format("the page: block {} ends before it begins", block.name));
        page.replace(first, last - first, "\n" + block.text + "\n");
    }
    return page;
}

// Blocks of a page: of the tables that have names, or one of all.
std::vector<PageBlock> blocks_of(const Experiment& what, const experiment::Text& tables,
                                 const std::string& heading) {
    std::vector<PageBlock> blocks;
    for (const experiment::Table& table : what.tables)
        if (!table.name.empty())
            blocks.push_back(
                {table.name, tables.named.contains(table.name) ? tables.named.at(table.name) : ""});
    if (blocks.empty()) blocks.push_back({what.name, heading + tables.text});
    return blocks;
}

// Groups with a point on the front are coloured, all others are grey; presets have their names.
std::vector<report::Curve> curves_of(const Experiment& what, const std::vector<FrontPoint>& points) {
    report::Curve front{.name = "Pareto front", .style = report::CurveStyle::steps};
    std::map<std::string, report::Curve> groups;
    for (const FrontPoint& point : front_of(points)) {
        const experiment::Candidate& candidate = what.candidates[point.candidate];
        front.points.emplace_back(point.ms, point.error);
        front.labels.push_back(candidate.name);
        groups[candidate.group].name = candidate.group;
    }
    report::Curve others{.name = "others", .style = report::CurveStyle::background};
    report::Curve presets{.name = "presets", .style = report::CurveStyle::points};
    for (const FrontPoint& point : points) {
        const experiment::Candidate& candidate = what.candidates[point.candidate];
        const bool preset = candidate.group == presets.name;
        const auto found = groups.find(candidate.group);
        report::Curve& curve = preset ? presets : found == groups.end() ? others : found->second;
        curve.points.emplace_back(point.ms, point.error);
        if (preset) presets.labels.push_back(candidate.name);
    }
    std::vector<report::Curve> curves{others};
    for (auto& [group, curve] : groups) curves.push_back(std::move(curve));
    curves.push_back(presets);
    curves.push_back(front);
    std::erase_if(curves, [](const report::Curve& curve) { return curve.points.empty(); });
    return curves;
}

// Error against time: in each case, and over all.
void add_fronts(NamedPlots& all, const Measured& measured, const SizeResult& result) {
    if (std::ranges::find(measured.what.tables, "front", &experiment::Table::keep) ==
        measured.what.tables.end())
        return;
    const auto add = [&](const std::string& name, const std::vector<const CaseResult*>& cases,
                         const char* error) {
        const std::vector<FrontPoint> points = front_points(cases);
        if (points.empty()) return;
        all.emplace_back(
            name, report::Plot{.title = fmt::format("{}, {}, {}", name, experiment::size_text(result.extent),
                                                    measured.record.conditions().device),
                               .x = "all passes, ms",
                               .y = error,
                               .logarithmic = true,
                               .curves = curves_of(measured.what, points)});
    };
    std::vector<const CaseResult*> cases;
    for (const CaseResult& one : result.cases) {
        cases.push_back(&one);
        add(one.shown.name, {&one}, "RMSE of the occlusion, against (G)");
    }
    add("overall", cases, "RMSE (G) over the case's best, geometric mean");
}

// Tables over frames.
void add_frames(NamedPlots& all, const Measured& measured, std::size_t size) {
    for (experiment::FramePlot& shown : frame_plots(measured.what, measured.results, size)) {
        report::Plot plot{.title = fmt::format("{}, {}", shown.name, measured.record.conditions().device),
                          .x = shown.x,
                          .y = shown.y,
                          .logarithmic = shown.logarithmic};
        for (auto& [name, points] : shown.curves)
            plot.curves.push_back({.name = name, .points = std::move(points)});
        all.emplace_back(shown.name, std::move(plot));
    }
}

// Without what leads into another folder or has to be quoted.
std::string file_name(std::string name) {
    std::erase_if(name, [](char c) { return c == ',' || c == ':' || c == '(' || c == ')'; });
    std::ranges::replace(name, ' ', '-');
    return base::file_name_of(name);
}

NamedPlots plots_of(const Measured& measured) {
    NamedPlots all;
    for (std::size_t size = 0; size < measured.results.size(); ++size) {
        const SizeResult& result = measured.results[size];
        const std::size_t first = all.size();
        add_fronts(all, measured, result);
        add_frames(all, measured, size);
        for (std::size_t i = first; i < all.size(); ++i) {
            std::string& name = all[i].first;
            if (measured.results.size() > 1) name += "-" + experiment::size_text(result.extent);
            name = file_name(std::move(name));
        }
    }
    return all;
}

std::string report_text(const Measured& measured, const std::string& heading, const NamedPlots& plots,
                        const std::string& images) {
    std::string text = fmt::format("# {}\n\n{}.\n\n{}{}\n", measured.what.name, measured.what.about, heading,
                                   measured.tables.report);
    for (const auto& [name, plot] : plots) text += fmt::format("![{0}]({1}/{0}.svg)\n", name, images);
    return text;
}

}  // namespace

std::string heading_of(const Measured& measured) {
    const experiment::Conditions& conditions = measured.record.conditions();
    std::string text = fmt::format("{} cases on {} ({})", measured.results.front().cases.size(),
                                   conditions.device, conditions.driver);
    int rounds = 0;
    for (const experiment::Visit& visit : measured.record.visits()) rounds = std::max(rounds, visit.round);
    for (const SizeResult& result : measured.results)
        text += fmt::format(",\n{} x {} pixels", result.extent.width, result.extent.height);
    text += fmt::format(", {} rounds", rounds);
    if (conditions.rays > 0)
        text += fmt::format(",\nthe last {} of {} frames, the truth of {} rays a pixel", conditions.scored,
                            conditions.frames, conditions.rays);
    return text + ".\n";
}

ExperimentFiles::ExperimentFiles(const ExperimentPaths& paths, const Experiment& what)
    : paths_(paths),
      old_page_(paths.page.empty() ? "" : read_text(paths.page)),
      json_(paths.json),
      csv_(paths.csv),
      page_(paths.page),
      report_(paths.report) {
    if (!paths.page.empty()) (void)with_blocks(old_page_, blocks_of(what, {}, ""));
    if (!paths.out.empty()) out_.emplace(paths.out);
    if (!paths.report.empty()) images_.emplace(paths.report.parent_path() / "images" / what.name);
}

void ExperimentFiles::open_journal(experiment::Record& record, bool resume) {
    if (!out_) return;
    out_->keep();  // even if the run fails, because of the journal
    journal_.emplace(out_->path() / "journal.jsonl", record.heading(), resume);
    std::size_t number = 1;
    for (const std::string& line : journal_->lines()) {
        ++number;
        try {
            record.add_line(line);
        } catch (const std::runtime_error& error) {
            throw std::runtime_error(
                fmt::format("{}, line {}: {}", journal_->path().string(), number, error.what()));
        }
    }
}

void ExperimentFiles::keep(const std::string& line) const {
    if (journal_) journal_->add(line);
}

void ExperimentFiles::show(const experiment::Picture& picture) {
    constexpr double full_error = 0.1;  // as bright as the scale goes
    const auto [width, height] = picture.extent;
    const bool error = picture.kind == "error";
    const bool part = picture.kind == "convergence" || picture.kind == "samples";
    out_->write(file_name(picture.name) + ".png",
                error || part ? base::to_heat_png(picture.values, width, height, error ? full_error : 1.0)
                              : report::to_visibility_png(picture.values, width, height));
    out_->keep();  // a run that is taken up again does not measure what the picture shows
}

void ExperimentFiles::write(const Measured& measured, const std::string& heading,
                            const std::string& versions) {
    const std::string json = to_json(measured.what, measured.results, measured.record, versions);
    const std::string csv = to_csv(measured.what, measured.results);
    json_.write(json);
    csv_.write(csv);
    if (!paths_.page.empty())
        page_.write(with_blocks(old_page_, blocks_of(measured.what, measured.tables, heading)));
    if (!out_ && !images_) return;
    const NamedPlots plots = plots_of(measured);
    for (const auto& [name, plot] : plots) {
        const std::string svg = report::to_svg(plot);
        const std::string png = report::to_png(plot);
        for (auto* folder : {&images_, &out_}) {
            if (!*folder) continue;
            (*folder)->write(name + ".svg", svg);
            (*folder)->write(name + ".png", png);
        }
    }
    if (images_) images_->keep();
    report_.write(report_text(measured, heading, plots, "images/" + measured.what.name));
    if (!out_) return;
    out_->write("results.json", json);
    out_->write("results.csv", csv);
    out_->keep();
}

}  // namespace gloam::cli
